//! Questions to a student's functions, and their answers.
//!
//! A [`Question`] goes to a [`Subject`], which gives an [`Answer`] or a [`Failure`]. A subject is either
//! [`InProcess`], which calls the functions directly, or a [`WorkerProcess`]: a process that links the functions and
//! answers in [`worker::serve`]. What happens there (a panic, an endless loop, a crash) happens to it alone.
//!
//! Where students' functions are marked, this crate is all that is linked beside them. No right answer is in it, nor
//! anything that could make one. (The viewer's worker for keyframes links `inbetween` too, which poses frames.)
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
