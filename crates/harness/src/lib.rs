//! The teaching assistant's command: a folder of submissions in, marks and feedback out.
//!
//! A submission goes through [`compile`], which makes a program of it, and [`mark`], which asks that program and
//! compares; both happen in a sandbox. [`batch`] does so for many at a time and writes each [`verdict`] into the
//! [`journal`]; [`finish`] makes tables, feedback and the report out of that.
#![deny(missing_docs)]

pub mod batch;
pub mod compile;
pub mod diagnostics;
pub mod digest;
pub mod doctor;
mod error;
pub mod exercise;
pub mod finish;
pub mod grade;
pub mod gradescope;
pub mod journal;
pub mod kit;
pub mod limits;
pub mod log;
pub mod mark;
pub mod marker;
pub mod merge;
mod orphans;
pub mod picture;
mod progress;
pub mod submit;
pub mod toolchain;
pub mod verdict;
mod whole_file;
pub mod workspace;

pub use error::Error;

/// How a command ended that did not fail.
#[derive(Debug)]
pub enum Ended {
    /// All is done.
    Done(results::Summary),
    /// The user stopped it.
    Stopped {
        /// How many submissions are marked.
        done: usize,
        /// How many there are.
        of: usize,
    },
}
