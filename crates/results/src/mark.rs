//! From what a submission did to the points that its student gets.

use serde::Serialize;

use crate::inputs::{Override, What};
use crate::{LatePolicy, Percent, Points, Record, RunInfo, Verdict};

/// The points of one submission, and how they came about.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Mark {
    /// What counts in the end. Nothing where there are no points: neither none nor all.
    pub points: Option<Points>,
    /// What the checks gave.
    pub checked: Option<Points>,
    /// What each part gives, after what was changed by hand.
    pub parts: Vec<Option<Points>>,
    /// What was changed by hand, in the order in which it was carried out.
    pub changes: Vec<Change>,
    /// What being late cost.
    pub late: Option<Late>,
    /// Whether the points go into a gradebook.
    pub counts: bool,
    /// What somebody should look at.
    pub flags: Vec<Flag>,
}

/// One change by hand.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// What was changed: `part1/rotation_orders`, `part1`, `total`, or `counts`.
    pub what: String,
    /// The points before.
    pub from: Option<Points>,
    /// The points after; nothing for `counts`.
    pub to: Option<Points>,
    /// Why.
    pub reason: String,
}

/// What being late cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Late {
    /// How many days.
    pub days: u32,
    /// How much was taken off.
    pub percent: Percent,
    /// The points before that.
    pub from: Points,
}

/// What somebody should look at.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "flag", rename_all = "kebab-case")]
pub enum Flag {
    /// The student is not on the roster.
    NotOnRoster,
    /// The number is this student's, but the submission bears a name that has nothing in common with the roster's.
    NameDiffers {
        /// The name that the submission bears.
        name: String,
    },
    /// The submission's own name says that it was late, and the list of days late says nothing of it.
    LateButNotListed,
    /// The student has other submissions.
    OtherSubmissions {
        /// Their ids.
        ids: Vec<String>,
        /// Which of them counts.
        standing: Standing,
    },
}

/// Which of a student's submissions counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Standing {
    /// All have the same points.
    Agree,
    /// They differ, and nobody has decided: none counts.
    Undecided,
    /// It was decided that this one counts.
    Chosen,
    /// It was decided that another one counts.
    NotChosen,
}

impl Mark {
    /// The mark as the checks give it, with what was changed by hand and what the days late take off.
    ///
    /// An override of a check or a part comes before the days late; an override of the total stands as it is.
    ///
    /// # Errors
    ///
    /// When a check is to be changed of a submission that has no points: the line of that override.
    pub(crate) fn new(
        run: &RunInfo,
        record: &Record,
        overrides: &[&Override],
        late: Option<(LatePolicy, u32)>,
    ) -> Result<Mark, u64> {
        let parts = (0..run.parts.len()).map(|part| part_points(run, record, part)).collect();
        let mut mark = Mark { checked: record.points().map(Points::whole), parts, ..Mark::default() };
        let mut total = None;
        for decided in overrides {
            match &decided.what {
                What::Check(part, check, to) => {
                    let before = mark.parts[*part].ok_or(decided.line)?;
                    let from = check_points(run, record, *part, *check);
                    mark.parts[*part] = Some(before.minus(from).plus(*to));
                    let what = format!("{}/{}", run.parts[*part].id, run.parts[*part].checks[*check].id);
                    mark.changed(decided, what, Some(from), Some(*to));
                }
                What::Part(part, to) => {
                    let from = mark.parts[*part].replace(*to);
                    mark.changed(decided, run.parts[*part].id.clone(), from, Some(*to));
                }
                What::Total(to) => total = Some((decided, *to)),
                What::Counts => mark.changed(decided, "counts".to_owned(), None, None),
            }
        }
        mark.points = mark.sum();
        if let (Some(from), Some((policy, days @ 1..))) = (mark.points, late)
            && total.is_none()
        {
            let percent = policy.deduction(days);
            mark.late = Some(Late { days, percent, from });
            mark.points = Some(from.less(percent));
        }
        if let Some((decided, to)) = total {
            let from = mark.points.replace(to);
            mark.changed(decided, "total".to_owned(), from, Some(to));
        }
        mark.counts = mark.points.is_some();
        Ok(mark)
    }

    fn changed(&mut self, decided: &Override, what: String, from: Option<Points>, to: Option<Points>) {
        self.changes.push(Change { what, from, to, reason: decided.reason.clone() });
    }

    /// Nothing when a part has no points.
    fn sum(&self) -> Option<Points> {
        self.parts.iter().try_fold(Points::ZERO, |sum, part| Some(sum.plus((*part)?)))
    }
}

fn part_points(run: &RunInfo, record: &Record, part: usize) -> Option<Points> {
    match &record.verdict {
        Verdict::Graded { parts, .. } => {
            let id = &run.parts[part].id;
            parts.iter().find(|result| result.id == *id).map(|result| Points::whole(result.points))
        }
        Verdict::Missing | Verdict::HarnessError { .. } => None,
        _ => Some(Points::ZERO),
    }
}

fn check_points(run: &RunInfo, record: &Record, part: usize, check: usize) -> Points {
    let Verdict::Graded { parts, .. } = &record.verdict else { return Points::ZERO };
    let info = &run.parts[part];
    let result = parts.iter().find(|result| result.id == info.id);
    let check = result.and_then(|part| part.checks.iter().find(|result| result.id == info.checks[check].id));
    check.map_or(Points::ZERO, |check| Points::whole(check.points))
}
