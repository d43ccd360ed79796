//! A motion reduced to any number of keyframes, by the reference.

use std::sync::Arc;

use exam::keyframes::Reduction;
use reduction::{Curve, Errors};
use skeleton::{Frame, Representation, Skeleton};

use super::hand::Progress;
use crate::motion::stage::Stage;

/// How the accumulated error grows while keyframes are removed, in both representations.
#[derive(Clone, Debug)]
pub struct Curves([Arc<Curve>; 2]);

impl Curves {
    /// The errors in one representation: the n-th (from 0) is that of n interpolated frames. There is at least the first,
    /// which is 0.
    pub fn errors(&self, representation: Representation) -> &[f64] {
        &self.0[index(representation)].errors
    }
}

/// The order in which a motion's keyframes are removed, remembered: whatever number is asked for, it is worked out once.
#[derive(Debug, Default)]
pub struct Reductions {
    skeleton: Skeleton,
    frames: Vec<Frame>,
    curves: [Option<Arc<Curve>>; 2],
}

impl Reductions {
    /// The motion reduced to each of these numbers of keyframes. `None` when `progress` breaks.
    pub fn reduce(
        &mut self,
        stage: &Stage,
        representation: Representation,
        counts: &[usize],
        progress: Progress,
    ) -> Option<Vec<Reduction>> {
        let curve = self.curve(stage, representation, progress)?;
        let frames = self.frames.len();
        let reduction = |count: &usize| {
            let removed = frames.saturating_sub((*count).max(2)).min(curve.removed.len());
            let keyframes = remaining(frames, &curve.removed[..removed]);
            Reduction { keyframes, error: curve.errors[removed] }
        };
        Some(counts.iter().map(reduction).collect())
    }

    /// The curves of both representations. `None` when `progress` breaks.
    pub fn curves(&mut self, stage: &Stage, progress: Progress) -> Option<Curves> {
        let mut half = |which: usize, representation| {
            let both = &mut |done: usize, of: usize| progress(done + which * of, 2 * of);
            self.curve(stage, representation, both)
        };
        Some(Curves([half(0, Representation::Euler)?, half(1, Representation::Quaternion)?]))
    }

    fn curve(
        &mut self,
        stage: &Stage,
        representation: Representation,
        progress: Progress,
    ) -> Option<Arc<Curve>> {
        self.follow(stage);
        if let Some(known) = &self.curves[index(representation)] {
            return Some(known.clone());
        }
        let errors = Errors::new(&self.skeleton, &self.frames, representation);
        let mut broken = false;
        let curve = reduction::curve(&errors, 2, &mut |done, of| {
            let told = progress(done, of);
            broken |= told.is_break();
            told
        });
        if broken {
            return None;
        }
        Some(self.curves[index(representation)].insert(Arc::new(curve)).clone())
    }

    /// Forgets what is known of another motion.
    fn follow(&mut self, stage: &Stage) {
        let skeleton = stage.motion().skeleton();
        let mut frame = Frame::default();
        let mut is_same = |(index, known): (usize, &Frame)| {
            stage.read_frame(index, &mut frame);
            frame == *known
        };
        let same = self.frames.len() == stage.moving_frames()
            && self.skeleton == *skeleton
            && self.frames.iter().enumerate().all(&mut is_same);
        if !same {
            self.skeleton = skeleton.clone();
            self.frames = stage.frames();
            self.curves = [None, None];
        }
    }
}

/// The frames that stay when some of so many are removed.
pub fn remaining(frame_count: usize, removed: &[usize]) -> Vec<usize> {
    let mut stays = vec![true; frame_count];
    removed.iter().for_each(|frame| stays[*frame] = false);
    (0..frame_count).filter(|frame| stays[*frame]).collect()
}

fn index(representation: Representation) -> usize {
    usize::from(representation == Representation::Quaternion)
}
