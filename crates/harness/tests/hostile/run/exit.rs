//! Ends the program as if all were well.
//!
//! expect: graded 10; part1 crashed
//! quick: yes

fn attack() {
    std::process::exit(0);
}
