//! What to do about what is wrong.

use super::ErrorKind;
use crate::error::{Kind, Problem};

impl Kind for ErrorKind {
    const FORMAT: &'static str = "Acclaim";

    fn help(&self) -> &'static str {
        match self {
            ErrorKind::Common(Problem::LargeCount { .. }) => "Number the frames one by one, from 1.",
            ErrorKind::Common(problem) => problem.help(),
            ErrorKind::Empty { .. } | ErrorKind::NotAcclaim { .. } => "Check that this is the file you mean.",
            ErrorKind::RepeatedSection { .. } | ErrorKind::RepeatedPart { .. } => {
                "Keep the one that is right, and delete the other."
            }
            ErrorKind::SectionOrder { .. } => {
                "Add it, or move it there: the sections are :version, :name, :units, :documentation, :root, :bonedata and \
                 :hierarchy."
            }
            ErrorKind::LateRadians => {
                "Move it: the sections are :version, :name, :units, :documentation, :root, :bonedata and :hierarchy."
            }
            ErrorKind::NotClosed { .. } => "Every `begin` needs its `end`, on a line of its own.",
            ErrorKind::MissingPart { .. } => {
                "Every bone has a `name`, a `direction` and a `length`: add the line."
            }
            ErrorKind::NoName => "Write a name behind the word.",
            ErrorKind::LongName { .. } => "Shorten the name; or look for a line break that is missing.",
            ErrorKind::NameOfWords { .. } => "Join the words with `_`, here and wherever the bone is meant.",
            ErrorKind::RepeatedName { .. } => {
                "Bones are known by their names, in which upper and lower case are the same: call one of them otherwise."
            }
            ErrorKind::AxisOrder { .. } => "Write each of X, Y and Z once, without blanks between them.",
            ErrorKind::AngleUnit { .. } => "Write `angle deg` for degrees or `angle rad` for radians.",
            ErrorKind::UnknownDof { .. } => "Correct the word; t is for translation, r for rotation.",
            ErrorKind::LengthDof => {
                "Take `l` out of the list, and its number out of every frame of the motion."
            }
            ErrorKind::RepeatedDof { .. } => "A bone can have each of the six dofs once: correct the word.",
            ErrorKind::UnknownBone { .. } => {
                "Correct the name, here or where the skeleton gives it; or use the skeleton that belongs to the motion."
            }
            ErrorKind::SecondParent { .. } => "Delete the bone in one of the two lines.",
            ErrorKind::RootAsChild { .. } => "Delete it there.",
            ErrorKind::Unattached { .. } => {
                "Write it behind the bone at whose end it starts, or behind `root`, in `:hierarchy`."
            }
            ErrorKind::Cycle { .. } => {
                "Look in `:hierarchy` for the line in which one of them should hang on another bone."
            }
            ErrorKind::NoFrameNumber { .. } => {
                "Write 1 above the first frame, or look for a word that is misspelt."
            }
            ErrorKind::TooFewNumbers { .. } | ErrorKind::TooManyNumbers { .. } => {
                "Every bone has a line with one number for each of its dofs. Does the motion belong to this skeleton?"
            }
            ErrorKind::RepeatedBone { .. } => {
                "Delete one of the two lines, or look for a frame number that is missing."
            }
            ErrorKind::MissingBone { .. } => {
                "Every frame has the same bones: add the line, or get the file again if it is cut off."
            }
            ErrorKind::NewBone { .. } => {
                "Every frame has the same bones: add a line to the first frame, or delete this one."
            }
            ErrorKind::Skeleton(_) => "Call it otherwise, here and wherever it is meant.",
            ErrorKind::Motion(_) => "Look at the lines just above.",
        }
    }
}
