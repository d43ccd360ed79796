//! Zip archives (PKWARE's APPNOTE.TXT), read from wherever their bytes lie, never extracted.
//!
//! The list at the archive's end is the authority on what is in it, as it is for most programs. Only that list and the one
//! file that is wanted are read.

use std::fs::File;
use std::io::{self, Read};

use flate2::read::DeflateDecoder;
use rawzip::{
    CompressionMethod, Error, ErrorKind, MAX_CENTRAL_DIRECTORY_RECORD_SIZE, ReaderAt, ZipArchive,
    ZipArchiveEntryWayfinder, ZipFileHeaderRecord, ZipLocator,
};

/// The list of files at an archive's end may take this many bytes: a million files with names of common length.
const MAX_LIST: u64 = 128 * 1024 * 1024;

/// Where an archive's bytes lie.
pub(crate) enum Bytes {
    File(File),
    Memory(Vec<u8>),
}

impl Bytes {
    pub(crate) fn len(&self) -> io::Result<u64> {
        match self {
            Self::File(file) => Ok(file.metadata()?.len()),
            Self::Memory(bytes) => Ok(bytes.len() as u64),
        }
    }
}

impl ReaderAt for Bytes {
    fn read_at(&self, buffer: &mut [u8], offset: u64) -> io::Result<usize> {
        match self {
            #[cfg(unix)]
            Self::File(file) => std::os::unix::fs::FileExt::read_at(file, buffer, offset),
            #[cfg(windows)]
            Self::File(file) => std::os::windows::fs::FileExt::seek_read(file, buffer, offset),
            Self::Memory(bytes) => bytes.read_at(buffer, offset),
        }
    }
}

/// An archive whose end has been found.
pub(crate) struct Archive {
    zip: ZipArchive<Bytes>,
}

/// What an archive's list says of one of its files.
#[derive(Debug, Clone)]
pub(crate) struct Member {
    /// As it stands in the archive: anything at all.
    pub(crate) path: String,
    pub(crate) kind: Kind,
    way: ZipArchiveEntryWayfinder,
    listed_at: u64,
    starts_at: u64,
    crc32: u32,
    method: CompressionMethod,
    is_encrypted: bool,
}

/// What something in a folder or an archive is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    File,
    Folder,
    Link,
    /// A device, a pipe, a socket.
    Special,
}

/// Why an archive, or a file in it, cannot be read.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// There is no end of a zip archive.
    NoEnd,
    Damaged(String),
    Encrypted,
    Method(String),
    Overlap,
    TooManyFiles,
    TooLarge,
    Io(io::Error),
}

impl Archive {
    pub(crate) fn open(bytes: Bytes) -> Result<Self, Trouble> {
        let len = bytes.len().map_err(Trouble::Io)?;
        let mut buffer = vec![0; rawzip::RECOMMENDED_BUFFER_SIZE];
        let found = ZipLocator::new().locate_in_reader(bytes, &mut buffer, len);
        let zip = found.map_err(|(_, error)| Trouble::from(error))?;
        if zip.eocd_offset().saturating_sub(zip.directory_offset()) > MAX_LIST {
            return Err(Trouble::TooManyFiles);
        }
        Ok(Self { zip })
    }

    /// Calls `visit` with everything in the list, in its order, the same name as often as it stands there.
    pub(crate) fn for_each(&self, max: usize, mut visit: impl FnMut(Member)) -> Result<(), Trouble> {
        if self.zip.entries_hint() > max as u64 {
            return Err(Trouble::TooManyFiles);
        }
        let mut seen: u64 = 0;
        self.for_each_record(|record| {
            seen += 1;
            if seen > max as u64 {
                return Err(Trouble::TooManyFiles);
            }
            visit(Member::new(record));
            Ok(())
        })?;
        let declared = self.zip.entries_hint();
        // Some programs write more than 65,535 files with a count of two bytes.
        if declared != seen && declared != seen & 0xffff {
            return Err(Trouble::Damaged(format!(
                "It says that it holds {declared} files, but lists {seen}."
            )));
        }
        Ok(())
    }

    /// The bytes of one file, at most `max`.
    pub(crate) fn read(&self, member: &Member, max: u64) -> Result<Vec<u8>, Trouble> {
        if member.is_encrypted {
            return Err(Trouble::Encrypted);
        }
        let entry = self.zip.get_entry(member.way)?;
        let (start, end) = entry.compressed_data_range();
        if end > self.zip.directory_offset() {
            return Err(Trouble::Damaged(
                "The bytes of the file would lie beyond those of the archive.".into(),
            ));
        }
        // What cannot be compressed grows by a few bytes in a thousand.
        if end - start > max + max / 64 + 1024 {
            return Err(Trouble::TooLarge);
        }
        let bytes = match member.method {
            CompressionMethod::STORE => read_up_to(entry.reader(), member, max)?,
            CompressionMethod::DEFLATE => read_up_to(DeflateDecoder::new(entry.reader()), member, max)?,
            other => return Err(Trouble::Method(method_name(other))),
        };
        check_claims(member, &bytes)?;
        Ok(bytes)
    }

    /// Refuses a file that shares bytes with another one: different programs would see different contents.
    pub(crate) fn check_overlap(&self, member: &Member) -> Result<(), Trouble> {
        let (_, end) = self.zip.get_entry(member.way)?.compressed_data_range();
        self.for_each_record(|other| {
            let start = other.local_header_offset();
            // The shortest that a file's header can be.
            let other_end = start.saturating_add(30).saturating_add(other.compressed_size_hint());
            let is_itself = other.central_directory_offset() == member.listed_at;
            if !is_itself && start < end && other_end > member.starts_at {
                Err(Trouble::Overlap)
            } else {
                Ok(())
            }
        })
    }

    fn for_each_record(
        &self,
        mut visit: impl FnMut(&ZipFileHeaderRecord<'_>) -> Result<(), Trouble>,
    ) -> Result<(), Trouble> {
        let mut buffer = vec![0; MAX_CENTRAL_DIRECTORY_RECORD_SIZE];
        let mut entries = self.zip.entries(&mut buffer);
        while let Some(record) = entries.next_entry()? {
            visit(&record)?;
        }
        Ok(())
    }
}

impl Member {
    fn new(record: &ZipFileHeaderRecord<'_>) -> Self {
        let path = decode(record.file_path().as_bytes());
        let kind = if path.ends_with(['/', '\\']) {
            Kind::Folder
        } else {
            match record.mode().value() & 0o170_000 {
                // Programs that know no file types write none.
                0 | 0o100_000 => Kind::File,
                0o040_000 => Kind::Folder,
                0o120_000 => Kind::Link,
                _ => Kind::Special,
            }
        };
        let flags = record.flags();
        Self {
            path,
            kind,
            way: record.wayfinder(),
            listed_at: record.central_directory_offset(),
            starts_at: record.local_header_offset(),
            crc32: record.crc32(),
            method: record.compression_method(),
            is_encrypted: flags.is_encrypted() || flags.has_strong_encryption() || flags.is_masked(),
        }
    }
}

impl From<Error> for Trouble {
    fn from(error: Error) -> Self {
        let text = error.to_string();
        match error.into_kind() {
            ErrorKind::MissingEndOfCentralDirectory => Self::NoEnd,
            ErrorKind::IO(error) => Self::from_reading(error),
            _ => Self::Damaged(format!("Its parts do not fit together ({text}).")),
        }
    }
}

impl Trouble {
    fn from_reading(error: io::Error) -> Self {
        if error.raw_os_error().is_some_and(|_| error.kind() != io::ErrorKind::InvalidInput) {
            return Self::Io(error);
        }
        Self::Damaged(match error.kind() {
            io::ErrorKind::UnexpectedEof => "It ends too early.".into(),
            _ => "Its parts do not fit together.".into(),
        })
    }
}

/// A name that is not in UTF-8 is in the code page of whoever made it. Which one, the archive does not say: every byte becomes
/// a letter of its own, so that different names stay different.
fn decode(name: &[u8]) -> String {
    match str::from_utf8(name) {
        Ok(name) => name.to_owned(),
        Err(_) => name.iter().map(|byte| char::from(*byte)).collect(),
    }
}

/// Reads one byte more than the archive says that there are, which is enough to know whether it lies.
fn read_up_to(reader: impl Read, member: &Member, max: u64) -> Result<Vec<u8>, Trouble> {
    let declared = member.way.uncompressed_size_hint();
    if declared > max {
        return Err(Trouble::TooLarge);
    }
    let mut bytes = Vec::with_capacity(usize::try_from(declared).map_err(|_| Trouble::TooLarge)? + 1);
    reader.take(declared + 1).read_to_end(&mut bytes).map_err(Trouble::from_reading)?;
    Ok(bytes)
}

fn check_claims(member: &Member, bytes: &[u8]) -> Result<(), Trouble> {
    let declared = member.way.uncompressed_size_hint();
    if declared != bytes.len() as u64 {
        let than = if declared < bytes.len() as u64 { "more" } else { "less" };
        return Err(Trouble::Damaged(format!(
            "It says that the file has {declared} bytes, but it has {than}."
        )));
    }
    if member.crc32 != rawzip::crc32(bytes) {
        return Err(Trouble::Damaged("The file's checksum is not the one that the archive says.".into()));
    }
    Ok(())
}

fn method_name(method: CompressionMethod) -> String {
    match method.name() {
        Some(name) => name.to_owned(),
        None => format!("number {}", method.as_u16()),
    }
}
