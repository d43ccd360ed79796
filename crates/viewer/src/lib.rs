//! The fixed viewer: a window, or a picture, of a moving skeleton.
//!
//! | module | what it does |
//! |---|---|
//! | [`motion`] | puts a motion on a stage: how large its figure is, which way is up, where the ground is |
//! | [`edit`] | interpolates frames of a motion, between keyframes that are set by hand or chosen automatically |
//! | [`live`] | follows the student's file: notices a save, builds, asks, counts points |
//! | [`view`] | the state that keys and mouse change, and the scene that follows from it |
//! | [`scene`] | what is to be seen: plain data, without a pixel in it |
//! | [`draw`] | from a scene to pixels |
//! | [`window`] | hands keys and mouse to the view, and its picture to the display |
//! | [`output`] | pictures, films and contact sheets as files |
//! | [`command`] | the command `cargo view` |
#![deny(missing_docs)]

pub mod camera;
pub mod command;
pub mod draw;
pub mod edit;
pub mod live;
pub mod motion;
pub mod output;
#[cfg(test)]
mod samples;
pub mod scene;
pub mod view;
pub mod window;
