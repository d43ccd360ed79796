//! The points of one saved state, in the words of `cargo test`.

use std::sync::OnceLock;
use std::time::Duration;

use exam::Subject;
use grading::scoreboard::{Row, Scoreboard};
use grading::{EXERCISES, Exam, Graded, PUBLIC_SEED, Solutions};

use crate::live::package::Package;

/// The points, for the window and for the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Board {
    /// The sum in words: `Forward kinematics: 7 of 15 points.`
    pub title: String,
    /// One row per part.
    pub rows: Vec<BoardRow>,
    /// The points that were made.
    pub points: u32,
    /// The points that could be made.
    pub of: u32,
    /// All that `cargo test` says, with escape sequences for colours.
    pub text: String,
    /// Its end: the rows and the sum.
    pub summary: String,
}

/// The points of one part: its title, the state in words, the misconceptions with their titles and hints.
pub type BoardRow = Row;

/// The text for those who see it run already.
fn seen(text: &str, scoreboard: &Scoreboard) -> String {
    text.replace(&scoreboard.well_done(), " Well done.")
}

/// How long a check may take. Nobody looks at a window as long as at a test, and right functions take a thousandth of it.
const LIMIT: Duration = Duration::from_secs(2);

impl Board {
    /// Puts the questions of the exercise that students see to `subject`. Takes as long as it needs, or as the limits for
    /// checks allow.
    pub fn of(subject: &mut dyn Subject, package: Package) -> Board {
        static EXAMS: [OnceLock<Exam>; EXERCISES.len()] = [const { OnceLock::new() }; EXERCISES.len()];
        let exam = EXAMS[package as usize].get_or_init(|| (package.exercise().exam)(PUBLIC_SEED, &Solutions));
        Board::new(&Graded::ask(subject, exam, LIMIT).scoreboard(exam))
    }

    /// What `scoreboard` says.
    pub fn new(scoreboard: &Scoreboard) -> Board {
        let (points, of) = scoreboard.points();
        Board {
            title: scoreboard.verdict(),
            rows: scoreboard.rows(),
            points,
            of,
            text: seen(&scoreboard.to_string(), scoreboard),
            summary: seen(&scoreboard.summary().to_string(), scoreboard),
        }
    }

    /// What to print after the board `before` was printed: all, or only the rows when they are the same.
    pub fn news_since(&self, before: Option<&Board>) -> &str {
        match before {
            Some(before) if before.rows == self.rows => &self.summary,
            _ => &self.text,
        }
    }
}
