//! Time warping: the part.
//!
//! Parts 1 and 2 are asked about the frame by themselves. Where both answer, it is part 3 that fails.

use exam::time_warp::{Answer as WarpAnswer, Question as WarpQuestion};
use exam::{Failure, Subject};

use super::super::ask::time_warp::{self, is_asked_whole};
use super::super::ask::{self, PIECE_LIMIT};
use super::{Place, same_kind};
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;

pub(super) fn find(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Place {
    let (Some(bones), Some(map)) = (stage.bones(), stage.warp()) else { return Place::default() };
    let mut put = |question: WarpQuestion| -> Result<WarpAnswer, Failure> {
        ask::warm_up(subject)?;
        time_warp::put(subject, question, PIECE_LIMIT)
    };
    let part = |part: usize| Place { part: Some(part), ..Place::default() };
    let (old_count, new_count) = (map.old_count(), map.frame_count());
    if is_asked_whole(stage) {
        // Part 3 calls it for all frames, and may fail at any of them.
        for new_frame in [index, 0, new_count.saturating_sub(1)] {
            match put(WarpQuestion::Position { new_frame, old_count, new_count }) {
                Err(other) if same_kind(&other, failure) => return part(0),
                _ => {}
            }
        }
    }
    let place = map.place(index);
    let [from, to] = [place.before, place.after].map(|index| bones.motion().posture(index));
    match put(WarpQuestion::Blend { from, to, t: place.t }) {
        Err(other) if same_kind(&other, failure) => part(1),
        Ok(_) if is_asked_whole(stage) => Place { cause: missing(subject, &map), ..part(2) },
        _ => Place::default(),
    }
}

/// The first frame for which part 1 names one that the old motion does not have.
fn missing(subject: &mut impl Subject, map: &TimeMap) -> Option<String> {
    let places = time_warp::places(subject, map, 0..map.frame_count());
    let named = places.into_iter().map(|place| place.map_or(0, |place| place.before.max(place.after)));
    let (new, named) = named.enumerate().find(|(_, named)| *named >= map.old_count())?;
    let last = map.old_count().saturating_sub(1);
    Some(format!("part 1 names frame {named} for the new frame {new}, and the last old frame is {last}"))
}
