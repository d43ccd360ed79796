//! Answers, and ends the program from a thread that waits for the next question but one.
//!
//! expect: graded

fn attack() {
    let _ = std::thread::Builder::new().spawn(|| {
        std::thread::sleep(std::time::Duration::from_millis(1));
        std::process::exit(0);
    });
}
