//! What a run over many submissions found, and every file that comes out of it.
//!
//! A run is a [`RunInfo`] and one [`Record`] per submission. [`write_all`] joins them with what the teaching assistant hands in
//! beside them (an [`Options`]: the roster, days late, changes by hand) into a [`Mark`] for each, and writes:
//!
//! | file | for | what |
//! |---|---|---|
//! | `grades.csv` | TA | one row per submission, and per student without one |
//! | `report.html` | TA | everything, in one page that needs no network |
//! | `results.json` | programs | everything |
//! | `junit.xml` | programs | one test case per check |
//! | `feedback/ID.md`, `feedback/ID.html` | student | every point explained |
//! | `canvas.csv`, `moodle.csv` | learning platforms | the platform's own table, filled in |
//! | `key.csv` | TA | who is who, when the rest is anonymous |
//!
//! Students see the feedback and what [`gradescope`] makes: nothing there tells the inputs of a case, the seed, or a path of the
//! machine that marked.
#![deny(missing_docs)]

mod anonymous;
mod book;
mod error;
mod feedback;
mod files;
mod gradebook;
mod grades;
mod inputs;
mod json;
mod junit;
mod mark;
mod model;
mod page;
mod picture;
mod points;
mod report;
mod text;
mod write;

pub use book::Records;
pub use error::Error;
pub use feedback::gradescope;
pub use files::{PART_PREFIX, PART_SUFFIX, remove_leftovers};
pub use inputs::{LateList, Overrides, Roster};
pub use mark::{Change, Flag, Late, Mark, Standing};
pub use model::{
    CheckInfo, CheckResult, CheckState, CompileError, Group, Lms, Named, PartInfo, PartResult, PartState,
    Record, RunInfo, SCHEMA, Shard, Student, Verdict, Whole,
};
pub use picture::Picture;
pub use points::{LatePolicy, NotDecimal, Percent, Points};
pub use write::{Gradebook, Options, Summary, write_all};
