//! The exercises that can be marked.

use grading::{Exam, Rubric, Solutions};
use submissions::Wanted;

use crate::Error;
use crate::picture::Portrait;

/// What the harness knows of an exercise.
#[derive(Debug)]
pub struct Exercise {
    /// How it is graded.
    graded: &'static grading::Exercise,
    /// The fixed part of the package that the student's file is a module of.
    pub library: &'static str,
    /// The student's file as it was handed out.
    pub template: &'static str,
    /// What is drawn for the report, where the functions pose a figure.
    pub portrait: Option<fn() -> Result<Portrait, Error>>,
}

/// All exercises, in the order of [`grading::EXERCISES`].
pub static EXERCISES: [Exercise; 5] = [
    Exercise {
        graded: &grading::EXERCISES[0],
        library: include_str!("../../../exercises/fk/src/lib.rs"),
        template: include_str!("../../../solutions/templates/fk.rs"),
        portrait: Some(Portrait::of_joints),
    },
    Exercise {
        graded: &grading::EXERCISES[1],
        library: include_str!("../../../exercises/interpolation/src/lib.rs"),
        template: include_str!("../../../solutions/templates/interpolation.rs"),
        portrait: None,
    },
    Exercise {
        graded: &grading::EXERCISES[2],
        library: include_str!("../../../exercises/keyframes/src/lib.rs"),
        template: include_str!("../../../solutions/templates/keyframes.rs"),
        portrait: None,
    },
    Exercise {
        graded: &grading::EXERCISES[3],
        library: include_str!("../../../exercises/acclaim/src/lib.rs"),
        template: include_str!("../../../solutions/templates/acclaim.rs"),
        portrait: Some(Portrait::of_bones),
    },
    Exercise {
        graded: &grading::EXERCISES[4],
        library: include_str!("../../../exercises/time-warp/src/lib.rs"),
        template: include_str!("../../../solutions/templates/time_warp.rs"),
        portrait: None,
    },
];

impl Exercise {
    /// The exercise of this name.
    pub fn named(name: &str) -> Option<&'static Exercise> {
        EXERCISES.iter().find(|exercise| exercise.name() == name)
    }

    /// The package's name, for example `fk`.
    pub fn name(&self) -> &'static str {
        self.rubric().exercise
    }

    /// What its parts are worth.
    pub fn rubric(&self) -> &'static Rubric {
        self.graded.rubric
    }

    /// The questions of a seed, with the right answers.
    pub fn exam(&self, seed: u64) -> Exam {
        (self.graded.exam)(seed, &Solutions)
    }

    /// The package's name as Rust writes it.
    pub fn crate_name(&self) -> String {
        self.name().replace('-', "_")
    }

    /// The file that students hand in.
    pub fn file(&self) -> String {
        format!("{}.rs", self.crate_name())
    }

    /// The same, for those who look for it in what was handed in.
    pub fn wanted(&self) -> Wanted {
        Wanted { file_name: self.file(), home: self.path() }
    }

    /// Where the student's file lies, from the workspace's folder on. The compiler's messages name it so.
    pub fn path(&self) -> String {
        format!("exercises/{}/src/{}", self.name(), self.file())
    }

    /// Where the fixed part lies.
    pub fn library_path(&self) -> String {
        format!("exercises/{}/src/lib.rs", self.name())
    }

    /// The worker's program: the exercise's library as students have it, and a main function. The student's file stays
    /// the same module of the same crate, so that what compiles in self-grading does so here.
    pub fn worker(&self) -> String {
        format!("{}\nfn main() {{ exam::worker::serve(FUNCTIONS) }}\n", self.library)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_exercise_that_can_be_graded_can_be_marked() {
        assert_eq!(EXERCISES.len(), grading::EXERCISES.len());
        for (exercise, graded) in EXERCISES.iter().zip(&grading::EXERCISES) {
            let name = exercise.name();
            assert_eq!((name, exercise.exam(1).rubric.exercise), (graded.rubric.exercise, name));
            let names_its_file = format!("yours is `{}`.", exercise.file());
            assert!(exercise.library.contains(&names_its_file), "{name}: another package's library");
            for part in exercise.rubric().parts {
                let signature = format!("pub fn {}(", part.function);
                assert!(exercise.template.contains(&signature), "{name}: another package's template");
            }
        }
    }
}
