//! Time warping: the part.
//!
//! Parts 1 and 2 are asked by themselves about every frame of which part 3 may ask them. Where both answer, it is part 3 that
//! fails.

use exam::{Failure, Subject};
use skeleton::acclaim::Between;

use super::super::ask::time_warp::{self, is_asked_whole};
use super::super::ask::{self, PIECE_LIMIT};
use super::{Place, same_kind};
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;

/// Part 2 is asked about so many frames at once.
const BLENDS_AT_ONCE: usize = 200;

pub(super) fn find(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Place {
    let (Some(bones), Some(map)) = (stage.bones(), stage.warp()) else { return Place::default() };
    let part = |part: usize| Place { part: Some(part), ..Place::default() };
    let is_whole = is_asked_whole(stage);
    let frames: Vec<usize> = if is_whole { (0..map.frame_count()).collect() } else { vec![index] };
    let (own, failed) = match ask::warm_up(subject) {
        Ok(()) if is_whole => time_warp::positions(subject, &map, &frames),
        Ok(()) => (Vec::new(), None),
        Err(_) => return Place::default(),
    };
    if failed.is_some_and(|other| same_kind(&other, failure)) {
        return part(0);
    }
    // Part 3 blends where part 1 says, if that is anywhere.
    let own_place = |at: usize| own.get(at).copied().filter(|place| time_warp::is_there(&map, place));
    let place = |(at, frame): (usize, &usize)| own_place(at).unwrap_or_else(|| map.place(*frame));
    let places: Vec<Between> = frames.iter().enumerate().map(place).collect();
    let blended = ask::warm_up(subject).and_then(|()| {
        let mut some = places.chunks(BLENDS_AT_ONCE);
        some.try_for_each(|places| time_warp::blends(subject, bones, places, PIECE_LIMIT).map(drop))
    });
    match blended {
        Err(other) if same_kind(&other, failure) => part(1),
        Ok(()) if is_whole => Place { cause: missing(&own, &map), ..part(2) },
        _ => Place::default(),
    }
}

/// The first frame for which part 1 names one that the old motion does not have. `places` are where it says that frames are.
fn missing(places: &[Between], map: &TimeMap) -> Option<String> {
    let (new, place) = places.iter().enumerate().find(|(_, place)| !time_warp::is_there(map, place))?;
    let (named, last) = (place.before.max(place.after), map.old_count().saturating_sub(1));
    Some(format!("part 1 names frame {named} for the new frame {new}, and the last old frame is {last}"))
}
