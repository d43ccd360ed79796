//! Pictures, films, contact sheets and motions as files.

pub(crate) mod beside;
pub mod edit;
pub mod film;
pub mod frames;
pub mod picture;
pub mod pictures;
pub mod sheet;
pub mod warped;
