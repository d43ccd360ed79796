//! From where a submission lies to its source text.

use std::fs::File;
use std::path::{Path, PathBuf};

use rawzip::ReaderAt;

use crate::archive::{Archive, Bytes, Kind, Member, Trouble};
use crate::choose::{Candidate, Choice, Listing, has_extension, is_archive_name};
use crate::disk::{self, Refused};
use crate::printable::printable;
use crate::source::normalise;
use crate::{MAX_ARCHIVE, MAX_FILES, MAX_SOURCE, Rejection, Source, Wanted, magic};

/// Where a submission lies.
#[derive(Debug, Clone)]
pub(crate) enum Place {
    File(PathBuf),
    Folder(PathBuf),
    /// A file in an archive of submissions.
    Member(Box<Member>),
    /// A folder in an archive of submissions.
    MemberFolder(Box<Listing<Member>>),
}

/// Reads a submission. `batch` is the archive of submissions, if they are in one.
pub(crate) fn load(place: &Place, batch: Option<&Archive>, wanted: &Wanted) -> Result<Source, Rejection> {
    match (place, batch) {
        (Place::File(path), _) => load_file(path, wanted),
        (Place::Folder(path), _) => match disk::walk(path, wanted)?.choose("folder", wanted)? {
            Choice::Source(one, remarks) => read_source(&open(&one.handle, wanted)?, remarks, wanted),
            Choice::Archive(one) => load_file(&one.handle, wanted),
        },
        (Place::Member(member), Some(batch)) => load_member(batch, member, wanted),
        (Place::MemberFolder(listing), Some(batch)) => match (**listing).clone().choose("folder", wanted)? {
            Choice::Source(one, remarks) => read_member_source(batch, &one.handle, remarks, wanted),
            Choice::Archive(one) => load_member(batch, &one.handle, wanted),
        },
        (Place::Member(_) | Place::MemberFolder(_), None) => {
            Err(Rejection::new("unreadable", "It is not part of this batch.", wanted))
        }
    }
}

fn load_file(path: &Path, wanted: &Wanted) -> Result<Source, Rejection> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let file = open(path, wanted)?;
    if has_extension(&name, &["rs"]) {
        return read_source(&file, Vec::new(), wanted);
    }
    load_archive(&name, Bytes::File(file), wanted)
}

fn load_member(batch: &Archive, member: &Member, wanted: &Wanted) -> Result<Source, Rejection> {
    check_kind(member, wanted)?;
    if has_extension(&member.path, &["rs"]) {
        return read_member_source(batch, member, Vec::new(), wanted);
    }
    let bytes = batch.read(member, MAX_ARCHIVE).map_err(|trouble| match trouble {
        Trouble::TooLarge => archive_too_large(wanted),
        other => rejection(other, "the archive of all submissions", wanted),
    })?;
    load_archive(&member.path, Bytes::Memory(bytes), wanted)
}

/// Reads what is not a Rust file by its name.
fn load_archive(name: &str, bytes: Bytes, wanted: &Wanted) -> Result<Source, Rejection> {
    let unreadable =
        |error| Rejection::new("unreadable", format!("The file cannot be read ({error})."), wanted);
    let len = bytes.len().map_err(unreadable)?;
    let mut head = [0; magic::LOOKS_AT];
    let got = bytes.read_at(&mut head, 0).map_err(unreadable)?;
    let head = head.get(..got).unwrap_or_default();
    if len == 0 {
        return Err(Rejection::new("empty", "The file is empty.", wanted));
    }
    if !magic::is_zip(head) && !has_extension(name, &["zip"]) {
        return Err(wrong_type(name, head, wanted));
    }
    if len > MAX_ARCHIVE {
        return Err(archive_too_large(wanted));
    }
    let is_zip = magic::is_zip(head);
    let explain = |trouble| match trouble {
        Trouble::NoEnd if !is_zip => not_a_zip(head, wanted),
        other => rejection(other, "the archive", wanted),
    };
    let archive = Archive::open(bytes).map_err(explain)?;
    let mut listing = Listing::new();
    let add = |member: Member| {
        let candidate = Candidate { path: member.path.clone(), kind: member.kind, handle: member };
        listing.add(candidate, wanted);
    };
    archive.for_each(MAX_FILES, add).map_err(explain)?;
    match listing.choose("archive", wanted)? {
        Choice::Source(one, remarks) => {
            archive.check_overlap(&one.handle).map_err(explain)?;
            read_member_source(&archive, &one.handle, remarks, wanted)
        }
        Choice::Archive(one) => {
            let inner = printable(&one.path);
            Err(Rejection::new(
                "archive_nested",
                format!("The archive holds another archive, {inner}."),
                wanted,
            ))
        }
    }
}

fn open(path: &Path, wanted: &Wanted) -> Result<File, Rejection> {
    let name = printable(&path.file_name().unwrap_or_default().to_string_lossy());
    disk::open(path).map_err(|refused| match refused {
        Refused::Link => Rejection::new("link", format!("{name} is a link, not a file."), wanted),
        Refused::Special => Rejection::new("special_file", format!("{name} is not a regular file."), wanted),
        Refused::Io(error) => {
            Rejection::new("unreadable", format!("{name} cannot be read ({error})."), wanted)
        }
    })
}

fn read_source(file: &File, remarks: Vec<String>, wanted: &Wanted) -> Result<Source, Rejection> {
    match disk::read(file, MAX_SOURCE) {
        Ok(Some(bytes)) => normalise(&bytes, remarks, wanted),
        Ok(None) => Err(too_large(wanted)),
        Err(error) => {
            Err(Rejection::new("unreadable", format!("The file cannot be read ({error})."), wanted))
        }
    }
}

fn read_member_source(
    archive: &Archive,
    member: &Member,
    remarks: Vec<String>,
    wanted: &Wanted,
) -> Result<Source, Rejection> {
    check_kind(member, wanted)?;
    match archive.read(member, MAX_SOURCE) {
        Ok(bytes) => normalise(&bytes, remarks, wanted),
        Err(trouble) => Err(rejection(trouble, "the archive", wanted)),
    }
}

fn check_kind(member: &Member, wanted: &Wanted) -> Result<(), Rejection> {
    let name = printable(&member.path);
    match member.kind {
        Kind::File => Ok(()),
        Kind::Link => Err(Rejection::new("link", format!("{name} is a link, not a file."), wanted)),
        Kind::Folder | Kind::Special => {
            Err(Rejection::new("special_file", format!("{name} is not a regular file."), wanted))
        }
    }
}

fn rejection(trouble: Trouble, place: &str, wanted: &Wanted) -> Rejection {
    let (code, found) = match trouble {
        Trouble::NoEnd => {
            ("archive_damaged", format!("The end of {place} is missing: perhaps it was cut off on its way."))
        }
        Trouble::Damaged(what) => {
            ("archive_damaged", format!("There is something wrong with {place}. {what}"))
        }
        Trouble::Encrypted => ("archive_encrypted", format!("The file in {place} is encrypted.")),
        Trouble::Method(method) => (
            "archive_method",
            format!(
                "The file in {place} is compressed by the method {}, which is not read.",
                printable(&method)
            ),
        ),
        Trouble::Overlap => ("archive_overlap", format!("Files in {place} share the same bytes.")),
        Trouble::TooManyFiles => {
            ("archive_too_many_files", format!("There are more than {MAX_FILES} files in {place}."))
        }
        Trouble::TooLarge => return too_large(wanted),
        Trouble::Io(error) => ("unreadable", format!("The system cannot read {place} ({error}).")),
    };
    Rejection::new(code, found, wanted)
}

fn too_large(wanted: &Wanted) -> Rejection {
    let found = format!("The file is larger than {} KiB, which no solution is.", MAX_SOURCE / 1024);
    Rejection::new("too_large", found, wanted)
}

fn archive_too_large(wanted: &Wanted) -> Rejection {
    let found = format!("The archive is larger than {} MiB.", MAX_ARCHIVE / 1024 / 1024);
    Rejection::new("archive_too_large", found, wanted)
}

fn wrong_type(name: &str, head: &[u8], wanted: &Wanted) -> Rejection {
    if is_archive_name(name) {
        return not_a_zip(head, wanted);
    }
    let found = match magic::format(head) {
        Some(format) => format!("The file is {format}."),
        None if has_extension(name, &["txt"]) => "The file is called .txt, not .rs.".into(),
        None => "The file is neither a Rust file (.rs) nor a zip archive.".into(),
    };
    Rejection::new("wrong_type", found, wanted)
}

fn not_a_zip(head: &[u8], wanted: &Wanted) -> Rejection {
    let found = match magic::format(head) {
        Some(format) => format!("The file is not a zip archive, but {format}."),
        None => "The file has the name of an archive, but is no zip archive.".into(),
    };
    Rejection::new("not_a_zip", found, wanted)
}
