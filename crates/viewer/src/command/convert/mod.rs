//! Motions as other files: of joints or of bones, and warped.

mod arguments;
mod facts;
mod lost;
mod warped;

use std::borrow::Cow;
use std::path::Path;

use parser::{acclaim, bvh};
use skeleton::acclaim::Motion as BoneMotion;
use skeleton::{Channel, Motion, PositionChannels};

pub use arguments::{Format, OutArguments};
pub use facts::{beside, fact, not_written, warn};
pub use lost::of_bones as lost_with_bones;

use super::targets::shown;
use super::{Arguments, keyframes, say, text};
use crate::motion::source::{Loaded, Source};
use crate::motion::stage::Stage;
use crate::output::beside::{write_both, write_whole};
use crate::view::texts::count;

/// Sees to it that nothing is said of new files that means nothing for them.
///
/// # Errors
///
/// When something is.
pub fn check(arguments: &Arguments) -> Result<(), String> {
    let out = arguments.out.path();
    arguments.keyframes.check_mode(out.is_none())?;
    let is_skeleton = out.is_some_and(|path| Format::of(path) == Format::Asf);
    let (warp, keyframes) = (arguments.warp.warping().is_some(), arguments.keyframes.given().next());
    match keyframes {
        Some(option) if warp && !arguments.new_files().is_empty() => Err(format!(
            "{option} is about keyframes and cannot be used with --warp or --between: write the warped motion with \
             --out, and reduce that file"
        )),
        Some(option) if is_skeleton => Err(format!(
            "{option} means nothing for a skeleton alone: --out NAME.amc writes it with its motion"
        )),
        None if is_skeleton && warp => {
            Err("a skeleton alone cannot be warped: --out NAME.amc writes it with its motion".into())
        }
        _ => Ok(()),
    }
}

/// Writes the motion, the curves and the table that the command line asks for. The targets have been looked at.
///
/// # Errors
///
/// When there are several motions, or one cannot be read, told in the other format's words, or written.
pub fn write(arguments: &Arguments, sources: &[Source]) -> Result<(), String> {
    // The original stands beside a motion that is warped.
    let is_warped = arguments.warp.warping().is_some();
    let wanted: Vec<&Source> = sources.iter().filter(|source| source.warp.is_some() == is_warped).collect();
    let out = arguments.out.path();
    match (&wanted[..], out) {
        ([source], Some(path)) if !reduces(arguments, source, path) => convert(source, path),
        ([source], _) => keyframes::write(&arguments.keyframes, out, source),
        (all, None) => Err(format!("keyframes are those of one motion, and there are {} files", all.len())),
        (all, Some(_)) => Err(format!("--out writes one motion, and there are {} files", all.len())),
    }
}

/// Whether what is written is reduced to keyframes: where they are spoken of, and from BVH to BVH, where nothing else could be
/// meant.
fn reduces(arguments: &Arguments, source: &Source, out: &Path) -> bool {
    let from_bvh_to_bvh = !source.has_bones() && Format::of(out) == Format::Bvh && source.warp.is_none();
    arguments.keyframes.given().next().is_some() || from_bvh_to_bvh
}

/// Reads a motion, and tells in the terminal what is odd about its files.
///
/// # Errors
///
/// When they are no motion.
pub fn read(source: &Source) -> Result<Loaded, String> {
    let loaded = source.read().map_err(text)?;
    for warning in &loaded.warnings {
        eprintln!("{}: {warning}", source.title());
    }
    Ok(loaded)
}

fn convert(source: &Source, path: &Path) -> Result<(), String> {
    let loaded = read(source)?;
    let (stage, format) = (loaded.stage, Format::of(path));
    let has_frames = stage.motion().frame_count() > 0;
    let needs_frames = source.warp.is_some() || matches!(format, Format::Amc { .. });
    if needs_frames && !has_frames {
        let else_ = match source.warp {
            Some(_) => "nothing to warp",
            None => "no motion of bones: --out NAME.asf writes the skeleton alone",
        };
        return Err(format!("{}: there are no frames, and so {else_}", source.title()));
    }
    let said = match (stage.warp(), &format) {
        (Some(map), Format::Bvh) => warped::write_joints(source, &stage, map, path)?,
        (Some(map), Format::Amc { skeleton }) => warped::write_bones(source, &stage, map, [skeleton, path])?,
        (_, Format::Asf) => {
            let (bones, changes) = bones(source, &stage)?;
            write_whole(path, |out| acclaim::write_skeleton(bones.skeleton(), out))
                .map_err(|error| not_written("skeleton", path, &error))?;
            facts::bones(bones.skeleton()) + &changes
        }
        (None, Format::Bvh) => {
            write_whole(path, |out| bvh::write(stage.motion(), out))
                .map_err(|error| not_written("motion", path, &error))?;
            facts::joints(stage.motion(), stage.motion().frame_count()) + &made_joints(source, &stage)
        }
        (None, Format::Amc { skeleton }) => {
            let (bones, changes) = bones(source, &stage)?;
            write_pair([skeleton, path], &bones)?;
            let frames = count(bones.frame_count(), "frame", "frames");
            let seconds = stage.motion().playable_frame_time();
            format!("{frames}, {}{}{changes}", facts::bones(bones.skeleton()), beside(skeleton, seconds))
        }
    };
    say(&format!("{}: {said}", shown(path)))
}

/// What there is to know about joints beyond their number, where they were made of bones.
pub fn made_joints(source: &Source, stage: &Stage) -> String {
    match stage.bones() {
        Some(_) if stage.moving_frames() > 0 => facts::chosen_rate(source) + &lost_with_bones(stage),
        _ => lost_with_bones(stage),
    }
}

/// The motion of bones: as it was read, or the one that its joints stand for, and what is to be said of that.
fn bones<'a>(source: &Source, stage: &'a Stage) -> Result<(Cow<'a, BoneMotion>, String), String> {
    match stage.bones() {
        Some(bones) => Ok((Cow::Borrowed(bones.motion()), String::new())),
        None => to_bones(source, stage.motion()).map(|(bones, changes)| (Cow::Owned(bones), changes)),
    }
}

/// The same motion, of bones, and what is no longer as it was.
///
/// # Errors
///
/// When bones cannot move so: with the joint and the frame.
pub fn to_bones(source: &Source, motion: &Motion) -> Result<(BoneMotion, String), String> {
    let converted = match source.positions {
        PositionChannels::Replace => acclaim::to_bones_by_joint(motion),
        PositionChannels::Add => acclaim::to_bones_by_joint(&replacing(motion)),
    };
    let (bones, of_joints) = converted.map_err(|error| format!("{}: {error}", source.title()))?;
    let changes = lost::of_joints(motion, bones.skeleton(), &of_joints);
    Ok((bones, changes))
}

/// The same motion of position channels that take the place of OFFSETs, where they are added to them.
fn replacing(motion: &Motion) -> Motion {
    let joints = motion.skeleton().joints().iter();
    let added: Vec<f32> = joints
        .flat_map(|joint| joint.channels.iter().map(|channel| (joint.offset, *channel)))
        .map(|(offset, channel)| match channel {
            Channel::Position(axis) => offset[axis.index()],
            Channel::Rotation(_) => 0.0,
        })
        .collect();
    let values = motion.values().iter().zip(added.iter().cycle()).map(|(value, added)| value + added);
    let (skeleton, frames) = (motion.skeleton().clone(), motion.frame_count());
    let same = Motion::new(skeleton, frames, motion.frame_time(), values.collect());
    same.unwrap_or_else(|_| motion.clone())
}

/// Writes a motion of bones: its skeleton, and itself.
///
/// # Errors
///
/// When a file cannot be written. Then neither of them has been.
pub fn write_pair([skeleton, path]: [&Path; 2], motion: &BoneMotion) -> Result<(), String> {
    write_both([skeleton, path], |bones, frames| {
        acclaim::write_skeleton(motion.skeleton(), bones)?;
        acclaim::write_motion(motion, frames)
    })
    .map_err(|error| facts::pair_not_written(skeleton, path, &error))
}
