//! Answers, while threads of its own go on computing.
//!
//! expect: graded 15
//! quick: yes

static ONCE: std::sync::Once = std::sync::Once::new();

fn attack() {
    ONCE.call_once(|| {
        for _ in 0..4 {
            let _ = std::thread::Builder::new().spawn(|| {
                loop {
                    std::hint::spin_loop();
                }
            });
        }
    });
}
