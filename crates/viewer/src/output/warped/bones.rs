//! Warped motions of bones.

use std::io::{self, Write};

use parser::acclaim::MotionWriter;
use skeleton::acclaim::{Bone, BoneId, Columns, Motion};
use skeleton::{Axis, Channel};

use super::rows::{Off, Rows, Turn};
use super::{Tick, another_motion};
use crate::motion::time_map::TimeMap;

/// A bone with two degrees of freedom that is to be turned as these cannot turn it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Freed {
    /// Which bone.
    pub bone: BoneId,
    /// By how many degrees it would be off.
    pub degrees: f64,
    /// In which frame of the new motion, from 0.
    pub frame: usize,
}

/// `motion` with as many angles as it takes to warp it by `map`: with all three for every bone that moves where some bone's
/// degrees of freedom cannot hold what is between two frames, and otherwise as it is. The first such bone is given, too. `tick`
/// is called with the number of frames that are done.
pub fn fitting(motion: Motion, map: TimeMap, tick: &mut Tick) -> (Motion, Option<Freed>) {
    let (bones, turns): (Vec<BoneId>, Vec<Turn>) =
        turns(&motion).into_iter().filter(|(_, turn)| turn.axes.len() == 2).unzip();
    let mut freed = None;
    if !turns.is_empty() {
        let mut rows = Rows::new(map, motion.columns().len(), motion.values(), turns);
        for index in 0..map.frame_count() {
            rows.row(index);
            let off = |(bone, off): (&BoneId, &Option<Off>)| {
                off.map(|off| Freed { bone: *bone, degrees: off.degrees, frame: off.frame })
            };
            freed = bones.iter().zip(rows.off()).find_map(off);
            if freed.is_some() {
                break;
            }
            tick(index + 1);
        }
    }
    tick(map.frame_count());
    match freed {
        Some(_) => (with_three_angles(motion), freed),
        None => (motion, None),
    }
}

/// Writes `motion`, warped by `map`, as AMC: the same bones, each about its own axes. What its columns cannot hold becomes
/// what is nearest to it; see [`fitting`]. `tick` is called with the number of frames that are written.
///
/// # Errors
///
/// When `out` fails, the format cannot hold the motion, or `map` is one of another motion.
pub fn write_bones(motion: &Motion, map: TimeMap, out: impl Write, tick: &mut Tick) -> io::Result<()> {
    let columns = motion.columns();
    let turns = turns(motion).into_iter().map(|(_, turn)| turn).collect();
    let mut rows = Rows::new(map, columns.len(), motion.values(), turns);
    let mut writer = MotionWriter::new(columns, out)?;
    for index in 0..map.frame_count() {
        writer.write_row(rows.row(index).ok_or_else(another_motion)?)?;
        tick(index + 1);
    }
    writer.finish()
}

/// The same motion with numbers for all three rotations of every bone that moves.
fn with_three_angles(motion: Motion) -> Motion {
    let columns = motion.columns().clone().with_three_angles();
    let mut values = Vec::with_capacity(columns.len().saturating_mul(motion.frame_count()));
    for frame in 0..motion.frame_count() {
        let row = motion.row(frame).unwrap_or_default();
        for bone in motion.skeleton().bones() {
            let own = &row[motion.columns().range(bone.id)];
            values.extend_from_slice(own);
            // Those that are missing come last.
            values.extend((own.len()..columns.range(bone.id).len()).map(|_| 0.0));
        }
    }
    let frames = motion.frame_count();
    Motion::new(columns, frames, values).unwrap_or(motion)
}

/// The bones that turn, and what makes their rotations.
fn turns(motion: &Motion) -> Vec<(BoneId, Turn)> {
    let columns = motion.columns();
    let turn = |bone: &Bone| {
        let start = columns.range(bone.id).start;
        let own = columns.channels(bone.id);
        let axes = axes(motion, bone);
        let column = |axis: &Axis| own.iter().position(|channel| *channel == Channel::Rotation(*axis));
        let at: Vec<usize> = axes.iter().filter_map(column).map(|at| start + at).collect();
        (!axes.is_empty()).then_some((bone.id, Turn { axes, columns: at }))
    };
    motion.skeleton().bones().iter().filter_map(turn).collect()
}

/// The axes about which a bone is turned, the first one leftmost in the product. Where there are numbers for all three, a
/// bone that is only ever turned about one of them stays at that.
fn axes(motion: &Motion, bone: &Bone) -> Vec<Axis> {
    let columns: &Columns = motion.columns();
    let (width, start) = (columns.len(), columns.range(bone.id).start);
    let own = columns.channels(bone.id);
    let is_used = |at: usize| {
        let mut values = motion.values().iter().skip(start + at).step_by(width.max(1));
        values.any(|value| *value != 0.0)
    };
    let order = bone.rotation_order.axes().into_iter().flatten();
    let place = |axis: &Axis| own.iter().position(|channel| *channel == Channel::Rotation(*axis));
    let there: Vec<(Axis, usize)> = order.filter_map(|axis| Some((axis, place(&axis)?))).collect();
    let used = there.iter().filter(|(_, at)| is_used(*at)).count();
    let kept = |(_, at): &(Axis, usize)| !columns.has_three_angles() || used > 1 || is_used(*at);
    there.into_iter().filter(kept).map(|(axis, _)| axis).collect()
}
