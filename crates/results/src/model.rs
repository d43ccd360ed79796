//! What is known about a run and about each submission. This is also what `results.json` holds.
//!
//! Whoever makes these values bounds them: no text longer than a few thousand characters, no list longer than a few
//! hundred entries. What students wrote (names, file names, panics, compile errors) may hold anything: the writers escape
//! it, and show control characters instead of obeying them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::Picture;

/// The version of this data model. It grows with every change that an older reader would misread.
pub const SCHEMA: u32 = 1;

/// One run over many submissions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunInfo {
    /// [`SCHEMA`].
    pub schema: u32,
    /// The exercise's package, for example `fk`.
    pub exercise: String,
    /// What the exercise is about, for example `Forward kinematics`.
    pub title: String,
    /// The parts in order, with what they are worth.
    pub parts: Vec<PartInfo>,
    /// The seed of the questions. Only for the teaching assistant's eyes.
    pub seed: u64,
    /// What the run was made with: `fk-lab`, `rustc` and so on, each with its version.
    pub versions: BTreeMap<String, String>,
    /// What each submission was allowed, for example `memory`: `512 MiB`.
    pub limits: BTreeMap<String, String>,
    /// The layers of the sandbox, in words; `unsandboxed` where there were none.
    pub sandbox: String,
    /// Whether every submission ran confined. When not, the report says so loudly.
    pub sandboxed: bool,
    /// Which share of the submissions this run marked, when not all of them.
    pub shard: Option<Shard>,
    /// The pose that the students' pictures are compared to.
    pub reference_picture: Option<Picture>,
}

/// One part of the exercise: one function of the student's.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartInfo {
    /// A short name for tables, for example `part1`.
    pub id: String,
    /// The function that is asked.
    pub function: String,
    /// What it computes.
    pub title: String,
    /// What the part is worth: the sum of its checks.
    pub points: u32,
    /// What is checked, in order.
    pub checks: Vec<CheckInfo>,
}

/// One check: passed as a whole or not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CheckInfo {
    /// A short name for tables, unique within its part, for example `rotation_orders`.
    pub id: String,
    /// What it looks at, in a few words.
    pub title: String,
    /// What it is worth.
    pub points: u32,
}

/// Share `index` of `count` shares, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shard {
    /// Which share this is, from 0.
    pub index: u32,
    /// How many shares there are.
    pub count: u32,
}

/// One submission, or one student who handed in nothing, and what became of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Unique in the run, and safe as a file name: ASCII letters, digits, `-`, `_` and `.`, not beginning with `.`.
    pub id: String,
    /// Who handed it in, as far as the submission's name tells.
    pub student: Student,
    /// Who that is in a learning platform.
    #[serde(default)]
    pub lms: Lms,
    /// The submission's name as it was handed in; empty when nothing was.
    pub file: String,
    /// The SHA-256 of the file that was marked, in hexadecimal.
    pub sha256: Option<String>,
    /// Whether the submission's own name says that it was late (Canvas writes `LATE`). It costs nothing by itself: a list of days
    /// late does.
    #[serde(default)]
    pub marked_late: bool,
    /// What the student should know about the file, for example that it was read as Latin-1. Safe for students.
    #[serde(default)]
    pub remarks: Vec<String>,
    /// How this submission was confined, in words.
    #[serde(default)]
    pub sandbox: String,
    /// What became of it.
    pub verdict: Verdict,
}

/// Who handed something in.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Student {
    /// The student number, when known.
    pub number: Option<String>,
    /// The name; empty when not known.
    pub name: String,
}

/// Who a student is in a learning platform.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "system", rename_all = "kebab-case")]
pub enum Lms {
    /// Not known.
    #[default]
    None,
    /// Canvas.
    Canvas {
        /// The number in the column `ID` of a gradebook.
        user_id: String,
    },
    /// Moodle.
    Moodle {
        /// The number behind `Participant` in the column `Identifier` of a worksheet.
        participant_id: String,
    },
}

/// What became of a submission.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum Verdict {
    /// It was asked, and each part has points.
    Graded {
        /// The parts in the run's order.
        parts: Vec<PartResult>,
        /// How they do together. It gives no points.
        whole: Option<Whole>,
        /// One pose as the student's functions compute it.
        picture: Option<Picture>,
    },
    /// The compiler refused it.
    DoesNotCompile {
        /// The first errors.
        errors: Vec<CompileError>,
        /// How many errors more there are.
        left_out: usize,
    },
    /// The compiler was stopped at a limit.
    TooExpensiveToCompile {
        /// Which limit, in words: `10 seconds`.
        limit: String,
        /// What the compiler said until then. Only for the teaching assistant.
        text: String,
    },
    /// It is no submission that can be marked: not an archive, no file in it, two files to choose from.
    Rejected {
        /// A short name for tables, for example `no-file`.
        code: String,
        /// Why, in one or two sentences to the student.
        why: String,
    },
    /// The student is on the roster and handed in nothing.
    Missing,
    /// Something went wrong that is not the student's fault. There are no points: neither none nor all.
    HarnessError {
        /// What went wrong. Only for the teaching assistant.
        what: String,
    },
}

/// How one part was answered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartResult {
    /// The id of its [`PartInfo`].
    pub id: String,
    /// The points it got.
    pub points: u32,
    /// The points it is worth.
    pub of: u32,
    /// How the part stands.
    pub state: PartState,
    /// The checks in the run's order.
    pub checks: Vec<CheckResult>,
    /// The misconceptions that were recognised.
    #[serde(default)]
    pub named: Vec<Named>,
    /// A remark on answers that were accepted although they are not quite right.
    #[serde(default)]
    pub remark: Option<String>,
}

/// How a part stands. A part that could not be asked for a reason that is not the student's makes the whole verdict a
/// [`Verdict::HarnessError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartState {
    /// All checks are right.
    Right,
    /// Some checks are right.
    PartlyRight,
    /// No check is right.
    Wrong,
    /// Every answer is the untouched template's.
    NotStarted,
    /// At least one check ended in a panic, and none is right.
    Panicked,
    /// At least one check ended without an answer in time, and none is right.
    TimedOut,
    /// At least one check ended the process, and none is right.
    Crashed,
}

/// How one check was answered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CheckResult {
    /// The id of its [`CheckInfo`].
    pub id: String,
    /// The points it got: those of a part that was not started may be none although the check is right.
    pub points: u32,
    /// The points it is worth.
    pub of: u32,
    /// How it was answered.
    pub state: CheckState,
    /// What the student reads: `3 of 14 cases are wrong; only these are wrong: ZYX`. It tells no inputs and no answers.
    #[serde(default)]
    pub note: String,
    /// What only the teaching assistant reads: the first wrong case with its inputs, the text of a panic.
    #[serde(default)]
    pub private_note: String,
}

/// How one check was answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CheckState {
    /// All cases are right.
    Right,
    /// At least one case is wrong.
    Wrong,
    /// A case was not answered: a panic, an endless loop, a crash.
    Stopped,
}

/// A misconception that was recognised.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Named {
    /// A short name for tables.
    pub id: String,
    /// What was misunderstood, in one sentence to the student.
    pub title: String,
    /// Why that is not so.
    pub explanation: String,
    /// What to look at next.
    pub hint: String,
}

/// How the parts do together over a whole motion.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Whole {
    /// How many frames were asked.
    pub frames: usize,
    /// Whether the answer is right for all of them.
    pub right: bool,
    /// What the student reads when it is not: `LeftFoot is off by 12.3 cm in frame 100; the first wrong joint is LeftUpLeg`.
    #[serde(default)]
    pub note: String,
}

/// One error of the compiler.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CompileError {
    /// The error in one line.
    pub message: String,
    /// The line in the student's file, from 1.
    pub line: Option<u32>,
    /// The column in that line, from 1.
    pub column: Option<u32>,
    /// The error as the compiler prints it, without colours and without paths outside the student's file.
    pub text: String,
}

/// Submissions that are alike.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// The ids of their records.
    pub ids: Vec<String>,
    /// How alike the least alike two of them are: from 0 to 1, which is the same.
    pub similarity: f64,
    /// In which sense, in a few words: `the same file`, `the same but for names and comments`.
    pub kind: String,
}

impl RunInfo {
    /// What the whole exercise is worth.
    pub fn points(&self) -> u32 {
        self.parts.iter().fold(0, |sum, part| sum.saturating_add(part.points))
    }
}

impl Record {
    /// What the submission got before overrides and days late.
    ///
    /// There are no points for what was not handed in and for what the harness could not mark. What does not compile, or is
    /// no submission, has 0 points, and a reason.
    pub fn points(&self) -> Option<u32> {
        match &self.verdict {
            Verdict::Graded { parts, .. } => {
                Some(parts.iter().fold(0, |sum, part| sum.saturating_add(part.points)))
            }
            Verdict::DoesNotCompile { .. }
            | Verdict::TooExpensiveToCompile { .. }
            | Verdict::Rejected { .. } => Some(0),
            Verdict::Missing | Verdict::HarnessError { .. } => None,
        }
    }
}

impl Verdict {
    /// A short name for tables.
    pub fn code(&self) -> &'static str {
        match self {
            Verdict::Graded { .. } => "graded",
            Verdict::DoesNotCompile { .. } => "does-not-compile",
            Verdict::TooExpensiveToCompile { .. } => "too-expensive-to-compile",
            Verdict::Rejected { .. } => "rejected",
            Verdict::Missing => "missing",
            Verdict::HarnessError { .. } => "harness-error",
        }
    }
}

impl PartState {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            PartState::Right => "right",
            PartState::PartlyRight => "partly right",
            PartState::Wrong => "wrong",
            PartState::NotStarted => "not started",
            PartState::Panicked => "panicked",
            PartState::TimedOut => "timed out",
            PartState::Crashed => "crashed",
        }
    }
}

impl CheckState {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            CheckState::Right => "right",
            CheckState::Wrong => "wrong",
            CheckState::Stopped => "stopped",
        }
    }
}
