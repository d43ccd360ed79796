//! What lies in a folder or an archive of submissions.

use std::collections::{BTreeMap, HashMap};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::archive::{Archive, Bytes, Kind, Member, Trouble};
use crate::choose::{Candidate, Listing, has_extension, is_archive_name, is_litter, parts};
use crate::load::{Place, load};
use crate::printable::printable;
use crate::{Entry, Lms, Loaded, MAX_BATCH, Rejection, Wanted, disk, id, name};

/// The submissions in a folder or in a zip archive.
///
/// Everything directly in it is one submission: a zip archive, a Rust file, a folder, and also what is none of these, which is then
/// rejected. Left out is only what systems leave behind (names with a dot in front, `__MACOSX`, `Thumbs.db`, `desktop.ini`). If
/// there is nothing but one folder, and in it lies what looks like submissions, these are taken.
///
/// A path to a Rust file, or to an archive that is a submission by its name or because the wanted file lies directly in it, is a
/// batch of one.
pub struct Batch {
    archive: Option<Archive>,
    entries: Vec<Entry>,
    wanted: Wanted,
}

/// Why a path is no batch of submissions.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// It cannot be read.
    #[error("cannot read {path}: {error}", path = path.display())]
    Io {
        /// What was to be read.
        path: PathBuf,
        /// What the system said.
        #[source]
        error: io::Error,
    },
    /// It is a file, but no archive of submissions.
    #[error("{path} is neither a folder nor a zip archive of submissions: {why}", path = path.display())]
    NotABatch {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// It holds more than [`MAX_BATCH`].
    #[error("{path} holds more than {MAX_BATCH} files", path = path.display())]
    TooMany {
        /// The folder or archive.
        path: PathBuf,
    },
}

/// Submissions that seem to be of one student.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SameStudent {
    /// What they have in common, such as `student number 300000001`.
    pub student: String,
    /// The ids of the submissions, in their order.
    pub ids: Vec<String>,
}

impl Batch {
    /// Lists the submissions at `path`. None of them is opened.
    ///
    /// # Errors
    ///
    /// When `path` cannot be read, or is no folder, zip archive or Rust file.
    pub fn open(path: &Path, wanted: &Wanted) -> Result<Self, Error> {
        let io_error = |error| Error::Io { path: path.to_owned(), error };
        // Where the path itself is a link, whoever gave it means what the link points to.
        let real = fs::canonicalize(path).map_err(io_error)?;
        let metadata = fs::metadata(&real).map_err(io_error)?;
        if metadata.is_dir() {
            let items = items_of_folder(&real).map_err(|error| match error.kind() {
                io::ErrorKind::FileTooLarge => Error::TooMany { path: path.to_owned() },
                _ => io_error(error),
            })?;
            return Ok(Self { archive: None, entries: entries(items), wanted: wanted.clone() });
        }
        if !metadata.is_file() {
            return Err(Error::NotABatch { path: path.to_owned(), why: "it is not a regular file".into() });
        }
        let file_name = file_name(path, &real);
        let one = || Self { archive: None, entries: vec![single(&real, &file_name)], wanted: wanted.clone() };
        if has_extension(&file_name, &["rs"]) || is_recognised(name::stem(&file_name)) {
            return Ok(one());
        }
        let archive_error = |trouble| match trouble {
            Trouble::Io(error) => Error::Io { path: path.to_owned(), error },
            Trouble::TooManyFiles => Error::TooMany { path: path.to_owned() },
            Trouble::Damaged(why) => Error::NotABatch { path: path.to_owned(), why },
            _ => {
                Error::NotABatch { path: path.to_owned(), why: "the end of a zip archive is missing".into() }
            }
        };
        let file = fs::File::open(&real).map_err(io_error)?;
        let archive = Archive::open(Bytes::File(file)).map_err(archive_error)?;
        let items = items_of_archive(&archive, wanted).map_err(archive_error)?;
        if items.iter().any(|item| item.name == wanted.file_name) {
            return Ok(one());
        }
        Ok(Self { archive: Some(archive), entries: entries(items), wanted: wanted.clone() })
    }

    /// The submissions, sorted by id.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Reads one of the submissions. Several threads may do so at the same time.
    ///
    /// An archive within an archive is held in memory, at most [`crate::MAX_ARCHIVE`]; else it takes less than 2 MiB.
    pub fn load(&self, entry: &Entry) -> Loaded {
        loaded(&entry.place, self.archive.as_ref(), &self.wanted)
    }
}

/// Reads what is at `path` as one submission: a file, an archive, or a folder with loose files.
///
/// Who handed it in is taken from its name, or else from that of the file in it.
pub fn read_one(path: &Path, wanted: &Wanted) -> (Entry, Loaded) {
    match fs::canonicalize(path) {
        Ok(real) => {
            let entry = single(&real, &file_name(path, &real));
            let loaded = loaded(&entry.place, None, wanted);
            (entry, loaded)
        }
        Err(error) => {
            let rejection = Rejection::new("unreadable", format!("It cannot be read ({error})."), wanted);
            (single(path, &file_name(path, path)), Loaded::Rejected(rejection))
        }
    }
}

/// Which submissions seem to be of one student: they have the same student number, or the same user of Canvas or Moodle.
/// Students with one submission are left out.
pub fn by_student(entries: &[Entry]) -> Vec<SameStudent> {
    let mut same: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for entry in entries {
        let number = entry.student.number.as_ref().map(|number| format!("student number {number}"));
        let user = match &entry.lms {
            Lms::None => None,
            Lms::Canvas { user_id } => Some(format!("Canvas user {user_id}")),
            Lms::CanvasAnonymous { id } => Some(format!("anonymous Canvas submission {id}")),
            Lms::Moodle { participant } => Some(format!("Moodle participant {participant}")),
        };
        for student in number.into_iter().chain(user) {
            same.entry(student).or_default().push(entry.id.clone());
        }
    }
    same.retain(|_, ids| ids.len() > 1);
    let mut found: Vec<SameStudent> = Vec::new();
    for (student, ids) in same {
        match found.iter_mut().find(|one| one.ids == ids) {
            Some(one) => one.student = format!("{}, {student}", one.student),
            None => found.push(SameStudent { student, ids }),
        }
    }
    found
}

fn loaded(place: &Place, archive: Option<&Archive>, wanted: &Wanted) -> Loaded {
    match load(place, archive, wanted) {
        Ok(source) => Loaded::Source(source),
        Err(rejection) => Loaded::Rejected(rejection),
    }
}

/// One thing directly in a batch.
struct Item {
    name: String,
    place: Place,
}

impl Item {
    fn is_folder(&self) -> bool {
        matches!(self.place, Place::Folder(_) | Place::MemberFolder(_))
    }

    fn stem(&self) -> &str {
        if self.is_folder() { &self.name } else { name::stem(&self.name) }
    }
}

fn items_of_folder(path: &Path) -> io::Result<Vec<Item>> {
    let items = |folder: &Path| -> io::Result<Vec<Item>> {
        let item = |found: disk::Found| {
            let path = folder.join(&found.name);
            let place = if found.kind == Kind::Folder { Place::Folder(path) } else { Place::File(path) };
            Item { name: found.name.to_string_lossy().into_owned(), place }
        };
        Ok(disk::list_batch(folder)?.into_iter().map(item).collect())
    };
    let outer = items(path)?;
    if let [Item { name, place: Place::Folder(folder) }] = outer.as_slice() {
        let inner = items(folder)?;
        if is_wrapper(name, &inner) {
            return Ok(inner);
        }
    }
    Ok(outer)
}

fn items_of_archive(archive: &Archive, wanted: &Wanted) -> Result<Vec<Item>, Trouble> {
    let outer = items_at_depth(archive, 0, wanted)?;
    if let [one] = outer.as_slice()
        && one.is_folder()
    {
        let inner = items_at_depth(archive, 1, wanted)?;
        if is_wrapper(&one.name, &inner) {
            return Ok(inner);
        }
    }
    Ok(outer)
}

fn items_at_depth(archive: &Archive, depth: usize, wanted: &Wanted) -> Result<Vec<Item>, Trouble> {
    let mut files = Vec::new();
    let mut folders: BTreeMap<String, Listing<Member>> = BTreeMap::new();
    archive.for_each(MAX_BATCH, |member| {
        let path = member.path.clone();
        let parts = parts(&path);
        let Some(name) = parts.get(depth) else { return };
        if parts.iter().take(depth + 1).any(|part| is_litter(part)) {
            return;
        }
        if parts.len() == depth + 1 && member.kind != Kind::Folder {
            files.push(Item { name: (*name).to_owned(), place: Place::Member(Box::new(member)) });
            return;
        }
        let inside = parts.get(depth + 1..).unwrap_or_default().join("/");
        let listing = folders.entry((*name).to_owned()).or_insert_with(Listing::new);
        listing.add(Candidate { path: inside, kind: member.kind, handle: member }, wanted);
    })?;
    let folders = folders
        .into_iter()
        .map(|(name, listing)| Item { name, place: Place::MemberFolder(Box::new(listing)) });
    Ok(files.into_iter().chain(folders).collect())
}

/// Whether the only folder of a batch holds submissions, and is not one itself.
fn is_wrapper(name: &str, inside: &[Item]) -> bool {
    if is_recognised(name) {
        return false;
    }
    let archives = inside.iter().filter(|item| !item.is_folder() && is_archive_name(&item.name)).count();
    let is_package = inside.iter().any(|item| item.name == "src" || !item.is_folder());
    inside.iter().any(|item| is_recognised(item.stem())) || archives > 1 || (inside.len() > 1 && !is_package)
}

/// Whether a name tells who handed it in.
fn is_recognised(stem: &str) -> bool {
    let told = name::tell(stem);
    told.student.number.is_some() || told.lms != Lms::None
}

/// The name that was given, or, for a path like `.`, that of what it stands for.
fn file_name(given: &Path, real: &Path) -> String {
    given.file_name().or(real.file_name()).unwrap_or_default().to_string_lossy().into_owned()
}

fn single(path: &Path, file_name: &str) -> Entry {
    let is_folder = path.is_dir();
    let place = if is_folder { Place::Folder(path.to_owned()) } else { Place::File(path.to_owned()) };
    let item = Item { name: file_name.to_owned(), place };
    let id = id::make_ids(&[(item.stem(), file_name)]).pop().unwrap_or_default();
    entry(item, id)
}

fn entries(items: Vec<Item>) -> Vec<Entry> {
    let names: Vec<(&str, &str)> = items.iter().map(|item| (item.stem(), item.name.as_str())).collect();
    let ids = id::make_ids(&names);
    let mut entries: Vec<Entry> = items.into_iter().zip(ids).map(|(item, id)| entry(item, id)).collect();
    entries.sort_by(|a, b| a.id.cmp(&b.id));
    entries
}

fn entry(item: Item, id: String) -> Entry {
    let mut told = name::tell(item.stem());
    if told.student.number.is_none()
        && let Some(inner) = student_inside(&item.place)
    {
        if told.lms == Lms::None && !inner.name.is_empty() {
            told.student.name = inner.name;
        }
        told.student.number = inner.number;
    }
    Entry {
        id,
        file: printable(&item.name),
        student: told.student,
        lms: told.lms,
        marked_late: told.marked_late,
        place: item.place,
    }
}

/// The student of the files in a folder, if they tell of one only.
fn student_inside(place: &Place) -> Option<crate::Student> {
    /// Enough to find the file among what systems leave behind.
    const MAX_LOOK: usize = 64;
    let names: Vec<String> = match place {
        Place::Folder(path) => {
            let found = disk::list(path, MAX_LOOK).ok()?;
            found.iter().map(|one| one.name.to_string_lossy().into_owned()).collect()
        }
        Place::MemberFolder(listing) => listing.names().map(str::to_owned).collect(),
        Place::File(_) | Place::Member(_) => return None,
    };
    let students: HashMap<Option<String>, crate::Student> =
        names.iter().filter_map(|name| name::own(name::stem(name))).map(|s| (s.number.clone(), s)).collect();
    if students.len() == 1 { students.into_values().next() } else { None }
}
