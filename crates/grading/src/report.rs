//! What grading found out.

use exam::Failure;

use crate::{CheckRubric, Difference, PartRubric};

/// How a part was answered.
#[derive(Clone, Debug)]
pub struct PartReport {
    /// What the part is worth.
    pub rubric: &'static PartRubric,
    /// The checks in the rubric's order.
    pub checks: Vec<CheckReport>,
    /// How the part stands.
    pub state: PartState,
    /// The misconceptions that were recognised.
    pub named: Vec<Named>,
    /// A remark on answers that were accepted although they are not quite right.
    pub remark: Option<&'static str>,
}

/// How one check was answered.
#[derive(Clone, Debug)]
pub struct CheckReport {
    /// What the check is worth.
    pub rubric: &'static CheckRubric,
    /// How it was answered.
    pub state: CheckState,
}

/// How one check was answered.
#[derive(Clone, Debug)]
pub enum CheckState {
    /// All cases are right.
    Right,
    /// At least one case is wrong.
    Wrong(FirstCase),
    /// A case was not answered.
    Failed {
        /// Why not.
        failure: Failure,
        /// The inputs of the case, each with its name and unit.
        inputs: Vec<(String, String)>,
    },
}

/// The first case of a check that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FirstCase {
    /// The inputs, each with its name and unit.
    pub inputs: Vec<(String, String)>,
    /// What came, and what should have come.
    pub difference: Difference,
    /// The groups in which cases are wrong, when there are groups and not all of them are: for example `ZYX`.
    pub groups: Vec<String>,
    /// How many of the check's cases are wrong.
    pub wrong: usize,
    /// How many cases the check has.
    pub cases: usize,
}

/// How a part stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartState {
    /// Every answer is the untouched template's.
    NotStarted,
    /// No check is right.
    Wrong,
    /// Some checks are right.
    PartlyRight,
    /// All checks are right.
    Right,
    /// At least one check ended in a panic, and none is right.
    Panicked,
    /// At least one check ended without an answer in time, and none is right.
    TimedOut,
    /// At least one check ended the process, and none is right.
    Crashed,
    /// At least one check could not be asked, for a reason that is not the student's, and none is right.
    NotAsked,
}

impl PartState {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            PartState::NotStarted => "not started",
            PartState::Wrong => "wrong",
            PartState::PartlyRight => "partly right",
            PartState::Right => "right",
            PartState::Panicked => "panicked",
            PartState::TimedOut => "timed out",
            PartState::Crashed => "crashed",
            PartState::NotAsked => "could not be asked",
        }
    }
}

/// A misconception that was recognised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// A short name for tables.
    pub id: &'static str,
    /// What was misunderstood, in one sentence to the student.
    pub title: &'static str,
    /// Why that is not so.
    pub explanation: &'static str,
    /// What to look at next.
    pub hint: &'static str,
    /// The checks that it explains.
    pub seen_in: &'static [&'static str],
}

impl PartReport {
    /// The points of the checks that are right; none when the part was not started.
    pub fn points(&self) -> u32 {
        if self.state == PartState::NotStarted {
            return 0;
        }
        let right = self.checks.iter().filter(|check| matches!(check.state, CheckState::Right));
        right.map(|check| check.rubric.points).sum()
    }
}

/// How the parts do together over a whole motion.
#[derive(Clone, Debug)]
pub struct WholeReport {
    /// How many frames were answered.
    pub frames: usize,
    /// What is said when all is right.
    pub praise: String,
    /// Nothing when all is right.
    pub trouble: Option<Trouble>,
}

impl WholeReport {
    /// There is no answer, or none that could be compared.
    pub fn failed(failure: Failure) -> WholeReport {
        WholeReport { frames: 0, praise: String::new(), trouble: Some(Trouble::Failed(failure)) }
    }
}

/// What is wrong when the parts work together.
#[derive(Clone, Debug)]
pub enum Trouble {
    /// The functions gave no poses.
    Failed(Failure),
    /// The answer differs from the right one.
    Different {
        /// How, in one sentence. Students read it in their feedback too: it holds nothing of the right answer.
        summary: String,
        /// What to look at, sentence by sentence.
        details: Vec<String>,
    },
    /// Some joint is not where it belongs.
    Off {
        /// The joint that is farthest off, how far, and in which frame.
        worst: String,
        /// The joint that goes wrong first: those before it in the tree are right.
        first: String,
        /// The first wrong frame, from 0.
        frame: usize,
        /// A remark when the functions took too few or too many angles from that frame.
        angles: Option<String>,
        /// The skeleton, with how each joint does in that frame.
        tree: Vec<TreeLine>,
    },
}

/// One joint of the tree that is shown when the chain fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeLine {
    /// How many ancestors the joint has.
    pub depth: usize,
    /// The joint's name.
    pub name: String,
    /// How far it is off; nothing when it is right.
    pub off: Option<String>,
    /// Whether it is the first wrong joint.
    pub first: bool,
}
