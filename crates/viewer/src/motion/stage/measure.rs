//! What a motion's poses say about it: which way is up, how large it is, where its ground is.

use glam::Vec3;
use skeleton::{Frame, Pose};

use super::Stage;
use crate::draw::canvas::Ground;
use crate::motion::upright::{Stance, Up};

/// The most frames that are looked at to learn how large a motion is, and the most joints in all of them together.
const MOST_SAMPLES: usize = 120;
const MOST_SAMPLED_JOINTS: usize = 1_000_000;

/// Single precision has about seven digits: this many skeletons away from the origin the joints are no longer where
/// they should be.
const LARGEST_COORDINATE: f32 = 1e6;

impl Stage {
    pub(super) fn find_up(&self) -> Up {
        let mut stance = Stance::new(self.motion.skeleton().joints());
        self.sample(|_, pose| stance.look(pose));
        stance.up()
    }

    pub(super) fn measure(&mut self) {
        let (mut all, mut roots) = (Bounds::default(), Bounds::default());
        let (mut first_root, mut ways) = (None, Vec::new());
        self.sample(|stage, pose| {
            stage.places(pose).for_each(|place| all.add(place));
            let root = stage.root(pose);
            roots.add(root);
            if root.is_finite() {
                ways.push(root - *first_root.get_or_insert(root));
            }
        });

        // A skeleton without length may still move; one that does not is a single point, of any size.
        let usable = |size: &f32| size.is_finite() && *size > 0.0;
        let sizes = [self.motion.skeleton().extent(), all.low.distance(all.high)];
        self.size = sizes.into_iter().find(usable).unwrap_or(1.0);

        let farthest = roots.low.abs().max(roots.high.abs()).max_element();
        self.too_coarse = !sizes[0].is_finite() || farthest > LARGEST_COORDINATE * self.size;

        // Most motions stand on the plane Y = 0. For one that clearly does not, the ground is below its lowest point.
        let height = if all.low.y.abs() < 0.3 * self.size { 0.0 } else { all.low.y };
        self.ground = Ground { height, cell: round_number(0.3 * self.size) };

        self.level = (roots.high.y - roots.low.y < self.size).then_some(roots.low.y.midpoint(roots.high.y));
        let mut around = Bounds::default();
        self.sample(|stage, pose| {
            let anchor = stage.anchor_of(pose);
            stage.places(pose).for_each(|place| around.add(place - anchor));
        });
        let corner =
            |i: usize| Vec3::from([0, 1, 2].map(|axis| [around.low, around.high][i >> axis & 1][axis]));
        self.surroundings = (0..8).map(corner).collect();

        // From ahead of a figure that sets out for somewhere, and to its side.
        if let Some(way) = ways.into_iter().find(|way| way.length() > 0.5 * self.size) {
            self.azimuth = (way.x.atan2(way.z) + 0.9).rem_euclid(std::f32::consts::TAU);
        }
    }

    /// Looks at poses from all over the motion, fewer when each has more joints. There is never more than one of them
    /// in memory.
    fn sample(&self, mut look: impl FnMut(&Stage, &Pose)) {
        let joints = self.motion.skeleton().len().max(1);
        let samples = (MOST_SAMPLED_JOINTS / joints).clamp(1, MOST_SAMPLES);
        let step = self.frame_count().div_ceil(samples);
        let (mut frame, mut pose) = (Frame::default(), Pose::default());
        for index in (0..self.frame_count()).step_by(step) {
            self.read_reference(index, &mut frame, &mut pose);
            look(self, &pose);
        }
    }
}

/// The box around points; only the origin when there are none.
#[derive(Default)]
struct Bounds {
    low: Vec3,
    high: Vec3,
    some: bool,
}

impl Bounds {
    /// Makes room for `point`, if it is made of numbers.
    fn add(&mut self, point: Vec3) {
        if point.is_finite() {
            let (low, high) = if self.some { (self.low, self.high) } else { (point, point) };
            (self.low, self.high, self.some) = (low.min(point), high.max(point), true);
        }
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above `number`.
fn round_number(number: f32) -> f32 {
    let power = 10f32.powf(number.log10().floor());
    let rounded =
        [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|round| *round <= number * 1.0001);
    rounded.filter(|round| round.is_normal()).unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use skeleton::{Motion, PositionChannels};

    use super::*;

    #[test]
    fn a_round_number_is_one_two_or_five() {
        for (number, round) in
            [(0.59, 0.5), (19.9, 10.0), (20.0, 20.0), (999.0, 500.0), (1.0, 1.0), (0.0021, 0.002)]
        {
            assert!((round_number(number) / round - 1.0).abs() < 1e-5, "{number}: {}", round_number(number));
        }
        assert!(round_number(0.0) == 0.0 && round_number(1e-42) > 0.0);
    }

    #[test]
    fn what_is_looked_at_does_not_grow_with_frames_times_joints() {
        let frames = |joints: usize, count: usize| {
            let mut skeleton = skeleton::Skeleton::new();
            for _ in 0..joints {
                skeleton.add_joint(None, "j", Vec3::Y, []).unwrap();
            }
            let stage =
                Stage::new(Motion::new(skeleton, count, 0.1, Vec::new()).unwrap(), PositionChannels::Replace);
            let mut looked = 0;
            stage.sample(|_, _| looked += 1);
            looked
        };
        assert_eq!(frames(30, 50), 50);
        assert_eq!(frames(30, 120_000), MOST_SAMPLES);
        assert_eq!(frames(MOST_SAMPLED_JOINTS / 10, 500), 10);
        assert_eq!(frames(MOST_SAMPLED_JOINTS + 1, 500), 1);
    }

    #[test]
    fn coordinates_too_large_for_single_precision_are_noticed() {
        let stage = |offset: Vec3, root: f32| {
            let mut skeleton = skeleton::Skeleton::new();
            let position = vec![skeleton::Channel::from_word("Xposition").unwrap()];
            let parent = skeleton.add_joint(None, "r", Vec3::ZERO, position).unwrap();
            skeleton.add_end_site(parent, "End Site", offset).unwrap();
            Stage::new(Motion::new(skeleton, 2, 0.1, vec![0.0, root]).unwrap(), PositionChannels::Replace)
        };
        assert!(!stage(Vec3::Y, 1e5).is_too_coarse());
        assert!(!stage(Vec3::Y * 1e12, 1e5).is_too_coarse());
        assert!(!stage(Vec3::Y * 1e-7, 1e-5).is_too_coarse());
        assert!(stage(Vec3::Y, -1e8).is_too_coarse());
        assert!(stage(Vec3::Y * 3e38, 0.0).is_too_coarse());
    }
}
