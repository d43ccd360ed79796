//! The rows of a warped motion, of joints or of bones.

use glam::Quat;
use parser::angles::{angles_of, distance, rotation_of};
use skeleton::Axis;
use skeleton::acclaim::Between;

use crate::motion::time_map::TimeMap;
use crate::output::edit::LEAST_MISFIT;

/// The numbers of a row that together are the rotation of a joint or a bone.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    /// The axes of the rotations, at most three; the first one leftmost in the product.
    pub axes: Vec<Axis>,
    /// Where the angle about each of them stands in a row.
    pub columns: Vec<usize>,
}

/// By how many degrees a rotation is off at most, and in which frame that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Off {
    pub degrees: f64,
    pub frame: usize,
}

/// Makes the rows of a warped motion, in order. A frame that is one of the old motion's has its numbers. Between two of
/// them everything turns the shorter way round about one axis, by angles that go on from the row before, and moves straight.
#[derive(Debug)]
pub(super) struct Rows<'a> {
    map: TimeMap,
    width: usize,
    /// The old motion's rows, one behind the other.
    values: &'a [f32],
    turns: Vec<Turn>,
    /// The columns that are no angle.
    straight: Vec<usize>,
    /// The old frames for which `ends` has been worked out.
    between: Option<(usize, usize)>,
    /// For each turn how it begins and ends between two old frames; `None` where nothing changes.
    ends: Vec<Option<[Quat; 2]>>,
    row: Vec<f32>,
    off: Vec<Option<Off>>,
}

impl<'a> Rows<'a> {
    /// Of a motion of `width` numbers a row. Numbers that belong to no turn go straight.
    pub fn new(map: TimeMap, width: usize, values: &'a [f32], turns: Vec<Turn>) -> Rows<'a> {
        let mut is_angle = vec![false; width];
        turns.iter().flat_map(|turn| &turn.columns).for_each(|column| is_angle[*column] = true);
        Rows {
            map,
            width,
            values,
            straight: (0..width).filter(|column| !is_angle[*column]).collect(),
            between: None,
            ends: vec![None; turns.len()],
            row: vec![0.0; width],
            off: vec![None; turns.len()],
            turns,
        }
    }

    /// The row of frame `index` (from 0), the one behind that of the call before; `None` when the old motion does not have
    /// what belongs there.
    pub fn row(&mut self, index: usize) -> Option<&[f32]> {
        let Between { before, after, t } = self.map.place(index);
        let (first, second) = (self.old(before)?, self.old(after)?);
        if before == after || t == 0.0 {
            self.row.copy_from_slice(first);
            return Some(&self.row);
        }
        if self.between != Some((before, after)) {
            self.between = Some((before, after));
            for (ends, turn) in self.ends.iter_mut().zip(&self.turns) {
                let is_still = turn.columns.iter().all(|column| first[*column] == second[*column]);
                *ends = (!is_still).then(|| [first, second].map(|row| rotation(turn, row)));
            }
        }
        for column in &self.straight {
            let [from, to] = [first, second].map(|row| f64::from(row[*column]));
            self.row[*column] = (from + f64::from(t) * (to - from)) as f32;
        }
        for ((turn, ends), off) in self.turns.iter().zip(&self.ends).zip(&mut self.off) {
            let Some([from, to]) = *ends else {
                turn.columns.iter().for_each(|column| self.row[*column] = first[*column]);
                continue;
            };
            let rotation = (solutions::INTERPOLATION.slerp)(from, to, t);
            let mut near = [0.0; 3];
            for (near, column) in near.iter_mut().zip(&turn.columns) {
                *near = self.row[*column].into();
            }
            let angles = angles_of(rotation, &turn.axes, near);
            for (angle, column) in angles.into_iter().zip(&turn.columns) {
                self.row[*column] = angle as f32;
            }
            // Three angles make any rotation.
            if turn.axes.len() < 3 {
                let degrees = distance(rotation, &turn.axes, angles);
                if degrees > off.map_or(LEAST_MISFIT, |off| off.degrees) {
                    *off = Some(Off { degrees, frame: index });
                }
            }
        }
        Some(&self.row)
    }

    /// For each turn by how much it was off in the rows so far, where its angles could not make it.
    pub fn off(&self) -> &[Option<Off>] {
        &self.off
    }

    fn old(&self, frame: usize) -> Option<&'a [f32]> {
        let values: &'a [f32] = self.values;
        values.get(frame.checked_mul(self.width)?..)?.get(..self.width)
    }
}

/// The rotation that the angles of a row make.
fn rotation(turn: &Turn, row: &[f32]) -> Quat {
    rotation_of(&turn.axes, turn.columns.iter().map(|column| row[*column]))
}
