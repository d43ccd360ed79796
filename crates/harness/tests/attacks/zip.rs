//! Zip archives as nobody should write them (PKWARE's APPNOTE.TXT, 4.3). Every field can lie.

use std::io::Write;

use flate2::Compression;
use flate2::write::DeflateEncoder;

/// A file in an archive.
#[derive(Clone)]
pub struct File {
    pub name: Vec<u8>,
    pub bytes: Vec<u8>,
    pub method: u16,
    pub flags: u16,
    /// What the list says of the size of the contents.
    pub size: u32,
    pub crc32: u32,
    /// The file's type and permissions in Unix.
    pub mode: u32,
    /// The file whose place this one claims as its own.
    pub place_of: Option<usize>,
}

const STORED: u16 = 0;
const DEFLATED: u16 = 8;

impl File {
    pub fn new(name: impl Into<Vec<u8>>, contents: impl AsRef<[u8]>) -> File {
        let contents = contents.as_ref();
        let mut crc = flate2::Crc::new();
        crc.update(contents);
        File {
            name: name.into(),
            bytes: contents.to_vec(),
            method: STORED,
            flags: 0,
            size: contents.len() as u32,
            crc32: crc.sum(),
            mode: 0o100_644,
            place_of: None,
        }
    }

    pub fn compressed(mut self) -> File {
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&self.bytes).unwrap();
        self.bytes = encoder.finish().unwrap();
        self.method = DEFLATED;
        self
    }
}

/// The bytes of an archive.
pub fn archive(files: &[File]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut places = Vec::new();
    for file in files {
        let place = file.place_of.map_or(bytes.len() as u32, |other| places[other]);
        places.push(place);
        if file.place_of.is_none() {
            bytes.extend(b"PK\x03\x04");
            header(&mut bytes, file);
            bytes.extend(&file.name);
            bytes.extend(&file.bytes);
        }
    }
    let start = bytes.len() as u32;
    for (file, place) in files.iter().zip(&places) {
        bytes.extend(b"PK\x01\x02");
        // Made by Unix.
        short(&mut bytes, 0x0314);
        header(&mut bytes, file);
        // No comment, first disk, binary.
        bytes.extend([0; 6]);
        long(&mut bytes, file.mode << 16);
        long(&mut bytes, *place);
        bytes.extend(&file.name);
    }
    let length = bytes.len() as u32 - start;
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    short(&mut bytes, files.len() as u16);
    short(&mut bytes, files.len() as u16);
    long(&mut bytes, length);
    long(&mut bytes, start);
    short(&mut bytes, 0);
    bytes
}

/// What a file's own header and its entry in the list have in common.
fn header(bytes: &mut Vec<u8>, file: &File) {
    short(bytes, 20);
    short(bytes, file.flags);
    short(bytes, file.method);
    // The first of January 1980.
    short(bytes, 0);
    short(bytes, 0x21);
    long(bytes, file.crc32);
    long(bytes, file.bytes.len() as u32);
    long(bytes, file.size);
    short(bytes, file.name.len() as u16);
    short(bytes, 0);
}

fn short(bytes: &mut Vec<u8>, number: u16) {
    bytes.extend(number.to_le_bytes());
}

fn long(bytes: &mut Vec<u8>, number: u32) {
    bytes.extend(number.to_le_bytes());
}
