//! Lets a thread of its own panic, and waits for it.
//!
//! expect: graded 15

fn attack() {
    let _ = std::thread::Builder::new().spawn(|| panic!("alone")).map(|thread| thread.join());
}
