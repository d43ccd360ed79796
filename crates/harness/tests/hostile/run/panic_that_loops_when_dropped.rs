//! Panics with something that never ends when the panic is over.
//!
//! expect: graded 10; part1 panicked

struct Trap;
impl Drop for Trap {
    fn drop(&mut self) {
        loop {
            std::hint::spin_loop();
        }
    }
}
fn attack() {
    std::panic::panic_any(Trap);
}
