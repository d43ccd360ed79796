//! Leaves a thread behind that reads the questions by a second descriptor. It steals them from itself.
//!
//! expect: graded

use std::io::Read;
use std::os::fd::AsFd;

static ONCE: std::sync::Once = std::sync::Once::new();

fn attack() {
    ONCE.call_once(|| {
        let Ok(descriptor) = std::io::stdin().as_fd().try_clone_to_owned() else { return };
        let mut questions = std::fs::File::from(descriptor);
        let _ = std::thread::Builder::new().spawn(move || {
            let mut question = [0; 1 << 16];
            while questions.read(&mut question).is_ok_and(|count| count > 0) {}
        });
    });
}
