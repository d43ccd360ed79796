//! Makes any system call from safe Rust, by a hole in the compiler: here a harmless one, which shows that it works.
//!
//! with: system_calls
//! expect: graded 10; part1 panicked "I am"
//! quick: yes

fn attack() {
    let own = system_call(39, [0; 3]);
    panic!("I am {own}");
}
