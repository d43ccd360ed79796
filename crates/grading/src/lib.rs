//! What a right answer is.
//!
//! A [`Rubric`] says what each part of an exercise is worth. An [`Exam`] fills it with questions from a seed and the
//! reference's answers. [`grade_part`] puts the questions to a [`Subject`](exam::Subject) and gives a
//! [`PartReport`], which [`scoreboard`] turns into text. A known-wrong answer is named as a [`Misconception`].
//!
//! The same checks run for the student and for the teaching assistant: only the seed differs.
#![deny(missing_docs)]

pub mod acclaim;
mod compare;
mod dice;
mod exam_paper;
mod exercises;
mod figure;
pub mod fk;
mod grade;
pub mod interpolation;
pub mod keyframes;
mod misconception;
mod reference;
mod report;
mod rubric;
pub mod scoreboard;
mod self_grading;
mod tables;
pub mod time_warp;

pub use exam_paper::{Case, CheckPaper, Difference, Exam, Judge, PartPaper, WholeMotion};
pub use exercises::{EXERCISES, Exercise};
pub use grade::{after_time_out, grade_part, grade_whole_motion};
pub use misconception::{Accepted, Misconception};
pub use reference::{Reference, Solutions};
pub use report::{
    CheckReport, CheckState, FirstCase, Named, PartReport, PartState, TreeLine, Trouble, WholeReport,
};
pub use rubric::{CheckRubric, PartRubric, Rubric};
pub use self_grading::{CHECK_LIMIT, Graded, self_grade};
pub use tables::{checks_table, misconceptions_table, rubric_table};

/// The seed of the questions that students see. Marks are made with another one, so that answers learnt by heart fail.
pub const PUBLIC_SEED: u64 = 15;
