use crate::Wanted;
use crate::printable::printable;

/// Why there is no source text to mark.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rejection {
    /// One of [`Rejection::CODES`].
    pub code: &'static str,
    /// What was found, and what to hand in instead: plain sentences, fit to be shown.
    pub why: String,
    /// The SHA-256 of the file's bytes, when the file could be read.
    pub sha256: Option<String>,
}

impl Rejection {
    /// Every code there is, and what it stands for.
    pub const CODES: [(&str, &str); 20] = [
        ("archive_damaged", "The archive is cut off, or what it says of itself is not so."),
        ("archive_encrypted", "The archive needs a password."),
        ("archive_method", "The archive is compressed in a way that is not read."),
        ("archive_nested", "The archive holds another archive and no source file."),
        ("archive_overlap", "Files in the archive share bytes, which no common program writes."),
        ("archive_too_large", "The archive is larger than any submission should be."),
        ("archive_too_many_files", "The archive holds more files than any submission should."),
        ("binary", "The file holds bytes that no text holds."),
        ("empty", "The file has nothing in it."),
        ("folder_too_large", "The folder holds more files, or deeper folders, than any submission should."),
        ("link", "The file is a link to another one."),
        ("no_source", "There is no Rust file in it."),
        ("not_a_zip", "The archive is of another kind than zip."),
        ("not_source", "The file has the name of a Rust file, but is something else."),
        ("special_file", "The file is no regular file."),
        ("too_large", "The source file is larger than any solution should be."),
        ("two_candidates", "Several files have the right name."),
        ("unreadable", "The system could not read the file."),
        ("wrong_name", "There are several Rust files, and none has the right name."),
        ("wrong_type", "The file is neither a Rust file nor an archive."),
    ];

    /// `found` says in one or more sentences what was found.
    pub(crate) fn new(code: &'static str, found: impl Into<String>, wanted: &Wanted) -> Self {
        debug_assert!(Self::CODES.iter().any(|(known, _)| *known == code), "{code}");
        let why = format!("{} {}", found.into(), what_to_hand_in(wanted));
        Self { code, why, sha256: None }
    }
}

fn what_to_hand_in(wanted: &Wanted) -> String {
    let file = printable(&wanted.file_name);
    format!("Please hand in one zip file, named like 300000001_TerryFox.zip, that holds the one file {file}.")
}
