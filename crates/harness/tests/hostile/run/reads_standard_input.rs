//! Reads the questions itself. The lock on them is taken.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    let mut question = String::new();
    let _ = std::io::stdin().read_line(&mut question);
    panic!("{question}");
}
