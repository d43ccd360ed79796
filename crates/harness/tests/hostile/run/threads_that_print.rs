//! Answers, while a thread of its own prints without end, also into the middle of the answers.
//!
//! expect: graded

static ONCE: std::sync::Once = std::sync::Once::new();

fn attack() {
    ONCE.call_once(|| {
        let _ = std::thread::Builder::new().spawn(|| {
            loop {
                println!("\0\0\0\0 and so on");
            }
        });
    });
}
