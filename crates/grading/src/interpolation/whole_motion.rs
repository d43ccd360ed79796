//! The three parts together, at several moments between two frames.

use exam::interpolation::Answer as InterpolationAnswer;
use exam::{Answer, Failure, Question};
use skeleton::{JointId, LocalPose, Skeleton};

use super::misconceptions::accepted;
use crate::compare::{angle_between, between_positions, between_rotations};
use crate::{Judge, Trouble, WholeReport};

/// Knows the right frames at each of the moments `ts`.
#[derive(Debug)]
pub(super) struct RightFrames {
    pub skeleton: Skeleton,
    pub ts: Vec<f32>,
    pub question: Question,
    pub expected: Answer,
}

impl Judge for RightFrames {
    fn judge(&self, answer: &Answer) -> WholeReport {
        let Some(got) = frames(answer).filter(|got| got.len() == self.ts.len()) else {
            let why = "the frames are not those that were asked for".to_owned();
            return WholeReport::failed(Failure::Unreadable { why });
        };
        let moments = self.ts.len();
        let praise = format!(
            "Between two frames, with quaternions, every joint is turned and placed as it should be, at all {moments} \
             moments."
        );
        let report = |trouble| WholeReport { frames: moments, praise, trouble };
        if let Some(trouble) = got.iter().find_map(|pose| self.other_count(pose)) {
            return report(Some(trouble));
        }
        let Some(exact) = frames(&self.expected) else { return report(None) };
        // What part 3 accepts is accepted here too.
        let ways: Vec<Answer> =
            accepted("part3").iter().map(|way| self.question.ask(&way.functions)).collect();
        let is_accepted = |way: &Answer| frames(way).is_some_and(|way| self.first_off(way, got).is_none());
        let all_right = self.first_off(exact, got).is_none() || ways.iter().any(is_accepted);
        report(if all_right { None } else { self.trouble(exact, got) })
    }
}

fn frames(answer: &Answer) -> Option<&[LocalPose]> {
    match answer {
        Answer::Interpolation(InterpolationAnswer::Between(frames)) => Some(frames),
        _ => None,
    }
}

/// How far a joint is off at one of the moments.
struct Off {
    moment: usize,
    joint: JointId,
    /// Degrees.
    turned: f64,
    /// In the file's unit.
    moved: f32,
    in_words: String,
}

impl RightFrames {
    /// What is wrong with a frame in which some joint has no rotation or no position.
    fn other_count(&self, pose: &LocalPose) -> Option<Trouble> {
        let joints = self.skeleton.len();
        let (rotations, positions) = (pose.rotations.len(), pose.positions.len());
        ((rotations, positions) != (joints, joints)).then(|| Trouble::Different {
            summary: format!(
                "With your functions, a frame has {rotations} rotations and {positions} positions. The skeleton has \
                 {joints} joints and End Sites, and each needs one of both."
            ),
            details: Vec::new(),
        })
    }

    fn trouble(&self, expected: &[LocalPose], got: &[LocalPose]) -> Option<Trouble> {
        let first = self.first_off(expected, got)?;
        let worse = |a: &Off, b: &Off| a.turned.total_cmp(&b.turned).then(a.moved.total_cmp(&b.moved));
        let worst = self.all_off(expected, got).max_by(worse)?;
        let at = |off: &Off| (self.skeleton.label(off.joint), self.ts[off.moment]);
        let ((name, t), (first_name, first_t)) = (at(&worst), at(&first));
        let last = self.ts.len().saturating_sub(1);
        let ends = self.all_off(expected, got).any(|off| off.moment == 0 || off.moment == last);
        let mut details = vec![
            format!("At t = {first_t} the first joint that is off is {first_name}: look at what it does."),
            "Each joint is compared relative to its parent: one that is off does not make those below it wrong."
                .to_owned(),
        ];
        if !ends {
            details.push(
                "At t = 0 and t = 1 all joints are right: it is the way between that is not.".to_owned(),
            );
        }
        let summary = format!(
            "With your functions, with quaternions, {name} is farthest off: {} at t = {t}.",
            worst.in_words
        );
        Some(Trouble::Different { summary, details })
    }

    fn first_off(&self, expected: &[LocalPose], got: &[LocalPose]) -> Option<Off> {
        self.all_off(expected, got).next()
    }

    /// Moment by moment, joint by joint.
    fn all_off<'a>(
        &'a self,
        expected: &'a [LocalPose],
        got: &'a [LocalPose],
    ) -> impl Iterator<Item = Off> + 'a {
        let joints = move || self.skeleton.joints().iter().map(|joint| joint.id);
        let all = (0..self.ts.len()).flat_map(move |moment| joints().map(move |joint| (moment, joint)));
        all.filter_map(move |(moment, joint)| self.off(&expected[moment], &got[moment], moment, joint))
    }

    fn off(&self, expected: &LocalPose, got: &LocalPose, moment: usize, joint: JointId) -> Option<Off> {
        let [right, rotation] = [expected, got].map(|pose| pose.rotations[joint.0]);
        let [place, position] = [expected, got].map(|pose| pose.positions[joint.0]);
        let turned = between_rotations(right, rotation);
        let moved = between_positions(place, position, self.skeleton.extent());
        let how = [&turned, &moved].into_iter().flatten().map(|difference| difference.between.clone());
        let in_words = how.collect::<Vec<_>>().join(" and ");
        let (degrees, distance) = (angle_between(right, rotation), place.distance(position));
        (!in_words.is_empty()).then(|| Off {
            moment,
            joint,
            turned: turned.map_or(0.0, |_| if degrees.is_nan() { f64::INFINITY } else { degrees }),
            moved: if distance.is_nan() { f32::INFINITY } else { distance },
            in_words,
        })
    }
}
