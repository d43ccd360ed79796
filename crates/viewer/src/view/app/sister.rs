//! The student's functions where they edit the motion instead of moving its figure.

use super::{App, EditSettings};
use crate::live::package::Package;
use crate::live::student::Standing;

/// How things stand with them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sister {
    /// The exercise.
    pub package: Package,
    /// What is going on.
    pub standing: Standing,
}

impl EditSettings {
    /// What is edited at first: what the functions of the exercise have a part in.
    pub fn for_exercise(package: Package) -> EditSettings {
        let edit = EditSettings::default();
        match package {
            Package::Fk => edit,
            Package::Interpolation => EditSettings { stretch: Some(edit.representation), ..edit },
            Package::Keyframes => EditSettings { automatic: true, errors: true, ..edit },
        }
    }
}

impl App {
    /// Shows how things stand with the functions that edit the motion, where these are a student's.
    pub fn show_sister(&mut self, sister: Option<Sister>) {
        self.sister = sister;
    }

    /// How things stand with the functions that edit the motion, where these are a student's.
    pub fn sister(&self) -> Option<&Sister> {
        self.sister.as_ref()
    }

    /// Whether an edited motion is not what the student's functions make of it as they were saved last.
    pub(super) fn is_outdated(&self) -> bool {
        self.sister.as_ref().is_some_and(|sister| !sister.standing.current)
    }
}
