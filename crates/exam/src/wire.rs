//! How questions and replies travel: a length as four bytes, little-endian, then that many bytes of `postcard`.
//!
//! Questions go to the worker's standard input and replies come from its standard output, which belongs to the
//! student's `println!` too. So each reply stands behind a [`Marker`], random and new for every worker: what is not
//! behind a marker was printed.

use std::hash::{BuildHasher, RandomState};
use std::io::{self, Read, Write};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::{Answer, Failure};

/// Stands in front of every reply.
pub(crate) type Marker = [u8; 16];

/// What a worker says to a question.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) enum Reply {
    Answered(Answer),
    Panicked { message: String, location: Option<String> },
}

impl From<Reply> for Result<Answer, Failure> {
    fn from(reply: Reply) -> Self {
        match reply {
            Reply::Answered(answer) => Ok(answer),
            Reply::Panicked { message, location } => Err(Failure::Panicked { message, location }),
        }
    }
}

/// No process can guess another's marker by accident. The first byte is 0, which printed text hardly ever holds.
pub(crate) fn new_marker() -> Marker {
    let mut marker = [0; 16];
    let random =
        u128::from(RandomState::new().hash_one(0)) << 64 | u128::from(RandomState::new().hash_one(1));
    marker[1..].copy_from_slice(&random.to_le_bytes()[1..]);
    marker
}

pub(crate) fn to_bytes(message: &impl Serialize) -> io::Result<Vec<u8>> {
    let mut bytes = vec![0; 4];
    bytes = postcard::to_extend(message, bytes).map_err(io::Error::other)?;
    let length = u32::try_from(bytes.len() - 4).map_err(io::Error::other)?;
    bytes[..4].copy_from_slice(&length.to_le_bytes());
    Ok(bytes)
}

pub(crate) fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> io::Result<T> {
    postcard::from_bytes(bytes).map_err(io::Error::other)
}

/// Reads the length and the bytes behind it; `None` at the end of the input. The memory grows with what arrives,
/// not with what the length says.
pub(crate) fn read_message(source: &mut impl Read) -> io::Result<Option<Vec<u8>>> {
    let mut length = [0; 4];
    match source.read_exact(&mut length) {
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => return Ok(None),
        other => other?,
    }
    let length = u32::from_le_bytes(length);
    let mut bytes = Vec::new();
    source.take(length.into()).read_to_end(&mut bytes)?;
    if bytes.len() as u64 != u64::from(length) {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(Some(bytes))
}

/// Writes a reply behind its marker, in one piece.
pub(crate) fn write_reply(out: &mut impl Write, marker: &Marker, reply: &Reply) -> io::Result<()> {
    let message = to_bytes(reply)?;
    out.write_all(marker)?;
    out.write_all(&message)?;
    out.flush()
}
