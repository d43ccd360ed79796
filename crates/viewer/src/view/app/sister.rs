//! The student's functions where they edit the motion instead of moving its figure.

use super::{App, EditSettings};
use crate::live::package::Package;
use crate::live::student::{Standing, Status};

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
            Package::Interpolation => EditSettings { stretch: Some(edit.representation), ..edit },
            Package::Keyframes => EditSettings { automatic: true, errors: true, ..edit },
            // Those that pose figures have no part in it.
            _ => edit,
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

    /// Whether the edited motion is not what the student's functions make of it as they were saved last.
    pub fn is_outdated(&self) -> bool {
        let Some(sister) = self.sister.as_ref().filter(|sister| self.has_part(sister)) else { return false };
        match sister.standing.status {
            Status::Compiling | Status::Failed(_) => true,
            // They may have answered for some of the frames, or for another wish, and the rest is still to come.
            Status::Asking | Status::Answered => self.editing().is_some_and(|editing| editing.by_former_hand),
        }
    }

    /// Whether the functions have a part in what is edited now. Between keyframes that are set by hand nothing is left to
    /// choose.
    fn has_part(&self, sister: &Sister) -> bool {
        self.wish().is_some() && (sister.package != Package::Keyframes || self.settings.edit.automatic)
    }
}
