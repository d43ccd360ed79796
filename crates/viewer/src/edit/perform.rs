//! From a wish to an edited motion.

use std::sync::Arc;

use exam::Failure;
use inbetween::pose_of;
use skeleton::{Frame, LocalPose, Pose};

use super::edited::{Edited, Frames};
use super::hand::{Hand, Maker, Makers, Progress};
use super::wish::{Keys, Wish};
use crate::motion::stage::{Stage, tips};

/// The most poses that are held, counted in joints: some hundred megabytes.
pub const MOST_JOINTS: usize = 4_000_000;

/// Why a motion is not edited as it was wished.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotEdited {
    /// There are too many poses.
    #[error("too long: {frames} frames of {joints} joints are more than can be held. {}", advice(*.joints))]
    TooLong {
        /// How many frames there are from the first keyframe to the last.
        frames: usize,
        /// How many joints the skeleton has.
        joints: usize,
    },
    /// No answer came.
    #[error(transparent)]
    Failed(#[from] Failure),
    /// What came is no answer.
    #[error("{0}")]
    Odd(String),
    /// A newer wish has come.
    #[error("something else is wanted by now")]
    BrokenOff,
    /// Nobody does the work any more.
    #[error("the thread that edits the motion has ended: close the window and open it again")]
    Ended,
}

fn advice(joints: usize) -> String {
    let most = MOST_JOINTS / joints.max(1);
    format!("A stretch of at most {most} frames can be interpolated")
}

/// Whether a motion, or a stretch of it, has more poses than can be held.
pub fn is_too_long(stage: &Stage, frames: usize) -> bool {
    stage.motion().skeleton().len().saturating_mul(frames) > MOST_JOINTS
}

/// The root of the mean of the squared distances between where a tip is and where it should be, in the file's unit. `error`
/// is the sum of the squares, over so many `places`: tips in all frames. 0 where there are none.
pub fn root_mean_square(error: f64, places: usize) -> f64 {
    // A sum of many differences may come out a little below 0. What is not a number stays none.
    (error.clamp(0.0, f64::INFINITY) / places.max(1) as f64).sqrt()
}

/// Edits the motion on `stage` as it is wished, here and now.
///
/// Curves are left out where the whole motion is too long for them, though the stretch is not.
///
/// # Errors
///
/// When there are too many poses, when `hand` gives no answer or no good one, or when `progress` breaks.
pub fn perform(
    hand: &mut dyn Hand,
    stage: &Stage,
    wish: &Wish,
    progress: Progress,
) -> Result<Edited, NotEdited> {
    let mut edited = interpolate(hand, stage, wish, progress)?;
    if wish.curves {
        add_curves(hand, stage, &mut edited, progress)?;
    }
    Ok(edited)
}

/// Adds the curves to what [`interpolate`] has made.
pub(super) fn add_curves(
    hand: &mut dyn Hand,
    stage: &Stage,
    edited: &mut Edited,
    progress: Progress,
) -> Result<(), NotEdited> {
    if !is_too_long(stage, stage.moving_frames()) {
        edited.curves = Some(hand.curves(stage, progress).ok_or(NotEdited::BrokenOff)?);
    }
    Ok(())
}

/// All but the curves.
pub(super) fn interpolate(
    hand: &mut dyn Hand,
    stage: &Stage,
    wish: &Wish,
    progress: Progress,
) -> Result<Edited, NotEdited> {
    let keyframes = keyframes(hand, stage, wish, progress)?;
    let (first, last) = match &keyframes[..] {
        [] => (0, 0),
        [first, .., last] => (*first, *last),
        [only] => (*only, *only),
    };
    see_to_length(stage, last - first + 1)?;
    let mut scale = Scale::new(stage);
    let mut frames = Frames { first, ..Frames::default() };
    let mut add = |pose: Pose, error: f64| {
        frames.poses.push(pose);
        frames.errors.push(error);
    };
    let (mut error, mut interpolated) = (0.0, 0);
    for pair in keyframes.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        add(Pose::default(), 0.0);
        if end - start == 1 {
            continue;
        }
        let mut of_all = |done: usize, _: usize| progress(start - first + done, last - first);
        let locals =
            unbroken(&mut of_all, |progress| hand.between(stage, wish.representation, start, end, progress))?;
        see_to_locals(&locals, end - start - 1, stage)?;
        for (local, frame) in locals.iter().zip(start + 1..end) {
            let mut pose = Pose::default();
            pose_of(stage.motion().skeleton(), local, &mut pose);
            let own = scale.error(stage, frame, &pose);
            error += own;
            interpolated += 1;
            add(pose, own);
        }
        if progress(end - first, last - first).is_break() {
            return Err(NotEdited::BrokenOff);
        }
    }
    let places = scale.tips.len() * (last - first + 1);
    let makers = match wish.keys {
        Keys::Automatic(_) => hand.makers(),
        // Nobody's functions have chosen these.
        Keys::Ends(..) => Makers { keyframes: Maker::default(), ..hand.makers() },
    };
    Ok(Edited {
        wish: wish.clone(),
        makers,
        keyframes,
        interpolated,
        error,
        distance: root_mean_square(error, places),
        curves: None,
        frames: Arc::new(frames),
    })
}

fn keyframes(
    hand: &mut dyn Hand,
    stage: &Stage,
    wish: &Wish,
    progress: Progress,
) -> Result<Vec<usize>, NotEdited> {
    let count = stage.moving_frames();
    let Some(last) = count.checked_sub(1) else { return Ok(Vec::new()) };
    let wanted = match wish.keys {
        Keys::Ends(start, end) => {
            let (start, end) = (start.min(end).min(last), start.max(end).min(last));
            return Ok(if start == end { vec![start] } else { vec![start, end] });
        }
        Keys::Automatic(wanted) => wanted,
    };
    see_to_length(stage, count)?;
    let reductions =
        unbroken(progress, |progress| hand.reduce(stage, wish.representation, &[wanted], progress))?;
    let [reduction] = &reductions[..] else {
        return Err(NotEdited::Odd(format!("{} reductions came back instead of one", reductions.len())));
    };
    let keyframes = &reduction.keyframes;
    let ascends = keyframes.windows(2).all(|pair| pair[0] < pair[1]);
    if !ascends || keyframes.first() != Some(&0) || keyframes.last() != Some(&last) {
        let some: Vec<String> = keyframes.iter().take(8).map(usize::to_string).collect();
        let more = if keyframes.len() > 8 { ", …" } else { "" };
        return Err(NotEdited::Odd(format!(
            "these are no keyframes from frame 0 to frame {last} in ascending order: [{}{more}]",
            some.join(", ")
        )));
    }
    Ok(keyframes.clone())
}

/// What comes of `work`, unless `progress` breaks while it is done.
fn unbroken<T>(
    progress: Progress,
    work: impl FnOnce(Progress) -> Result<T, Failure>,
) -> Result<T, NotEdited> {
    let mut broken = false;
    let done = work(&mut |done, of| {
        let told = progress(done, of);
        broken |= told.is_break();
        told
    });
    if broken { Err(NotEdited::BrokenOff) } else { Ok(done?) }
}

fn see_to_length(stage: &Stage, frames: usize) -> Result<(), NotEdited> {
    let joints = stage.motion().skeleton().len();
    if is_too_long(stage, frames) { Err(NotEdited::TooLong { frames, joints }) } else { Ok(()) }
}

fn see_to_locals(locals: &[LocalPose], wanted: usize, stage: &Stage) -> Result<(), NotEdited> {
    if locals.len() != wanted {
        return Err(NotEdited::Odd(format!("{} frames came back instead of {wanted}", locals.len())));
    }
    let joints = stage.motion().skeleton().len();
    let counts = locals.iter().map(|local| (local.rotations.len(), local.positions.len()));
    match counts.into_iter().find(|counts| *counts != (joints, joints)) {
        None => Ok(()),
        Some((rotations, positions)) => Err(NotEdited::Odd(format!(
            "an interpolated frame has {rotations} rotations and {positions} positions: the skeleton has {joints} joints"
        ))),
    }
}

/// Measures errors.
struct Scale {
    tips: Vec<usize>,
    frame: Frame,
    original: Pose,
}

impl Scale {
    fn new(stage: &Stage) -> Scale {
        let tips = tips(stage.motion().skeleton().joints());
        Scale { tips, frame: Frame::default(), original: Pose::default() }
    }

    /// The sum of the squared distances of all tips from where they are in the original frame.
    fn error(&mut self, stage: &Stage, frame: usize, pose: &Pose) -> f64 {
        stage.read_reference(frame, &mut self.frame, &mut self.original);
        let (ours, theirs) = (self.original.transforms(), pose.transforms());
        self.tips
            .iter()
            .map(|tip| f64::from(ours[*tip].position.distance_squared(theirs[*tip].position)))
            .sum()
    }
}
