//! The exercises that can be graded.

use exam::Functions;

use crate::{Exam, Misconception, Reference, Rubric, acclaim, fk, interpolation, keyframes, time_warp};

/// What is known of an exercise before anything is asked.
#[derive(Debug)]
pub struct Exercise {
    /// What its parts are worth.
    pub rubric: &'static Rubric,
    /// The questions of a seed, with the right answers.
    pub exam: fn(u64, &dyn Reference) -> Exam,
    /// The misconceptions of one part, by its id.
    pub misconceptions: fn(&str) -> Vec<Misconception>,
}

/// All exercises, in the order of the course.
pub static EXERCISES: [Exercise; 5] = [
    Exercise { rubric: &fk::RUBRIC, exam: fk::exam, misconceptions: fk::misconceptions },
    Exercise {
        rubric: &interpolation::RUBRIC,
        exam: interpolation::exam,
        misconceptions: interpolation::misconceptions,
    },
    Exercise { rubric: &keyframes::RUBRIC, exam: keyframes::exam, misconceptions: keyframes::misconceptions },
    Exercise { rubric: &acclaim::RUBRIC, exam: acclaim::exam, misconceptions: acclaim::misconceptions },
    Exercise { rubric: &time_warp::RUBRIC, exam: time_warp::exam, misconceptions: time_warp::misconceptions },
];

impl Exercise {
    /// The exercise that these functions belong to.
    pub fn of(functions: &Functions) -> &'static Exercise {
        match functions {
            Functions::Fk(_) => &EXERCISES[0],
            Functions::Interpolation(_) => &EXERCISES[1],
            Functions::Keyframes { .. } => &EXERCISES[2],
            Functions::Acclaim(_) => &EXERCISES[3],
            Functions::TimeWarp(_) => &EXERCISES[4],
        }
    }

    /// The exercise of this name, for example `fk`.
    pub fn named(name: &str) -> Option<&'static Exercise> {
        EXERCISES.iter().find(|exercise| exercise.rubric.exercise == name)
    }
}
