//! What is shown: the state of each motion, and the scenes that follow from it.
//!
//! An [`app::App`] is one motion, a [`gallery::Gallery`] all that share the window, and a [`session::Session`] adds the
//! student's functions and the files on the disk. A [`screen::Screen`] keeps the picture of it all.

pub mod answers;
pub mod app;
mod blame;
pub mod gallery;
mod pair;
pub mod player;
pub mod screen;
pub mod session;
pub(crate) mod texts;
pub mod warp;
