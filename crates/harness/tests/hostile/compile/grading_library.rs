//! Uses the library that holds the questions.
//!
//! expect: does-not-compile "can't find crate"
//! quick: yes

extern crate grading;
pub use grading::PUBLIC_SEED;
