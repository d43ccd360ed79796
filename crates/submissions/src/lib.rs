//! Finds what students handed in, and reads it: from a path to a list of submissions, and from each of them to source text
//! or to a clear rejection.
//!
//! Whatever a submission is, reading it neither panics nor writes a file, and costs little memory and time:
//!
//! - Archives are read where they are, and never extracted. Names in them are compared, and never used as paths.
//! - One file of a submission is read, at most [`MAX_SOURCE`] bytes of it. What a file says of its own size is not trusted.
//! - Links are not followed, and what is no regular file is not opened for reading.
//!
//! As many results come out as submissions go in: what cannot be read is a [`Rejection`], never a gap.
#![deny(missing_docs)]

mod archive;
mod batch;
mod choose;
mod disk;
mod id;
mod load;
mod magic;
mod name;
mod pack;
mod printable;
mod rejection;
pub mod similar;
mod source;

pub use batch::{Batch, Error, SameStudent, by_student, read_one};
pub use pack::{PackError, Packed, write_zip};
pub use printable::printable;
pub use rejection::Rejection;

/// The largest source file that is read, in bytes.
pub const MAX_SOURCE: u64 = 256 * 1024;

/// The largest archive that is opened as one submission, in bytes.
///
/// The project with everything in it but `target/` is far smaller.
pub const MAX_ARCHIVE: u64 = 32 * 1024 * 1024;

/// How many files, folders and links one submission may hold.
pub const MAX_FILES: usize = 50_000;

/// How many files, folders and links may lie in a folder or an archive of submissions.
pub const MAX_BATCH: usize = 1_000_000;

/// Which file is to be handed in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wanted {
    /// Its name, such as `fk.rs`.
    pub file_name: String,
    /// Where it lies in the project, such as `exercises/fk/src/fk.rs`: some hand in the whole project.
    pub home: String,
}

/// One submission: something that a student handed in.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Unlike that of any other entry of the batch, also where upper and lower case are the same. A file can have this name on
    /// every system: 1 to 80 ASCII letters, digits, `_`, `-` and `.`.
    ///
    /// It is made from the name of what was handed in, and is the same each time.
    pub id: String,
    /// The name of the file or folder that was handed in, fit to be shown (see [`printable`]).
    pub file: String,
    /// Who handed it in, as far as the name tells.
    pub student: Student,
    /// The system from which it was downloaded, as far as the name tells.
    pub lms: Lms,
    /// Canvas marks late submissions in their names.
    pub marked_late: bool,
    place: load::Place,
}

/// Who handed something in, as far as its name tells. Nothing here has been checked: a student can write anything.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Student {
    /// The student number, digits only.
    pub number: Option<String>,
    /// The name, as well as it is known. It may hold quotes, commas, `=` and `<`, but no control characters.
    pub name: String,
}

/// The learning management system from which a submission was downloaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Lms {
    /// None that is known.
    None,
    /// A bulk download of Canvas.
    Canvas {
        /// The user's id, the column `ID` of the gradebook.
        user_id: String,
    },
    /// A bulk download of Canvas in which the names are hidden.
    CanvasAnonymous {
        /// The submission's anonymous id.
        id: String,
    },
    /// A download of Moodle.
    Moodle {
        /// The participant's number: `Participant 123` of the grading worksheet is `123`.
        participant: String,
    },
}

/// What came of reading a submission.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Loaded {
    /// The source text.
    Source(Source),
    /// There is none, and this is why.
    Rejected(Rejection),
}

/// The source text of a submission.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The text, in which `\n` ends each line. Lines are numbered as in the student's file.
    pub text: String,
    /// The SHA-256 of the file's bytes as they were handed in, 64 hexadecimal digits.
    pub sha256: String,
    /// What the student and the TA should know, in plain sentences, fit to be shown.
    pub remarks: Vec<String>,
}
