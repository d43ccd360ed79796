//! Archives made byte by byte, so that a test can lie in any field (APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16).
#![allow(dead_code, clippy::unwrap_used)] // Each test uses some of these.

use std::io::Write;
use std::path::Path;

use flate2::Compression;
use flate2::write::DeflateEncoder;
use submissions::{Loaded, Rejection, Source, Wanted, read_one};

pub const CODE: &str = "pub fn part() -> u8 {\n    1\n}\n";

pub fn wanted() -> Wanted {
    Wanted { file_name: "fk.rs".into(), home: "exercises/fk/src/fk.rs".into() }
}

/// A file in an archive, and what the archive says of it.
#[derive(Clone)]
pub struct Member {
    pub path: Vec<u8>,
    /// As they stand in the archive.
    pub data: Vec<u8>,
    pub size: u32,
    pub crc: u32,
    pub method: u16,
    pub flags: u16,
    /// The Unix file mode; 0 for an archive of another system.
    pub mode: u32,
    /// Where the list says that the file lies, if not where it does.
    pub offset: Option<u32>,
    pub extra: Vec<u8>,
}

impl Member {
    pub fn stored(path: impl AsRef<[u8]>, data: impl AsRef<[u8]>) -> Self {
        let data = data.as_ref();
        Self {
            path: path.as_ref().to_vec(),
            data: data.to_vec(),
            size: data.len().try_into().unwrap(),
            crc: rawzip::crc32(data),
            method: 0,
            flags: 0x0800,
            mode: 0o100_644,
            offset: None,
            extra: Vec::new(),
        }
    }

    pub fn deflated(path: impl AsRef<[u8]>, data: impl AsRef<[u8]>) -> Self {
        let data = data.as_ref();
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(data).unwrap();
        Self { data: encoder.finish().unwrap(), method: 8, ..Self::stored(path, data) }
    }

    fn fields(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for field in [20, self.flags, self.method, 0, 0x21] {
            bytes.extend(u16::to_le_bytes(field));
        }
        for field in [self.crc, u32::try_from(self.data.len()).unwrap(), self.size] {
            bytes.extend(field.to_le_bytes());
        }
        for len in [self.path.len(), self.extra.len()] {
            bytes.extend(u16::try_from(len).unwrap().to_le_bytes());
        }
        bytes
    }
}

/// An archive of `members`, in their order.
pub fn zip(members: &[Member]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut list = Vec::new();
    for member in members {
        let offset = member.offset.unwrap_or_else(|| bytes.len().try_into().unwrap());
        bytes.extend(b"PK\x03\x04");
        bytes.extend(member.fields());
        bytes.extend(&member.path);
        bytes.extend(&member.extra);
        bytes.extend(&member.data);

        list.extend(b"PK\x01\x02");
        list.extend(u16::to_le_bytes(if member.mode == 0 { 20 } else { 3 << 8 | 20 }));
        list.extend(member.fields());
        list.extend([0; 6]); // Comment, disk, internal attributes.
        list.extend((member.mode << 16).to_le_bytes());
        list.extend(offset.to_le_bytes());
        list.extend(&member.path);
        list.extend(&member.extra);
    }
    let start = bytes.len();
    bytes.extend(&list);
    bytes.extend(end(members.len(), list.len(), start));
    bytes
}

/// The end of an archive.
pub fn end(count: usize, list_len: usize, list_start: usize) -> Vec<u8> {
    let mut bytes = b"PK\x05\x06\0\0\0\0".to_vec();
    let count = u16::try_from(count & 0xffff).unwrap();
    bytes.extend(count.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend(u32::try_from(list_len).unwrap().to_le_bytes());
    bytes.extend(u32::try_from(list_start).unwrap().to_le_bytes());
    bytes.extend([0, 0]);
    bytes
}

/// Hands in `bytes` under `name`.
pub fn hand_in(name: &str, bytes: &[u8]) -> Loaded {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    read_one(&path, &wanted()).1
}

/// Hands in an archive of `members`.
pub fn hand_in_zip(members: &[Member]) -> Loaded {
    hand_in("300000001_TerryFox.zip", &zip(members))
}

#[track_caller]
pub fn source(loaded: Loaded) -> Source {
    match loaded {
        Loaded::Source(source) => source,
        Loaded::Rejected(rejection) => panic!("{rejection:?}"),
    }
}

#[track_caller]
pub fn rejected(loaded: Loaded) -> Rejection {
    match loaded {
        Loaded::Source(source) => panic!("{source:?}"),
        Loaded::Rejected(rejection) => {
            assert!(Rejection::CODES.iter().any(|(code, _)| *code == rejection.code), "{rejection:?}");
            assert!(rejection.why.ends_with("that holds the one file fk.rs."), "{rejection:?}");
            rejection
        }
    }
}

#[track_caller]
pub fn code(loaded: Loaded) -> &'static str {
    rejected(loaded).code
}

pub fn write(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) {
    std::fs::create_dir_all(path.as_ref().parent().unwrap()).unwrap();
    std::fs::write(path, bytes).unwrap();
}
