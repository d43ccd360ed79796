//! Starts as many threads as it can get. All of them stay.
//!
//! expect: graded

fn attack() {
    for _ in 0..10_000 {
        let wait = || {
            loop {
                std::thread::park();
            }
        };
        if std::thread::Builder::new().stack_size(16 * 1024).spawn(wait).is_err() {
            return;
        }
    }
}
