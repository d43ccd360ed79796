//! Where in a frame the student's functions panic, crash or never come back.

mod bone;
mod joint;
mod warp;

use exam::{Failure, Subject};

use crate::live::mover::Mover;
use crate::live::worker::Trouble;
use crate::motion::stage::Stage;

/// What is known about the place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Place {
    /// The joint or the bone at which it happens: `joint Hips`. Nothing in time warping, which blends all of them.
    pub(super) at: Option<String>,
    /// The part, from 0, in which it happens.
    pub(super) part: Option<usize>,
    /// What another part does that it may come from.
    pub(super) cause: Option<String>,
}

/// What is wrong with frame `index`, which fails as `failure` says, and where.
pub(crate) fn explain(
    mover: Mover,
    subject: &mut impl Subject,
    stage: &Stage,
    index: usize,
    failure: &Failure,
) -> Trouble {
    let place = find(mover, subject, stage, index, failure);
    trouble(mover, stage, index, failure, place)
}

/// Finds the place at which frame `index` fails as `failure` says. What is not the same each time is not told.
pub(super) fn find(
    mover: Mover,
    subject: &mut impl Subject,
    stage: &Stage,
    index: usize,
    failure: &Failure,
) -> Place {
    match mover {
        Mover::Fk => joint::find(subject, stage, index, failure),
        Mover::Acclaim => bone::find(subject, stage, index, failure),
        Mover::TimeWarp => warp::find(subject, stage, index, failure),
    }
}

fn same_kind(one: &Failure, other: &Failure) -> bool {
    std::mem::discriminant(one) == std::mem::discriminant(other)
}

/// What is told of frame `index`, in words for the student.
pub(super) fn trouble(mover: Mover, stage: &Stage, index: usize, failure: &Failure, place: Place) -> Trouble {
    let mut trouble = Trouble::from(failure.clone());
    let at = place.at.map(|at| format!("at {at}, ")).unwrap_or_default();
    trouble.details.push(match mover.is_asked_whole(stage) {
        true => format!("{at}while all {} frames were made", stage.frame_count()),
        false => format!("{at}in frame {index}"),
    });
    let parts = mover.package().exercise().rubric.parts;
    if let Some(part) = place.part.and_then(|part| parts.get(part)) {
        trouble.details.push(format!("in {}, {}", part.id, part.function));
    }
    trouble.details.extend(place.cause);
    trouble
}

/// A name of a file's, for one line.
fn short(name: &str) -> String {
    parser::printable(&name.chars().take(60).collect::<String>())
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Trouble {
        // A panic's message may be of any length.
        let text: String = failure.to_string().chars().take(600).collect();
        let mut lines = text.lines().take(8).map(str::to_owned);
        Trouble { headline: lines.next().unwrap_or_default(), details: lines.collect() }
    }
}
