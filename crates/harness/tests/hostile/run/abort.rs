//! Ends the program as a crash.
//!
//! expect: graded 10; part1 crashed
//! quick: yes

fn attack() {
    std::process::abort();
}
