//! Waits for a lock that it holds itself.
//!
//! expect: graded 10; part1 timed-out | graded 10; part1 panicked

static LOCK: std::sync::Mutex<u8> = std::sync::Mutex::new(0);

fn attack() {
    let first = LOCK.lock();
    let second = LOCK.lock();
    drop((first, second));
}
