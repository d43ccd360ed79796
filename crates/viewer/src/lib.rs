//! The fixed viewer: a window, or a picture, of a moving skeleton.
//!
//! A motion is put on a [`stage`]; the [`player`] says which frame it is; poses come from the reference solution and
//! from the student's functions. From these the [`app`] makes a [`scene`], plain data that says what is to be
//! seen, and [`draw`] turns it into pixels on a [`canvas`], for the window and for PNG files alike.
#![deny(missing_docs)]

pub mod app;
pub mod board;
pub mod camera;
pub mod canvas;
pub mod command;
mod diagnostic;
pub mod draw;
pub mod keys;
pub mod live;
mod panel;
pub mod picture;
pub mod pictures;
pub mod player;
pub mod print;
#[cfg(test)]
mod samples;
pub mod scene;
pub mod stage;
pub mod student;
mod texts;
pub mod watch;
pub mod window;
pub mod worker;
