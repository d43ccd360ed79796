//! What is edited of a motion: the state that keys change, and what has come of it.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::Vec3;
use skeleton::{Pose, Representation};

use super::App;
use crate::camera::Camera;
use crate::edit::{self, Edited, EngineState, Hand, Keys, NotEdited, Wish};

/// For how long the figure flashes at a keyframe, in seconds of the motion.
const FLASH: f64 = 0.04;

/// How far the original stands beside the interpolated figure, in shares of the room in which the figure stays.
const BESIDE: f32 = 0.8;

/// What is edited, and how it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EditSettings {
    /// How the stretch between the first and the last frame that are played is interpolated, if it is.
    pub stretch: Option<Representation>,
    /// Whether keyframes are chosen automatically over the whole motion. Then the stretch does not matter.
    pub automatic: bool,
    /// How frames between automatic keyframes are interpolated.
    pub representation: Representation,
    /// How many automatic keyframes there are. What is too few or too many for the motion counts as the nearest number.
    pub keyframes: usize,
    /// Whether the original stands beside the interpolated figure, and not over it.
    pub beside: bool,
    /// Whether arrows lead from the interpolated figure's tips to where they are in the original.
    pub errors: bool,
    /// Whether the plot of errors is shown.
    pub plot: bool,
}

impl Default for EditSettings {
    fn default() -> EditSettings {
        EditSettings {
            stretch: None,
            automatic: false,
            representation: Representation::default(),
            keyframes: 20,
            beside: false,
            errors: false,
            plot: false,
        }
    }
}

impl EditSettings {
    /// How frames are interpolated, if any are.
    pub fn interpolated(&self) -> Option<Representation> {
        if self.automatic { Some(self.representation) } else { self.stretch }
    }

    /// Goes on to the next representation; without automatic keyframes also to none.
    pub(super) fn next_representation(&mut self) {
        if self.automatic {
            self.representation = other(self.representation);
            self.stretch = self.stretch.map(|_| self.representation);
        } else {
            self.stretch = match self.stretch {
                None => Some(Representation::Euler),
                Some(Representation::Euler) => Some(Representation::Quaternion),
                Some(Representation::Quaternion) => None,
            };
        }
    }

    pub(super) fn toggle_automatic(&mut self) {
        self.automatic = !self.automatic;
        self.representation = self.stretch.unwrap_or(self.representation);
    }
}

fn other(representation: Representation) -> Representation {
    match representation {
        Representation::Euler => Representation::Quaternion,
        Representation::Quaternion => Representation::Euler,
    }
}

/// What has come of a wish so far.
#[derive(Clone, Debug, Default)]
pub struct Editing {
    /// The newest result.
    pub edited: Option<Arc<Edited>>,
    /// Whether it was made for an older wish.
    pub stale: bool,
    /// Whether it was made by an older hand.
    pub by_former_hand: bool,
    /// How much of the work is done and how much there is, while it is done.
    pub progress: Option<(usize, usize)>,
    /// Why there is no result.
    pub failure: Option<Arc<NotEdited>>,
    /// For how many pictures in a row nothing new has come, though something is missing.
    pub waited: u32,
}

impl App {
    /// What is wanted of the motion; nothing while it is shown as it is.
    pub fn wish(&self) -> Option<Wish> {
        let settings = &self.settings.edit;
        let representation = self.interpolated()?;
        let keys = match settings.automatic {
            true => Keys::Automatic(self.keyframe_count()),
            false => {
                let (start, end) = self.ends();
                Keys::Ends(start, end)
            }
        };
        Some(Wish { representation, keys, curves: settings.plot })
    }

    /// How many automatic keyframes this motion has when they are wanted: of those that the settings say, as many as are
    /// possible.
    pub fn keyframe_count(&self) -> usize {
        let frames = self.stage.moving_frames();
        self.settings.edit.keyframes.max(2).min(frames)
    }

    /// Edits the motion as its settings say, here and now: for pictures, that nobody can wait for.
    pub fn edit(&mut self, hand: &mut dyn Hand) {
        self.editing = match self.wish() {
            None => Editing::default(),
            Some(wish) => {
                let mut go_on = |_, _| ControlFlow::Continue(());
                match edit::perform(hand, &self.stage, &wish, &mut go_on) {
                    Ok(edited) => Editing { edited: Some(Arc::new(edited)), ..Editing::default() },
                    Err(failure) => Editing { failure: Some(Arc::new(failure)), ..Editing::default() },
                }
            }
        };
    }

    /// Shows what an engine has made of the [`wish`](App::wish) so far.
    pub fn show_edit(&mut self, state: EngineState) {
        let same = match (&self.editing.edited, state.edited) {
            (Some(shown), Some(newest)) => Arc::ptr_eq(shown, newest),
            (shown, newest) => shown.is_none() == newest.is_none(),
        };
        let waits = state.progress.is_some() && same;
        self.editing = Editing {
            edited: state.edited.cloned(),
            stale: state.stale,
            by_former_hand: state.by_former_hand,
            progress: state.progress,
            failure: state.failure.cloned(),
            waited: if waits { self.editing.waited.saturating_add(1) } else { 0 },
        };
    }

    /// What has come of the [`wish`](App::wish) so far; nothing when there is none.
    pub fn editing(&self) -> Option<&Editing> {
        self.interpolated().map(|_| &self.editing)
    }

    /// How frames are interpolated, if any are. Of a pair that is the original's.
    pub(super) fn interpolated(&self) -> Option<Representation> {
        self.settings.edit.interpolated().filter(|_| self.warp.is_none())
    }

    /// The edited motion, as far as it is there.
    pub fn edited(&self) -> Option<&Arc<Edited>> {
        self.editing()?.edited.as_ref()
    }

    /// The pose of an interpolated frame, where the motion is edited and this frame is.
    pub(super) fn interpolated_pose(&self, frame: usize) -> Option<&Pose> {
        self.edited()?.pose(frame)
    }

    /// From the interpolated figure to the original, where that stands beside it: to the right of the picture. The same in
    /// every frame, and about as far as the figure reaches with its limbs.
    pub(super) fn beside(&self) -> Option<Vec3> {
        let wanted = self.settings.edit.beside && self.settings.ghost && self.edited().is_some();
        // How large a picture is does not matter for this.
        let right = self.camera.view((1, 1)).right;
        wanted.then(|| right * (BESIDE * self.stage.breadth(right)))
    }

    /// The same camera, where two figures stand beside each other on the middle between them.
    pub(super) fn camera_between(&self, camera: Camera) -> Camera {
        let aside = self.beside().map_or(Vec3::ZERO, |beside| 0.5 * beside);
        Camera { target: camera.target + aside, ..camera }
    }

    /// Whether the figure flashes in a frame: a keyframe is there, or was just passed. That lasts for a moment, so that it
    /// can be seen at any speed of the motion.
    pub(super) fn flashes(&self, frame: usize) -> bool {
        let span = (FLASH / self.stage.motion().playable_frame_time()).round() as usize;
        let edited = self.edited().filter(|edited| edited.interpolated > 0);
        edited.is_some_and(|edited| edited.is_at_keyframe(frame, span, self.player.is_backwards()))
    }

    /// Takes so many more keyframes, or fewer when it is negative.
    pub(super) fn change_keyframes(&mut self, by: isize) {
        if self.settings.edit.automatic {
            let most = self.stage.moving_frames().max(2);
            self.settings.edit.keyframes = self.keyframe_count().saturating_add_signed(by).clamp(2, most);
        }
    }
}
