//! The frames of a warped motion. Each is made when it is asked for, so that any number of them takes no memory.

use glam::Quat;
use parser::angles::angles_of;
use skeleton::acclaim::Between;
use skeleton::{Axis, Frame, FrameCursor};

use super::Stage;
use crate::motion::time_map::TimeMap;

impl Stage {
    /// The same figure in the frames that `warp` says. It is looked at as before.
    #[must_use]
    pub fn warped(&self, warp: TimeMap) -> Stage {
        Stage { warp: Some(warp), ..self.clone() }
    }

    /// How the motion is warped, if it is.
    pub fn warp(&self) -> Option<TimeMap> {
        self.warp
    }

    /// Frame `index` (from 0) of the motion warped so: between two frames every joint turns the shorter way round about one
    /// axis, and moves straight. After the last frame it is the rest pose. The memory of `frame` and of `next` is used again.
    pub(super) fn read_warped(&self, warp: &TimeMap, index: usize, frame: &mut Frame, next: &mut Frame) {
        if index >= warp.frame_count() {
            return self.motion.read_frame(self.motion.frame_count(), self.positions, frame);
        }
        let Between { before, after, t } = warp.place(index);
        self.motion.read_frame(before, self.positions, frame);
        if before == after || t == 0.0 {
            return;
        }
        self.motion.read_frame(after, self.positions, next);
        let joints = self.motion.skeleton().joints().iter();
        let turning = joints.filter_map(|joint| Some((joint, joint.rotation_order.axes()?)));
        let angles = frame.angles.as_chunks_mut().0.iter_mut().zip(next.angles.as_chunks().0);
        for ((joint, axes), (angles, next)) in turning.zip(angles) {
            let turn =
                |angles: &[f32; 3]| (solutions::FK.local_quaternion)(joint, &mut FrameCursor::new(angles));
            let (from, to) = (turn(angles), turn(next));
            *angles = between(from, to, t, axes, *angles);
        }
        for (position, next) in frame.local_positions.iter_mut().zip(&next.local_positions) {
            *position = position.lerp(*next, t);
        }
    }
}

/// The angles about `axes`, in degrees, of what is between two rotations: of all that mean the same those closest to `near`.
fn between(from: Quat, to: Quat, t: f32, axes: [Axis; 3], near: [f32; 3]) -> [f32; 3] {
    let rotation = (solutions::INTERPOLATION.slerp)(from, to, t);
    angles_of(rotation, &axes, near.map(f64::from)).map(|angle| angle as f32)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;
    use skeleton::PositionChannels;

    use super::*;
    use crate::samples;

    fn stage() -> Stage {
        Stage::new(samples::chain(9, 1.0), PositionChannels::Replace)
    }

    #[test]
    fn frames_that_are_old_ones_are_those_to_the_last_bit() {
        let stage = stage();
        for factor in [1, 2, 3, 7] {
            let warped = stage.warped(TimeMap::Whole { old: 9, new: 9 * factor });
            assert_eq!(warped.moving_frames(), 9 * factor);
            for old in 0..9 {
                assert_eq!(warped.frame(old * factor), stage.frame(old), "{factor}, {old}");
            }
        }
    }

    #[test]
    fn half_way_the_root_is_half_way_and_every_joint_half_turned() {
        let stage = stage();
        let warped = stage.warped(TimeMap::Whole { old: 9, new: 18 });
        let (before, after, between) = (stage.frame(3), stage.frame(4), warped.frame(7));
        let middle = before.local_positions[0].midpoint(after.local_positions[0]);
        assert!(between.local_positions[0].abs_diff_eq(middle, 1e-6));
        // The limb turns about Z alone, but for a constant.
        let middle = 0.5 * (before.angles[3] + after.angles[3]);
        assert!((between.angles[3] - middle).abs() < 0.05, "{between:?} {middle}");
        assert!(between.angles[3] != before.angles[3]);
    }

    #[test]
    fn a_warp_to_no_frames_shows_the_rest_pose() {
        let stage = stage();
        let warped = stage.warped(TimeMap::Whole { old: 9, new: 0 });
        assert_eq!((warped.moving_frames(), warped.frame_count()), (0, 1));
        assert_eq!(warped.frame(0), stage.frame(9));
        assert!(warped.frames().is_empty());
    }

    #[test]
    fn a_million_frames_are_there_at_once() {
        let stage = stage();
        let warped = stage.warped(TimeMap::Whole { old: 9, new: 1_000_000 });
        assert_eq!(warped.frame_count(), 1_000_000);
        assert_eq!(warped.frame(999_999), stage.frame(8));
        let place = |stage: &Stage, index: usize| stage.reference(index).transforms()[0].position;
        let (a, b) = (place(&stage, 4), place(&stage, 5));
        assert!(place(&warped, 500_000).abs_diff_eq(a.lerp(b, 0.5), 1e-5));
        assert_ne!(place(&warped, 500_000), Vec3::ZERO);
    }

    proptest! {
        #[test]
        fn every_frame_lies_between_its_neighbours(new in 1usize..60, index in 0usize..60) {
            let stage = stage();
            let map = TimeMap::Whole { old: 9, new };
            let (warped, index) = (stage.warped(map), index % new);
            let Between { before, after, t } = map.place(index);
            let turned = |stage: &Stage, index: usize| stage.reference(index).transforms()[1].rotation;
            let expected = turned(&stage, before).slerp(turned(&stage, after), t);
            let off = grading::fk::angle_between(turned(&warped, index), expected);
            // The limb turns on a root that turns, too: its way in the world is not the shortest one, but near it.
            prop_assert!(off < 1.0, "{off}");
            let positions = warped.frame(index).local_positions;
            let ends = [before, after].map(|old| stage.frame(old).local_positions[0]);
            prop_assert!(positions[0].abs_diff_eq(ends[0].lerp(ends[1], t), 1e-5));
        }
    }
}
