//! What is to be asked next.
//!
//! First comes what is on show, then the questions for points, then all other frames, those ahead first. A batch of
//! frames that fails is halved until the frames are found that fail.

use std::ops::Range;
use std::sync::Arc;

use exam::Failure;

use super::pieces::{Pieces, State};
use super::window::{AHEAD, Window};
use crate::live::mover::Mover;
use crate::motion::stage::Stage;

/// About how many joints are asked for at once: few enough for an answer without a wait that one would notice.
pub(super) const JOINTS_PER_BATCH: usize = 8_000;

/// So many frames that panic are looked for ahead of time. Others are found when they are shown.
const MOST_PANICS: usize = 2_000;

/// Endless loops and crashes cost more: after so many of them, frames are asked only when they are shown,
const MOST_COSTLY: usize = 12;

/// and after so many frames that end like this no more frames are asked.
const MOST_COSTLY_FRAMES: usize = 6;

/// What one version of the student's functions has been asked, and what it is wanted for.
pub(super) struct Plan {
    pub(super) mover: Mover,
    /// The version that this is about.
    pub(super) version: u64,
    pub(super) motions: Vec<MotionPlan>,
    pub(super) graded: bool,
    panics: usize,
    costly: usize,
    costly_frames: usize,
}

/// The same for one motion.
pub(super) struct MotionPlan {
    pub(super) stage: Arc<Stage>,
    /// How often the motion was read again.
    pub(super) reading: u64,
    pub(super) shown: usize,
    pub(super) window: Window,
    /// The frame of which details are wanted.
    pub(super) details: Option<usize>,
    /// A batch of which nothing is here is fresh: there may be very many of them.
    pieces: Pieces,
    /// Whether the functions have anything to do with this motion.
    moved: bool,
    /// Whether they make all of it at once: what is said of one frame is said of all.
    whole: bool,
    /// Some frame was answered: the functions do come back.
    warm: bool,
    /// The frame that was asked last while it was on show.
    heard: Option<usize>,
    /// A frame has failed, and none was answered since.
    failed: bool,
}

/// One thing to ask.
#[derive(Clone, Debug)]
pub(super) enum Task {
    /// The poses of some frames. `on_show` says that the only one is on show.
    Frames { at: Motion, frames: Range<usize>, on_show: bool },
    /// The place at which a frame fails.
    Place { at: Motion, frame: usize, failure: Arc<Failure> },
    /// What single parts answer about a frame.
    Details { at: Motion, frame: usize },
    /// The questions for points.
    Grade,
}

/// The motion that a task is about, as it was read last, and the version that is asked.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    pub(super) index: usize,
    pub(super) version: u64,
    pub(super) reading: u64,
    pub(super) stage: Arc<Stage>,
}

impl Plan {
    pub(super) fn new(mover: Mover, stages: Vec<Arc<Stage>>, most_batches: impl Fn(usize) -> usize) -> Plan {
        let most_batches = most_batches(stages.len());
        let motion = |stage| MotionPlan::new(mover, stage, 0, most_batches);
        Plan {
            mover,
            version: 0,
            motions: stages.into_iter().map(motion).collect(),
            graded: false,
            panics: 0,
            costly: 0,
            costly_frames: 0,
        }
    }

    /// Begins anew for the next version.
    pub(super) fn begin(&mut self) {
        self.version += 1;
        self.graded = false;
        (self.panics, self.costly, self.costly_frames) = (0, 0, 0);
        self.motions.iter_mut().for_each(MotionPlan::begin);
    }

    /// What to ask next. Functions that are `talkative` are asked again about a frame when it comes on show: then is the
    /// time for what they print.
    pub(super) fn next(&self, talkative: bool) -> Option<Task> {
        self.urgent(talkative).or_else(|| {
            if let Some(details) = self.details() {
                return Some(details);
            }
            if !self.graded {
                return Some(Task::Grade);
            }
            let all = self.motions.iter().map(|motion| motion.window.len()).max().unwrap_or(0);
            self.ahead(all)
        })
    }

    /// What is on show and has no answer yet, and a little of what comes next.
    pub(super) fn urgent(&self, talkative: bool) -> Option<Task> {
        if self.has_given_up() {
            return None;
        }
        let on_show = (0..self.motions.len()).find_map(|index| self.on_show(index, talkative));
        on_show.or_else(|| self.ahead(AHEAD))
    }

    fn details(&self) -> Option<Task> {
        let mut motions = self.motions.iter().enumerate().filter(|_| !self.has_given_up());
        let (index, frame) = motions.find_map(|(index, motion)| Some((index, motion.details?)))?;
        Some(Task::Details { at: self.at(index)?, frame })
    }

    fn on_show(&self, index: usize, talkative: bool) -> Option<Task> {
        let motion = &self.motions[index];
        let at = self.at(index)?;
        let (frames, state) = motion.piece(motion.shown)?;
        let single = Task::Frames { at: at.clone(), frames: motion.shown..motion.shown + 1, on_show: true };
        let is_unheard = talkative && !motion.is_heard(motion.shown);
        match state {
            State::Settled if is_unheard => Some(single),
            State::Bad { failure, .. } if is_unheard && matches!(**failure, Failure::Panicked { .. }) => {
                Some(single)
            }
            State::Settled | State::Bad { narrowed: true, .. } => None,
            State::Bad { failure, .. } => {
                Some(Task::Place { at, frame: motion.shown, failure: Arc::clone(failure) })
            }
            State::Fresh if motion.warm && !self.is_tired() => {
                Some(Task::Frames { at, frames, on_show: false })
            }
            State::Fresh | State::Suspect => Some(single),
        }
    }

    /// The nearest frames without an answer that are less than `batches` away.
    fn ahead(&self, batches: usize) -> Option<Task> {
        if self.is_tired() {
            return None;
        }
        (0..batches).find_map(|rank| {
            (0..self.motions.len()).find_map(|index| {
                let motion = &self.motions[index];
                let frames = motion.unsettled(motion.window.batch(motion.shown, rank)?)?;
                Some(Task::Frames { at: self.at(index)?, frames, on_show: false })
            })
        })
    }

    fn at(&self, index: usize) -> Option<Motion> {
        let motion = self.motions.get(index)?;
        Some(Motion {
            index,
            version: self.version,
            reading: motion.reading,
            stage: Arc::clone(&motion.stage),
        })
    }

    /// Whether so much has failed that nothing is asked ahead of time.
    pub(super) fn is_tired(&self) -> bool {
        self.panics >= MOST_PANICS || self.costly >= MOST_COSTLY
    }

    /// Whether endless loops or crashes have cost so much that no frames are asked any more.
    pub(super) fn has_given_up(&self) -> bool {
        self.costly_frames >= MOST_COSTLY_FRAMES
    }

    /// Whether an endless loop or a crash has been met.
    pub(super) fn is_wary(&self) -> bool {
        self.costly > 0
    }

    /// The frame is asked while it is on show.
    pub(super) fn hear(&mut self, at: &Motion, frame: usize) {
        if let Some(motion) = self.motion(at) {
            motion.heard = Some(frame);
        }
    }

    /// The frames are answered.
    pub(super) fn settle(&mut self, at: &Motion, frames: Range<usize>) {
        if let Some(motion) = self.motion(at) {
            (motion.warm, motion.failed) = (true, false);
            motion.set(frames, State::Settled);
        }
    }

    /// The frames have failed, all or some of them.
    pub(super) fn fail(&mut self, at: &Motion, frames: Range<usize>, failure: &Failure) {
        let costly = !matches!(failure, Failure::Panicked { .. });
        let single = frames.len() == 1;
        let Some(motion) = self.motion(at) else { return };
        motion.failed = true;
        if single {
            let failure = Arc::new(failure.clone());
            motion.set(frames, State::Bad { failure, narrowed: false });
        } else {
            let middle = frames.start.midpoint(frames.end);
            motion.set(frames.start..middle, State::Suspect);
            motion.set(middle..frames.end, State::Suspect);
        }
        self.costly += usize::from(costly);
        self.costly_frames += usize::from(costly && single);
        self.panics += usize::from(!costly && single);
    }

    /// Asked by itself, a part has failed for a frame.
    pub(super) fn count(&mut self, failure: &Failure) {
        let costly = usize::from(!matches!(failure, Failure::Panicked { .. }));
        self.costly += costly;
        self.costly_frames += costly;
    }

    /// It was looked for the place at which the frame fails.
    pub(super) fn narrowed(&mut self, at: &Motion, frame: usize, failure: Arc<Failure>) {
        if let Some(motion) = self.motion(at) {
            motion.set(frame..frame + 1, State::Bad { failure, narrowed: true });
        }
    }

    fn motion(&mut self, at: &Motion) -> Option<&mut MotionPlan> {
        // Nothing that an abandoned version answers settles anything.
        let motion = self.motions.get_mut(at.index).filter(|motion| motion.reading == at.reading);
        motion.filter(|_| self.version == at.version)
    }
}

impl MotionPlan {
    pub(super) fn new(mover: Mover, stage: Arc<Stage>, reading: u64, most_batches: usize) -> MotionPlan {
        let batch_size = mover.frames_at_once(&stage, JOINTS_PER_BATCH);
        let window = Window::new(stage.frame_count(), batch_size, most_batches);
        MotionPlan {
            moved: mover.moves(&stage),
            whole: mover.is_asked_whole(&stage),
            stage,
            reading,
            shown: 0,
            window,
            details: None,
            pieces: Pieces::default(),
            warm: false,
            heard: None,
            failed: false,
        }
    }

    fn begin(&mut self) {
        (self.warm, self.heard, self.failed, self.details) = (false, None, false, None);
        self.pieces.clear();
    }

    /// Wants details of `frame`.
    pub(super) fn want_details(&mut self, frame: usize) {
        self.details = Some(frame).filter(|_| self.moved);
    }

    /// The batch is to be asked again.
    pub(super) fn forget(&mut self, batch: usize) {
        self.pieces.forget(self.window.frames(batch));
    }

    /// The frames around `frame` that are as far as it is; nothing where there is nothing to ask.
    fn piece(&self, frame: usize) -> Option<(Range<usize>, &State)> {
        let fresh = || (self.window.frames(self.window.batch_of(frame)), &State::Fresh);
        self.moved.then(|| self.pieces.at(frame).unwrap_or_else(fresh))
    }

    /// The first frames of a batch that are still to be asked. Where all fail alike, each is asked when it is shown.
    fn unsettled(&self, batch: usize) -> Option<Range<usize>> {
        let frames = self.window.frames(batch);
        match () {
            () if !self.moved || (self.whole && self.failed) => None,
            () if self.pieces.at(frames.start).is_none() => Some(frames),
            () => self.pieces.unsettled_in(frames),
        }
    }

    /// Says how far `frames`, which are of one batch, are.
    fn set(&mut self, frames: Range<usize>, state: State) {
        let batch = self.window.frames(self.window.batch_of(frames.start));
        if self.pieces.at(batch.start).is_none() {
            self.pieces.set(batch, State::Fresh);
        }
        self.pieces.set(frames, state);
    }

    /// Whether what is printed about `frame` has been heard.
    fn is_heard(&self, frame: usize) -> bool {
        self.heard.is_some_and(|heard| self.whole || heard == frame)
    }
}
