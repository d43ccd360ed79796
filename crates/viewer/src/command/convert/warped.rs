//! Warped motions as files.

use std::path::Path;

use indicatif::ProgressBar;
use parser::{acclaim, printable};

use super::facts::{self, fact};
use super::{bones, made_joints, not_written, warn};
use crate::command::bar::bar;
use crate::command::print::number;
use crate::motion::source::Source;
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;
use crate::output::beside::{write_both, write_whole};
use crate::output::warped;
use crate::view::texts::count;

/// Writes a warped motion of joints, and gives what is to be said of it.
pub fn write_joints(source: &Source, stage: &Stage, map: TimeMap, path: &Path) -> Result<String, String> {
    let motion = stage.motion();
    let (bar, mut misfits) = (frames_bar(map), Vec::new());
    write_whole(path, |out| {
        misfits = warped::write_joints(motion, map, out, &mut |done| bar.set_position(done as u64))?;
        Ok(())
    })
    .map_err(|error| not_written("motion", path, &error))?;
    bar.finish_and_clear();
    warn(&source.title(), motion, &misfits);
    Ok(facts::joints(motion, map.frame_count()) + &made_of(map) + &made_joints(source, stage))
}

/// Writes a warped motion of bones and its skeleton, and gives what is to be said of it.
pub fn write_bones(
    source: &Source,
    stage: &Stage,
    map: TimeMap,
    [skeleton, path]: [&Path; 2],
) -> Result<String, String> {
    let (motion, changes) = bones(source, stage)?;
    let motion = motion.into_owned();
    let bar = frames_bar(map);
    let mut tick = |done: usize| bar.set_position(done as u64);
    let (motion, freed) = warped::fitting(motion, map, &mut tick);
    write_both([skeleton, path], |bones, frames| {
        acclaim::write_skeleton(motion.skeleton(), bones)?;
        warped::write_bones(&motion, map, frames, &mut tick)
    })
    .map_err(|error| facts::pair_not_written(skeleton, path, &error))?;
    bar.finish_and_clear();
    let seconds = stage.motion().playable_frame_time();
    let mut said = format!(
        "{}, {}{}{}",
        count(map.frame_count(), "frame", "frames"),
        facts::bones(motion.skeleton()),
        made_of(map),
        facts::beside(skeleton, seconds)
    );
    if let Some(freed) = freed {
        let bone = motion.skeleton().get(freed.bone).map_or("", |bone| &bone.name);
        said += &fact(
            "angles",
            &format!(
                "three for every bone that moves: the two angles of {} would be off by {} degrees in frame {} \
                 (counted from 0)",
                printable(bone),
                number(freed.degrees, 3),
                freed.frame
            ),
        );
    }
    Ok(said + &changes)
}

/// Which frames were warped.
fn made_of(map: TimeMap) -> String {
    let old = count(map.old_count(), "frame", "frames");
    fact(
        "warped",
        &match map {
            TimeMap::Whole { .. } => format!("from {old}"),
            TimeMap::Stretch { first, last, new, .. } => {
                format!("from {old}: {} between {first} and {last} became {new}", last - first)
            }
        },
    )
}

/// A bar in the terminal for the frames that are written.
fn frames_bar(map: TimeMap) -> ProgressBar {
    bar(map.frame_count(), "{bar:40} {pos} of {len} frames, {eta} left")
}
