//! What a run over many submissions found, and every file that comes out of it.
#![deny(missing_docs)]

mod model;
mod picture;

pub use model::{
    CheckInfo, CheckResult, CheckState, CompileError, Group, Lms, Named, PartInfo, PartResult, PartState,
    Record, RunInfo, SCHEMA, Shard, Student, Verdict, Whole,
};
pub use picture::Picture;
