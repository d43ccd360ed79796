//! The fixed viewer: a window, or a picture, of a moving skeleton.
//!
//! A motion is put on a [`stage`]; the [`player`] says which frame it is; poses come from the reference solution and
//! from the student's functions. From these the [`app`] makes a [`scene`], plain data that says what is to be
//! seen, and [`draw`] turns it into pixels on a [`canvas`], for the window and for PNG files alike.
#![deny(missing_docs)]

pub mod answers;
pub mod app;
mod beside;
mod blame;
pub mod board;
pub mod body;
pub mod camera;
pub mod canvas;
pub mod command;
pub mod draw;
pub mod film;
pub mod frames;
pub mod gallery;
mod input;
pub mod keyboard;
pub mod keys;
mod panel;
pub mod picture;
pub mod pictures;
pub mod player;
pub mod print;
pub mod ruler;
#[cfg(test)]
mod samples;
pub mod scene;
pub mod screen;
pub mod session;
pub mod sheet;
mod sides;
pub mod source;
pub mod stage;
pub mod student;
mod texts;
pub mod timeline;
pub mod upright;
pub mod window;
pub mod worker;
