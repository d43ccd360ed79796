//! Makes system calls by the numbers of the 32-bit programs of 64-bit machines.
//!
//! with: system_calls
//! expect: graded 15 | graded 10; part1 crashed

fn attack() {
    let own = system_call(0x4000_0000 + 39, [0; 3]);
    if own > 0 {
        panic!("I am {own}");
    }
}
