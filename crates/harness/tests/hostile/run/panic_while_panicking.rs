//! Panics while it panics, which ends the program.
//!
//! expect: graded 10; part1 crashed

struct Last;
impl Drop for Last {
    fn drop(&mut self) {
        panic!("not without me");
    }
}
fn attack() {
    let _last = Last;
    panic!("first");
}
