//! The three parts together, over a whole motion.

use exam::fk::{Answer as FkAnswer, PosedFrame};
use exam::{Answer, Failure, Question};
use skeleton::{JointId, Skeleton, Transform};

use super::misconceptions::accepted;
use crate::compare::{POSITION_TOLERANCE, ROTATION_TOLERANCE, angle_between};
use crate::{Judge, TreeLine, Trouble, WholeReport};

/// Knows the right poses of a motion, and looks for the joint where others begin to go wrong.
#[derive(Debug)]
pub(super) struct RightPoses {
    pub skeleton: Skeleton,
    pub question: Question,
    pub expected: Answer,
}

impl Judge for RightPoses {
    fn judge(&self, answer: &Answer) -> WholeReport {
        let expected = poses(&self.expected);
        let Some(got) = poses_of(answer, expected) else {
            let why = "the poses do not fit the skeleton".to_owned();
            return WholeReport::failed(Failure::Unreadable { why });
        };
        let report = |trouble| {
            let frames = expected.len();
            let praise =
                format!("With your three functions every joint is in its place in all {frames} frames.");
            WholeReport { frames, praise, trouble }
        };
        let exact = Comparison { skeleton: &self.skeleton, size: self.skeleton.extent(), expected, got };
        if exact.first_wrong().is_none() {
            return report(None);
        }
        // The ways that part 1 accepts are accepted here too: what counts is the one under which all goes well for longest.
        let ways: Vec<Answer> =
            accepted("part1").iter().map(|way| self.question.ask(&way.functions)).collect();
        let by_ways = ways.iter().map(|answer| Comparison { expected: poses(answer), ..exact });
        let best =
            by_ways.chain([exact]).max_by_key(|way| way.first_wrong().unwrap_or((usize::MAX, JointId(0))));
        report(best.and_then(|comparison| comparison.trouble()))
    }
}

fn poses(answer: &Answer) -> &[PosedFrame] {
    match answer {
        Answer::Fk(FkAnswer::Poses(poses)) => poses,
        _ => &[],
    }
}

/// The poses, if they are as many and as large as they should be.
fn poses_of<'a>(got: &'a Answer, expected: &[PosedFrame]) -> Option<&'a [PosedFrame]> {
    let got = poses(got);
    let fits =
        got.len() == expected.len() && got.iter().zip(expected).all(|(g, e)| g.pose.len() == e.pose.len());
    fits.then_some(got)
}

#[derive(Clone, Copy)]
struct Comparison<'a> {
    skeleton: &'a Skeleton,
    size: f32,
    expected: &'a [PosedFrame],
    got: &'a [PosedFrame],
}

impl Comparison<'_> {
    fn trouble(&self) -> Option<Trouble> {
        let (frame, first) = self.first_wrong()?;
        let (worst, worst_frame) = self.worst();
        let label = |id| self.skeleton.label(id);
        Some(Trouble::Off {
            worst: format!(
                "{} is farthest off: by {} at frame {worst_frame}",
                label(worst),
                self.off_in_words(worst_frame, worst)
            ),
            first: label(first),
            frame,
            angles: self.angles(frame),
            tree: self.tree(frame, first),
        })
    }

    /// The first frame with a wrong joint, and the first such joint in it.
    fn first_wrong(&self) -> Option<(usize, JointId)> {
        let ids = || self.skeleton.joints().iter().map(|joint| joint.id);
        let mut all = (0..self.expected.len()).flat_map(|frame| ids().map(move |id| (frame, id)));
        all.find(|&(frame, id)| !self.is_right(frame, id))
    }

    fn is_right(&self, frame: usize, id: JointId) -> bool {
        let (distance, degrees) = self.off(frame, id);
        distance <= POSITION_TOLERANCE * self.size && degrees <= ROTATION_TOLERANCE
    }

    /// Distance and angle (degrees) between what came and what should have. What is no number is infinitely far off.
    fn off(&self, frame: usize, id: JointId) -> (f32, f64) {
        let [got, expected]: [Transform; 2] = [self.got[frame].pose[id], self.expected[frame].pose[id]];
        let distance = got.position.distance(expected.position);
        let degrees = angle_between(expected.rotation, got.rotation);
        (
            if distance.is_nan() { f32::INFINITY } else { distance },
            if degrees.is_nan() { 180.0 } else { degrees },
        )
    }

    /// Only what is wrong: the distance in the file's unit, the angle in degrees, or both.
    fn off_in_words(&self, frame: usize, id: JointId) -> String {
        let (distance, degrees) = self.off(frame, id);
        let far = (distance > POSITION_TOLERANCE * self.size).then(|| format!("{distance:.3}"));
        let turned = (degrees > ROTATION_TOLERANCE).then(|| format!("{degrees:.2}°"));
        far.into_iter().chain(turned).collect::<Vec<_>>().join(" and ")
    }

    /// The joint and frame with the largest distance; where all are in place, those with the largest angle.
    fn worst(&self) -> (JointId, usize) {
        let ids = self.skeleton.joints().iter().map(|joint| joint.id);
        let all = ids.flat_map(|id| (0..self.expected.len()).map(move |frame| (id, frame)));
        let rank = |(id, frame): &(JointId, usize)| {
            let (distance, degrees) = self.off(*frame, *id);
            if distance > POSITION_TOLERANCE * self.size { (distance, degrees) } else { (0.0, degrees) }
        };
        let worse = |a: &(JointId, usize), b: &(JointId, usize)| {
            let (a, b) = (rank(a), rank(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        };
        all.max_by(worse).unwrap_or((JointId(0), 0))
    }

    /// Says so when not all angles of a frame were taken, or too many.
    fn angles(&self, frame: usize) -> Option<String> {
        let PosedFrame { taken, available, .. } = self.got[frame];
        (taken != available)
            .then(|| format!("Your functions took {taken} angles from a frame that holds {available}."))
    }

    fn tree(&self, frame: usize, first: JointId) -> Vec<TreeLine> {
        let depths = self.skeleton.depths();
        let line = |joint: &skeleton::Joint| TreeLine {
            depth: depths[joint.id.0],
            name: joint.name.clone(),
            off: (!self.is_right(frame, joint.id))
                .then(|| format!("off by {}", self.off_in_words(frame, joint.id))),
            first: joint.id == first,
        };
        self.skeleton.joints().iter().map(line).collect()
    }
}
