//! Warped motions of joints.

use std::io::{self, Write};

use parser::bvh::Writer;
use skeleton::{Joint, Motion};

use super::rows::{Off, Rows, Turn};
use super::{Tick, another_motion};
use crate::motion::time_map::TimeMap;
use crate::output::edit::{Misfit, turns};

/// Writes `motion`, warped by `map`, as BVH: the same skeleton, channels and frame time. `tick` is called with the number of
/// frames that are written. Gives the joints whose channels cannot hold all of their rotations, in the order of the
/// joints: only such with one or two rotation channels. The nearest rotations are there instead.
///
/// # Errors
///
/// When `out` fails, the format cannot hold the motion, or `map` is one of another motion.
pub fn write_joints(
    motion: &Motion,
    map: TimeMap,
    out: impl Write,
    tick: &mut Tick,
) -> io::Result<Vec<Misfit>> {
    let (mut turning, mut joints, mut column) = (Vec::new(), Vec::new(), 0);
    for joint in motion.skeleton().joints() {
        let (columns, axes): (Vec<usize>, _) = turns(joint).map(|(at, axis)| (column + at, axis)).unzip();
        if !columns.is_empty() {
            turning.push(Turn { axes, columns });
            joints.push(joint);
        }
        column += joint.channels.len();
    }
    let mut rows = Rows::new(map, column, motion.values(), turning);
    let mut writer = Writer::new(motion.skeleton(), map.frame_count(), motion.frame_time(), out)?;
    for index in 0..map.frame_count() {
        writer.write_row(rows.row(index).ok_or_else(another_motion)?)?;
        tick(index + 1);
    }
    writer.finish()?;
    let misfit = |(joint, off): (&&Joint, &Option<Off>)| {
        let off = (*off)?;
        let channels = turns(joint).count();
        Some(Misfit { joint: joint.id, channels, degrees: off.degrees, frame: off.frame })
    };
    Ok(joints.iter().zip(rows.off()).filter_map(misfit).collect())
}
