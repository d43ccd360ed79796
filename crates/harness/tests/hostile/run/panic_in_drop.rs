//! Panics while something goes out of scope.
//!
//! expect: graded 10; part1 panicked

struct Last;
impl Drop for Last {
    fn drop(&mut self) {
        panic!("not without me");
    }
}
fn attack() {
    let _last = Last;
}
