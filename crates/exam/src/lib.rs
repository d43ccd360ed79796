//! Questions to a student's functions, and their answers.
//!
//! A [`Question`] goes to a [`Subject`], which gives an [`Answer`] or a [`Failure`]. A subject is either
//! [`InProcess`], which calls the functions directly, or a [`WorkerProcess`]: a process that links the functions and
//! answers in [`worker::serve`]. What happens there (a panic, an endless loop, a crash) happens to it alone.
//!
//! This crate is all that is linked beside a student's functions. No right answer is in it, nor anything that could
//! make one.
#![deny(missing_docs)]

pub mod acclaim;
pub mod fk;
mod in_process;
pub mod interpolation;
pub mod keyframes;
mod process;
mod stopper;
mod stream;
mod subject;
pub mod time_warp;
mod wire;
pub mod worker;

pub use in_process::InProcess;
pub use process::WorkerProcess;
pub use stopper::Stopper;
pub use subject::{Answer, Failure, Functions, Question, Subject};
