//! From a pose to the figure that is drawn.

use glam::{Quat, Vec3};
use skeleton::acclaim::BonePlace;
use skeleton::{Joint, Pose, Skeleton};

use super::Stage;
use crate::motion::body;
use crate::scene::{Axes, Bone, Dot, Figure, Look, Off, Side};

/// How a figure is to be.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted<'a> {
    /// The part that it plays.
    pub look: Look,
    /// Whether its joints get axes.
    pub axes: bool,
    /// Where its joints should be; a pose of the same skeleton.
    pub expected: Option<&'a Pose>,
    /// Whether joints tell how far they are off.
    pub judged: bool,
    /// The joint to look at.
    pub selected: Option<usize>,
    /// Where the bones start and end for which the joints stand; nothing for one that is not to be drawn.
    pub places: Option<&'a [Option<BonePlace>]>,
}

impl Stage {
    /// How much room the figure takes along a direction of the picture's world, of length 1, in all that it does around its
    /// anchor. Positive.
    pub fn breadth(&self, direction: Vec3) -> f32 {
        let along = self.surroundings.iter().map(|place| place.dot(direction));
        let (low, high) = along.fold((0.0f32, 0.0f32), |(low, high), at| (low.min(at), high.max(at)));
        let breadth = high - low;
        if breadth.is_normal() { breadth } else { 0.5 * self.size }
    }

    /// The skeleton in `pose`. `axes` says whether its joints get axes.
    pub fn figure(&self, pose: &Pose, look: Look, axes: bool) -> Figure {
        let mut figure = Figure::default();
        self.fill(&mut figure, pose, &Wanted { look, axes, ..Wanted::default() });
        figure
    }

    /// Makes `figure` the skeleton in `pose`. Its memory is used again.
    pub fn fill(&self, figure: &mut Figure, pose: &Pose, wanted: &Wanted) {
        figure.look = wanted.look;
        figure.bones.clear();
        figure.joints.clear();
        figure.axes.clear();
        for (joint, transform) in self.motion.skeleton().joints().iter().zip(pose.transforms()) {
            let place = self.place(transform.position);
            let expected = wanted.expected.filter(|_| wanted.judged);
            let right = expected.map_or(place, |expected| self.place(expected[joint.id].position));
            let selected = wanted.selected == Some(joint.id.0);
            figure.joints.push(Dot { place, off: Off::by(place.distance(right) / self.size), selected });
            if let Some(parent) = joint.parent {
                let side = self.sides[joint.id.0];
                let (from, to) =
                    self.bone(wanted, parent.0).unwrap_or((pose[parent].position, transform.position));
                let (from, to) = (self.place(from), self.place(to));
                let own = self.radii[joint.id.0];
                let radius = wanted.expected.map_or(own, |expected| {
                    let right = expected[joint.id].position.distance(expected[parent].position);
                    body::misplaced(own, right, from.distance(to))
                });
                let joints = (parent.0, joint.id.0);
                figure.bones.push(Bone { from, to, side, radius, joints });
            }
            if wanted.axes && !joint.is_end_site {
                // A bone turns about axes of its own.
                let own = self.bones.as_ref().map_or(Quat::IDENTITY, |bones| bones.own_axes(joint.id.0));
                let rotation = self.upright * transform.rotation * own;
                let lettered = if wanted.selected.is_some() { selected } else { joint.is_root() };
                let length = self.axes[joint.id.0] * if lettered { LETTERED } else { 1.0 };
                figure.axes.push(Axes { origin: place, rotation, length, lettered });
            }
        }
    }
}

impl Stage {
    /// From where to where the bone leads that starts at `joint` (from 0): a student's bones need not start where their parents
    /// end, and need not be all there. `None` where joints stand for no bones.
    fn bone(&self, wanted: &Wanted, joint: usize) -> Option<(Vec3, Vec3)> {
        let (places, bones) = (wanted.places?, self.bones.as_ref()?);
        let place = places.get(bones.of_joint(joint).0).copied().flatten();
        Some(place.map_or((Vec3::NAN, Vec3::NAN), |place| (place.start, place.end)))
    }
}

/// How much longer axes with letters are than others.
const LETTERED: f32 = 1.6;

/// How long the axes of each joint are drawn in a figure of this size: shorter where the bones are short, so that those of
/// fingers do not cover the hand.
pub(super) fn axes(skeleton: &Skeleton, size: f32) -> Vec<f32> {
    let mut longest = vec![0.0f32; skeleton.len()];
    for joint in skeleton.joints() {
        if let Some(parent) = joint.parent {
            for end in [joint.id, parent] {
                longest[end.0] = longest[end.0].max(joint.offset.length());
            }
        }
    }
    longest.into_iter().map(|bone| (0.45 * bone).max(0.014 * size).min(0.045 * size)).collect()
}

/// Of joints at which nothing hangs, those that leave traces: of some that are close together, like the tips of fingers,
/// the one that is farthest from the root. `rest` are the places of all joints at rest, and `size` is the figure's.
pub(super) fn traced(tips: &[usize], rest: &[Vec3], sides: &[Side], size: f32) -> Vec<usize> {
    const CLOSE: f32 = 0.09;
    let from_root = |tip: &usize| rest[*tip].distance(rest[0]);
    let mut farthest_first = tips.to_vec();
    farthest_first.sort_by(|a, b| from_root(b).total_cmp(&from_root(a)));
    let mut traced: Vec<usize> = Vec::new();
    for tip in farthest_first {
        // The tips of two feet stand close together too, one on each side.
        let apart =
            |other: &usize| sides[*other] != sides[tip] || rest[*other].distance(rest[tip]) > CLOSE * size;
        if traced.iter().all(apart) {
            traced.push(tip);
        }
    }
    traced.sort_unstable();
    traced
}

/// The joints that are no other's parent.
pub(crate) fn tips(joints: &[Joint]) -> Vec<usize> {
    let mut tips = vec![true; joints.len()];
    for parent in joints.iter().filter_map(|joint| joint.parent) {
        tips[parent.0] = false;
    }
    (0..joints.len()).filter(|joint| tips[*joint]).collect()
}

#[cfg(test)]
mod tests {
    use skeleton::{JointId, PositionChannels};

    use super::*;
    use crate::motion::upright::Up;
    use crate::samples;

    fn stage(up: Option<Up>) -> Stage {
        Stage::with_up(samples::chain(4, 1.0), PositionChannels::Replace, up)
    }

    #[test]
    fn joints_tell_how_far_they_are_off_and_which_one_is_selected() {
        let stage = stage(None);
        let expected = stage.reference(1);
        let mut given = expected.clone();
        for (joint, share) in [(1, 0.5 * Off::LITTLE), (2, 0.5 * Off::SOME), (3, 2.0 * Off::SOME)] {
            given[JointId(joint)].position.x += share * stage.size();
        }
        given[JointId(4)].position.y = f32::NAN;
        let mut figure = stage.figure(&expected, Look::Ghost, true);
        let wanted = Wanted {
            expected: Some(&expected),
            judged: true,
            selected: Some(2),
            axes: true,
            ..Wanted::default()
        };
        stage.fill(&mut figure, &given, &wanted);
        let offs: Vec<Off> = figure.joints.iter().map(|dot| dot.off).collect();
        assert_eq!(offs, [Off::Right, Off::Little, Off::Some, Off::Much, Off::Much]);
        let selected: Vec<bool> = figure.joints.iter().map(|dot| dot.selected).collect();
        assert_eq!(selected, [false, false, true, false, false]);
        let mut unjudged = Figure::default();
        stage.fill(&mut unjudged, &given, &Wanted { judged: false, ..wanted });
        assert!(unjudged.joints.iter().all(|dot| dot.off == Off::Right || !dot.place.is_finite()));
        assert_eq!(
            (figure.bones.len(), figure.axes.len()),
            (4, 3),
            "a figure that is filled anew holds one skeleton"
        );
    }

    #[test]
    fn a_figure_stands_upright_whatever_the_file_calls_up() {
        let (y, z) = (stage(Some(Up::Y)), stage(Some(Up::Z)));
        let (a, b) =
            (y.figure(&y.reference(2), Look::Solid, true), z.figure(&z.reference(2), Look::Solid, true));
        for (a, b) in a.joints.iter().zip(&b.joints) {
            assert_eq!(b.place, Up::Z.rotation() * a.place);
        }
        let turned = |q: Quat| q * Vec3::X;
        for (a, b) in a.axes.iter().zip(&b.axes) {
            assert!((Up::Z.rotation() * turned(a.rotation)).abs_diff_eq(turned(b.rotation), 1e-5));
        }
    }

    #[test]
    fn tips_are_end_sites_and_leaves_without_one() {
        assert_eq!(tips(samples::chain(1, 1.0).skeleton().joints()), [2, 4]);
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "r", Vec3::ZERO, []).unwrap();
        skeleton.add_joint(Some(root), "leaf", Vec3::Y, []).unwrap();
        assert_eq!(tips(skeleton.joints()), [1]);
    }

    #[test]
    fn axes_are_short_where_bones_are_short() {
        let mut skeleton = Skeleton::new();
        let mut parent = None;
        for length in [0.0, 5.0, 0.1, 1e-9] {
            parent = Some(skeleton.add_joint(parent, "j", Vec3::X * length, []).unwrap());
        }
        skeleton.add_joint(parent, "j", Vec3::NAN, []).unwrap();
        let axes = axes(&skeleton, 5.1);
        assert_eq!((axes[0], axes[1]), (axes[1], 0.045 * 5.1));
        assert!(axes[2] < 0.1 && axes[3] < 0.1, "{axes:?}");
        assert!(axes.iter().all(|length| *length > 0.0), "{axes:?}");
    }

    #[test]
    fn of_tips_that_are_close_together_one_leaves_a_trace() {
        let rest = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 0.01, 0.0), Vec3::new(1.02, 0.0, 0.0), -Vec3::Y];
        let same = [Side::Middle; 5];
        assert_eq!(traced(&[1, 2, 3, 4], &rest, &same, 1.0), [3, 4]);
        assert_eq!(traced(&[1, 2, 3, 4], &rest, &same, 0.01), [1, 2, 3, 4]);
        let feet = [Side::Middle, Side::Left, Side::Right, Side::Left, Side::Middle];
        assert_eq!(traced(&[1, 2, 3, 4], &rest, &feet, 1.0), [2, 3, 4]);
        assert!(traced(&[], &[], &[], 1.0).is_empty());
        assert_eq!(traced(&[1, 2], &[Vec3::NAN; 3], &same, 1.0).len(), 1);
    }

    #[test]
    fn bones_that_are_too_long_are_thin() {
        let stage = stage(None);
        let expected = stage.reference(1);
        let mut given = expected.clone();
        given[JointId(2)].position.y -= 10.0;
        let wanted = Wanted { expected: Some(&expected), ..Wanted::default() };
        let mut figure = Figure::default();
        stage.fill(&mut figure, &given, &wanted);
        let radius = |figure: &Figure, bone: usize| figure.bones[bone].radius;
        let right = stage.figure(&expected, Look::Solid, false);
        assert!(radius(&figure, 1) < 0.5 * radius(&right, 1));
        assert!((radius(&figure, 0) / radius(&right, 0) - 1.0).abs() < 1e-3);
    }
}
