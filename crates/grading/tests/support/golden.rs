//! Comparing a scoreboard with the expected text.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::time::Duration;
use std::{env, fs};

use exam::{Answer, Failure, Functions, InProcess, Question, Subject};
use grading::{Exercise, Graded, PUBLIC_SEED, Solutions};

/// Counts how often it was to forget everything.
struct Restarted(InProcess, usize);

impl Subject for Restarted {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        self.0.ask(question, limit)
    }

    fn restart(&mut self) {
        self.1 += 1;
    }
}

/// The scoreboard of these functions is the text `golden/NAME.txt`.
pub fn check(name: &str, functions: Functions) {
    let exam = (Exercise::of(&functions).exam)(PUBLIC_SEED, &Solutions);
    let mut subject = Restarted(InProcess(functions), 0);
    let graded = Graded::ask(&mut subject, &exam, grading::CHECK_LIMIT);
    assert_eq!(
        subject.1,
        exam.parts.len() + 1,
        "every part, and the whole motion, meets functions that keep nothing"
    );
    let scoreboard = graded.scoreboard(&exam);
    let styled = scoreboard.to_string();
    assert!(styled.ends_with(&scoreboard.summary().to_string()));
    for row in scoreboard.rows() {
        assert!(styled.contains(&format!("\n  {row}\n")), "{row}");
        assert!(row.named.iter().all(|named| styled.contains(named.title)), "{row}");
    }
    assert!(styled.contains(&scoreboard.verdict()) && scoreboard.verdict().ends_with(" of 15 points."));
    let plain = anstream::adapter::strip_str(&styled).to_string();
    assert!(plain.lines().all(|line| line.chars().count() <= 110), "{plain}");

    let path = format!("{}/tests/golden/{name}.txt", env!("CARGO_MANIFEST_DIR"));
    // Where a function panics depends on this file's lines.
    let places = plain.split_whitespace().filter(|word| word.contains("scoreboard.rs:"));
    let plain = places.fold(plain.clone(), |text, place| text.replace(place, "FILE:LINE:COLUMN:"));
    if env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(&path, &plain).unwrap();
    }
    let expected = fs::read_to_string(&path).unwrap();
    assert_eq!(plain, expected, "{path}");
}
