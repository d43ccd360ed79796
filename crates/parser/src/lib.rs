//! Reads and writes motion-capture files.
//!
//! [`bvh`] reads and writes Biovision hierarchies (`.bvh`), [`acclaim`] Acclaim skeletons and motions (`.asf`, `.amc`).
//! [`angles`] leads from the angles in them to rotations, and back.
//! Everything is read as a stream: a file is never held in
//! memory as a whole, and no memory is set aside because a file says that much is to come.
#![deny(missing_docs)]

pub mod acclaim;
pub mod angles;
pub mod bvh;

mod encoding;
mod error;
mod number;
mod shown;
mod snippet;
mod source;
mod text;
mod warning;
mod words;

pub use error::{Error, FileError, Kind, NumberError, Problem};
pub use snippet::{Snippet, printable};
pub use warning::Warning;
