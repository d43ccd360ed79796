//! What to do about what is wrong.

use super::ErrorKind;
use crate::error::{Common, Kind, Problem};

impl From<Problem> for ErrorKind {
    fn from(Problem(problem): Problem) -> Self {
        match problem {
            Common::Io(cause) => ErrorKind::Io(cause),
            Common::Ended { expected } => ErrorKind::Ended { expected },
            Common::Unexpected { found, expected } => ErrorKind::Unexpected { found, expected },
            Common::MergeConflict { found } => ErrorKind::MergeConflict { found },
            Common::LargeCount { found, expected } => ErrorKind::LargeCount { found, expected },
            Common::Number(problem) => ErrorKind::Number(problem),
        }
    }
}

impl Kind for ErrorKind {
    fn help(&self) -> &'static str {
        match self {
            ErrorKind::Io(_) => "Check that the file is a file, and that you may read it.",
            ErrorKind::Empty { .. } | ErrorKind::NotAcclaim { .. } => "Check that this is the file you mean.",
            ErrorKind::MergeConflict { .. } => {
                "Keep one of the two versions, and delete the lines that begin with <<<<<<<, ======= and >>>>>>>."
            }
            ErrorKind::Unexpected { .. } => {
                "Look for a word that is missing, misspelt or too many, here or just above."
            }
            ErrorKind::Ended { .. } => "The file seems to be cut off: get it again from where it came from.",
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
            ErrorKind::LargeCount { .. } => "Number the frames one by one, from 1.",
            ErrorKind::Number(problem) => problem.help(),
            ErrorKind::Skeleton(_) => "Call it otherwise, here and wherever it is meant.",
            ErrorKind::Motion(_) => "Look at the lines just above.",
        }
    }
}
