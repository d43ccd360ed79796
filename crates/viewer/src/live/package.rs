//! The packages of the exercises: what is built, what is watched, and what the student's file is called.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use grading::{EXERCISES, Exercise};

use super::mover::Mover;

/// An exercise that the viewer can show, as a package of the workspace: one file of the student's, and a program that answers
/// for its functions. The order is that of [`EXERCISES`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Package {
    /// Forward kinematics: your functions move the figure
    #[default]
    Fk,
    /// Interpolation: your functions make the frames between keyframes
    Interpolation,
    /// Keyframes: your functions choose which frames stay
    Keyframes,
    /// Acclaim forward kinematics: your functions move the bones
    Acclaim,
    /// Time warping: your functions make the motion slower or faster
    TimeWarp,
}

impl Package {
    /// The exercise as one whose functions pose figures by themselves; `None` for those that have a part in editing a motion.
    pub fn mover(self) -> Option<Mover> {
        match self {
            Package::Fk => Some(Mover::Fk),
            Package::Acclaim => Some(Mover::Acclaim),
            Package::TimeWarp => Some(Mover::TimeWarp),
            Package::Interpolation | Package::Keyframes => None,
        }
    }

    /// What is known of the exercise before anything is asked.
    pub fn exercise(self) -> &'static Exercise {
        &EXERCISES[self as usize]
    }

    /// The name of the package and of the exercise: `fk`.
    pub fn name(self) -> &'static str {
        self.exercise().rubric.exercise
    }

    /// The program that answers for the functions: `fk-worker`.
    pub fn worker(self) -> String {
        format!("{}-worker", self.name())
    }

    /// The student's file, which is called like a module: `fk.rs`.
    pub fn file(self) -> String {
        format!("{}.rs", self.name().replace('-', "_"))
    }

    /// The folder of the package's sources in the workspace in the folder `workspace`.
    pub fn sources(self, workspace: &Path) -> PathBuf {
        workspace.join("exercises").join(self.name()).join("src")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_exercise_that_can_be_shown_is_a_package_of_its_name() {
        assert_eq!(Package::value_variants().len(), EXERCISES.len());
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for package in Package::value_variants() {
            assert!(package.mover().is_none_or(|mover| mover.package() == *package));
            let value = package.to_possible_value().unwrap();
            assert_eq!(value.get_name(), package.name());
            let sources = package.sources(&workspace);
            assert!(sources.join(package.file()).is_file(), "{}", sources.display());
            assert!(workspace.join("solutions/templates").join(package.file()).is_file());
            let manifest = std::fs::read_to_string(sources.join("../Cargo.toml")).unwrap();
            assert!(manifest.contains(&format!("name = \"{}\"", package.worker())));
        }
    }
}
