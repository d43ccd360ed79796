//! Reads and writes motion-capture files.
//!
//! [`bvh`] reads and writes Biovision hierarchies (`.bvh`). Everything is read as a stream: a file is never held in
//! memory as a whole, and no memory is set aside because a file says that much is to come.
#![deny(missing_docs)]

pub mod bvh;

mod encoding;
mod number;
mod snippet;
mod source;

pub use snippet::{Snippet, printable};
