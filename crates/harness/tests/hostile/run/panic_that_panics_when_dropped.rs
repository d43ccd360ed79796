//! Panics with something that panics in turn when the panic is over.
//!
//! expect: graded 10; part1 panicked

struct Bomb;
impl Drop for Bomb {
    fn drop(&mut self) {
        panic!("again");
    }
}
fn attack() {
    std::panic::panic_any(Bomb);
}
