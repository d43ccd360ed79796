//! Which of the files in a folder or an archive is the submission.

use crate::archive::Kind;
use crate::printable::printable;
use crate::{Rejection, Wanted};

/// Names beyond these are counted, not kept.
const KEPT: usize = 16;

/// The files of a submission that could be the wanted one. It stays small however many there are.
#[derive(Debug, Clone)]
pub(crate) struct Listing<T> {
    /// At the end of the path that the project has.
    home: Few<T>,
    /// With the right name.
    named: Few<T>,
    /// With the right name but for upper and lower case.
    nearly: Few<T>,
    /// Any other Rust files.
    rust: Few<T>,
    archives: Few<T>,
    others: usize,
}

/// One file: what it is called, what it is, and how to read it.
#[derive(Debug, Clone)]
pub(crate) struct Candidate<T> {
    /// As it stands in the folder or archive.
    pub(crate) path: String,
    pub(crate) kind: Kind,
    pub(crate) handle: T,
}

/// What is to be read.
#[derive(Debug)]
pub(crate) enum Choice<T> {
    Source(Candidate<T>, Vec<String>),
    Archive(Candidate<T>),
}

impl<T: Clone> Listing<T> {
    pub(crate) fn new() -> Self {
        Self {
            home: Few::new(),
            named: Few::new(),
            nearly: Few::new(),
            rust: Few::new(),
            archives: Few::new(),
            others: 0,
        }
    }

    /// Folders and what systems leave behind do not count.
    pub(crate) fn add(&mut self, candidate: Candidate<T>, wanted: &Wanted) {
        let parts = parts(&candidate.path);
        if candidate.kind == Kind::Folder || parts.iter().any(|part| is_litter(part)) {
            return;
        }
        let Some(name) = parts.last() else { return };
        let home: Vec<&str> = wanted.home.split('/').collect();
        if *name == wanted.file_name && parts.ends_with(&home) {
            self.home.push(&candidate);
        }
        if *name == wanted.file_name {
            self.named.push(&candidate);
        } else if name.to_lowercase() == wanted.file_name.to_lowercase() {
            self.nearly.push(&candidate);
        } else if has_extension(name, &["rs"]) {
            self.rust.push(&candidate);
        } else if is_archive_name(name) {
            self.archives.push(&candidate);
        } else {
            self.others += 1;
        }
    }

    /// The names of the files that could be what was handed in.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        let files = [&self.archives, &self.named, &self.nearly, &self.rust];
        files.into_iter().flat_map(|few| &few.kept).filter_map(|one| parts(&one.path).last().copied())
    }

    /// The one file that is wanted. `place` is what the files are in, for people: "archive" or "folder".
    ///
    /// In this order: the only file with the right name; the one at its place in the project; the only one with the right name
    /// but for upper and lower case; the only Rust file; the only archive. Two of a kind are one too many.
    pub(crate) fn choose(mut self, place: &str, wanted: &Wanted) -> Result<Choice<T>, Rejection> {
        let name = printable(&wanted.file_name);
        let mut remarks = Vec::new();
        let chosen = if let Some(one) = self.named.take_only() {
            one
        } else if let Some(one) = self.home.take_only() {
            remarks.push(format!(
                "The {place} holds {} files with the name {name}: {} was read.",
                self.named.count,
                printable(&one.path)
            ));
            one
        } else if self.named.count > 1 {
            return Err(two_candidates(&self.named, place, &name, wanted));
        } else if let Some(one) = self.nearly.take_only() {
            remarks.push(format!("The file is called {}, not {name}.", printable(&one.path)));
            one
        } else if self.nearly.count > 1 {
            return Err(two_candidates(&self.nearly, place, &name, wanted));
        } else if let Some(one) = self.rust.take_only() {
            remarks.push(format!(
                "The file is called {}, not {name}: as the only Rust file it was read.",
                printable(&one.path)
            ));
            one
        } else {
            return self.choose_archive(place, &name, wanted);
        };
        if self.archives.count > 0 && place == "folder" {
            remarks.push(format!("The folder also holds {}, which was not opened.", self.archives.list()));
        }
        if parts(&chosen.path).len() < chosen.path.split(['/', '\\']).count() {
            remarks.push(format!(
                "The {place} calls the file {}: only its last part was looked at.",
                printable(&chosen.path)
            ));
        }
        match chosen.kind {
            Kind::File => Ok(Choice::Source(chosen, remarks)),
            Kind::Link => Err(Rejection::new(
                "link",
                format!("{} is a link, not a file.", printable(&chosen.path)),
                wanted,
            )),
            Kind::Special | Kind::Folder => Err(Rejection::new(
                "special_file",
                format!("{} is not a regular file.", printable(&chosen.path)),
                wanted,
            )),
        }
    }

    fn choose_archive(mut self, place: &str, name: &str, wanted: &Wanted) -> Result<Choice<T>, Rejection> {
        let (rust, others, archives) = (self.rust.count, self.others, self.archives.count);
        if rust > 1 {
            let found = format!(
                "The {place} holds {rust} Rust files ({}), and none of them is {name}.",
                self.rust.list()
            );
            return Err(Rejection::new("wrong_name", found, wanted));
        }
        let list = self.archives.list();
        match self.archives.take_only() {
            Some(archive) if archive.kind == Kind::File => Ok(Choice::Archive(archive)),
            Some(archive) => {
                let found = format!("{} is not a regular file.", printable(&archive.path));
                Err(Rejection::new("link", found, wanted))
            }
            None if archives > 1 => {
                let found = format!("The {place} holds no {name}, but {archives} archives ({list}).");
                Err(Rejection::new("two_candidates", found, wanted))
            }
            None if others == 0 => Err(Rejection::new("no_source", format!("The {place} is empty."), wanted)),
            None => {
                let found = format!("The {place} holds no {name} and no other Rust file.");
                Err(Rejection::new("no_source", found, wanted))
            }
        }
    }
}

/// The parts of a path of any system. It was never a path of ours: what leads out of a folder is dropped.
pub(crate) fn parts(path: &str) -> Vec<&str> {
    let is_drive = |part: &str| part.len() == 2 && part.ends_with(':');
    let mut parts: Vec<&str> =
        path.split(['/', '\\']).filter(|part| !matches!(*part, "" | "." | "..")).collect();
    if parts.first().is_some_and(|first| is_drive(first)) {
        parts.remove(0);
    }
    parts
}

/// What systems and editors leave behind, and nobody hands in.
pub(crate) fn is_litter(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    name.starts_with('.')
        || matches!(lower.as_str(), "__macosx" | "thumbs.db" | "desktop.ini" | "$recycle.bin")
}

/// Whether a file's name is that of an archive, ours or any other.
pub(crate) fn is_archive_name(name: &str) -> bool {
    has_extension(name, &["zip", "rar", "7z", "tar", "gz", "tgz", "bz2", "xz", "zst", "zipx", "cab"])
}

/// Whether a file's name has one of the extensions, in upper or lower case.
pub(crate) fn has_extension(name: &str, extensions: &[&str]) -> bool {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    extensions.iter().any(|known| extension.eq_ignore_ascii_case(known))
}

fn two_candidates<T>(few: &Few<T>, place: &str, name: &str, wanted: &Wanted) -> Rejection {
    let found = format!("The {place} holds {} files with the name {name}: {}.", few.count, few.list());
    Rejection::new("two_candidates", found, wanted)
}

/// The first few of possibly very many.
#[derive(Debug, Clone)]
struct Few<T> {
    kept: Vec<Candidate<T>>,
    count: usize,
}

impl<T: Clone> Few<T> {
    fn new() -> Self {
        Self { kept: Vec::new(), count: 0 }
    }

    fn push(&mut self, candidate: &Candidate<T>) {
        self.count += 1;
        if self.kept.len() < KEPT {
            self.kept.push(candidate.clone());
        }
    }

    fn take_only(&mut self) -> Option<Candidate<T>> {
        if self.count == 1 { self.kept.pop() } else { None }
    }
}

impl<T> Few<T> {
    fn list(&self) -> String {
        let shown: Vec<String> = self.kept.iter().take(4).map(|one| printable(&one.path)).collect();
        let more = if self.count > shown.len() { ", …" } else { "" };
        format!("{}{more}", shown.join(", "))
    }
}
