//! The exercises that can be marked.

use grading::{Exam, Rubric, Solutions};

/// What the harness knows of an exercise.
#[derive(Debug)]
pub struct Exercise {
    /// The package's name, for example `fk`.
    pub name: &'static str,
    /// The file that students hand in.
    pub file: &'static str,
    /// The fixed part of the package that the file is a module of.
    pub library: &'static str,
    /// The file as it was handed out.
    pub template: &'static str,
    /// What its parts are worth.
    pub rubric: &'static Rubric,
    /// Whether its functions pose a figure, so that one pose can be drawn for the report.
    pub has_poses: bool,
    /// The questions of a seed, with the right answers.
    pub exam: fn(u64) -> Exam,
}

/// All exercises.
pub static EXERCISES: [Exercise; 5] = [
    Exercise {
        name: "fk",
        file: "fk.rs",
        library: include_str!("../../../exercises/fk/src/lib.rs"),
        template: include_str!("../../../solutions/templates/fk.rs"),
        rubric: &grading::fk::RUBRIC,
        has_poses: true,
        exam: |seed| grading::fk::exam(seed, &Solutions),
    },
    Exercise {
        name: "interpolation",
        file: "interpolation.rs",
        library: include_str!("../../../exercises/interpolation/src/lib.rs"),
        template: include_str!("../../../solutions/templates/interpolation.rs"),
        rubric: &grading::interpolation::RUBRIC,
        has_poses: false,
        exam: |seed| grading::interpolation::exam(seed, &Solutions),
    },
    Exercise {
        name: "keyframes",
        file: "keyframes.rs",
        library: include_str!("../../../exercises/keyframes/src/lib.rs"),
        template: include_str!("../../../solutions/templates/keyframes.rs"),
        rubric: &grading::keyframes::RUBRIC,
        has_poses: false,
        exam: |seed| grading::keyframes::exam(seed, &Solutions),
    },
    Exercise {
        name: "acclaim",
        file: "acclaim.rs",
        library: include_str!("../../../exercises/acclaim/src/lib.rs"),
        template: include_str!("../../../solutions/templates/acclaim.rs"),
        rubric: &grading::acclaim::RUBRIC,
        has_poses: false,
        exam: |seed| grading::acclaim::exam(seed, &Solutions),
    },
    Exercise {
        name: "time-warp",
        file: "time_warp.rs",
        library: include_str!("../../../exercises/time-warp/src/lib.rs"),
        template: include_str!("../../../solutions/templates/time_warp.rs"),
        rubric: &grading::time_warp::RUBRIC,
        has_poses: false,
        exam: |seed| grading::time_warp::exam(seed, &Solutions),
    },
];

impl Exercise {
    /// The exercise of this name.
    pub fn named(name: &str) -> Option<&'static Exercise> {
        EXERCISES.iter().find(|exercise| exercise.name == name)
    }

    /// The package's name as Rust writes it.
    pub fn crate_name(&self) -> String {
        self.name.replace('-', "_")
    }

    /// Where the student's file lies, from the workspace's folder on. The compiler's messages name it so.
    pub fn path(&self) -> String {
        format!("exercises/{}/src/{}", self.name, self.file)
    }

    /// Where the fixed part lies.
    pub fn library_path(&self) -> String {
        format!("exercises/{}/src/lib.rs", self.name)
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
        let graded: Vec<&str> = grading::EXERCISES.iter().map(|graded| graded.rubric.exercise).collect();
        let marked: Vec<&str> = EXERCISES.iter().map(|marked| marked.name).collect();
        assert_eq!(marked, graded);
        for exercise in &EXERCISES {
            let Exercise { name, file, rubric, exam, .. } = exercise;
            assert_eq!((rubric.exercise, exam(1).rubric.exercise), (*name, *name));
            assert_eq!(*file, format!("{}.rs", exercise.crate_name()));
        }
    }
}
