//! A motion that is warped, and one that is the original of another.

use std::sync::Arc;

use glam::Vec3;

use super::{Aim, App};
use crate::camera::Camera;
use crate::draw::fit;
use crate::live::student::Points;
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;
use crate::view::texts;
use crate::view::warp::Warp;

/// The least picture, on an ordinary display, in which the figure makes room for the words of a pair, and that in which it does
/// so for the curve, too.
const LEAST: (f32, f32) = (200.0, 300.0);
const LEAST_WITH_CURVE: (f32, f32) = (440.0, 440.0);

/// How far the figure moves down for this, and how far to the left at most: in pixels where texts have their full size, and as
/// a share of the width.
const DOWN: f32 = 42.0;
const ASIDE: f32 = 0.3;

/// How far it is from the left side of the curve to the right of the picture, in pixels, and how far a figure reaches to both
/// sides, as a share of the shorter side of the picture.
const CURVE: f32 = 268.0;
const REACH: f32 = 0.18;

/// The height that words take above the figures of a pair, and what is below them, in pixels.
const WORDS: f32 = 262.0;

impl App {
    /// How this motion is warped, if it is.
    pub fn warp(&self) -> Option<Warp> {
        self.warp
    }

    /// What the warp makes of the motion, if it is warped.
    pub fn time_map(&self) -> Option<TimeMap> {
        self.stage.warp()
    }

    /// Warps the motion otherwise. Nothing is read again.
    pub fn set_warp(&mut self, warp: Warp) {
        let stage = self.stage.warped(warp.map(self.stage.motion().frame_count()));
        let length = self.player.length().max(stage.frame_count());
        self.player = self.player.waiting(stage.frame_count(), length);
        self.warp = Some(warp);
        self.stage = Arc::new(stage);
        self.name();
    }

    /// Shows another state of a motion that is warped, as it is read from its file, and warps it as before.
    pub fn replace_original(&mut self, original: &Stage, warp: Warp) {
        let old = original.motion().frame_count();
        let warp = warp.for_motion(old);
        self.replace(Arc::new(original.warped(warp.map(old))), Vec::new());
        self.warp = Some(warp);
    }

    /// Others wait for this motion, and it waits for none.
    pub(in crate::view) fn lead(&mut self) {
        let count = self.stage.frame_count();
        self.player = self.player.waiting(count, count);
    }

    /// The motion shares its time with another one: with the same settings, and at the same time.
    pub(in crate::view) fn go_along(&mut self, other: &App) {
        self.player = other.player.waiting(self.stage.frame_count(), other.player.count());
    }

    /// The motion is one of a pair. Where another one is the warped one, `stretch` are the keyframes of its stretch.
    pub(in crate::view) fn pair(&mut self, stretch: Option<[usize; 2]>) {
        if !self.paired && self.aim != Aim::Stay {
            self.aim = Aim::Begin;
        }
        self.paired = true;
        self.stretch = stretch;
    }

    /// Shows the points of a student's functions that move the other motion of the pair, and not this one: here there is room.
    pub(in crate::view) fn show_points_of_other(&mut self, points: Option<Points>) {
        self.points_of_other = points;
    }

    /// The points of a student's functions that move the other motion of the pair, and not this one.
    pub(in crate::view) fn points_of_other(&self) -> Option<&Points> {
        self.points_of_other.as_ref()
    }

    /// Whether the motion is one of a pair: the original, or the warped one.
    pub fn is_paired(&self) -> bool {
        self.paired
    }

    /// The keyframes of the stretch that is warped, in this motion's own frames.
    pub fn stretch(&self) -> Option<[usize; 2]> {
        self.time_map().map_or(self.stretch, |map| Some(map.keyframes()?.map(|(_, new)| new)))
    }

    /// The first and the last frame of the stretch that is edited when it is set by hand.
    pub fn ends(&self) -> (usize, usize) {
        self.stretch.map_or_else(|| self.player.range(), |[first, last]| (first, last))
    }

    /// Makes the title anew.
    pub(super) fn name(&mut self) {
        self.title.clone_from(&self.file);
        if let Some(map) = self.time_map() {
            texts::write_warp(&mut self.title, &map);
        }
    }

    /// How far the figure stands beside the middle of a picture of `size` pixels: to the right and down.
    fn aside(&self, size: (usize, usize)) -> (f32, f32) {
        let scale = self.settings.text_scale;
        let (width, height) = (size.0 as f32, size.1 as f32);
        let has_room = |least: (f32, f32)| width >= least.0 * scale && height >= least.1 * scale;
        if !self.paired || !self.settings.words || !has_room(LEAST) {
            return (0.0, 0.0);
        }
        let over = match has_room(LEAST_WITH_CURVE) {
            true => REACH * width.min(height) + CURVE * fit(size, scale) - 0.5 * width,
            false => 0.0,
        };
        (-over.clamp(0.0, ASIDE * width), DOWN * self.words(size))
    }

    /// How large words are, and a little more where they are smaller than usual: a head is not as much smaller.
    fn words(&self, size: (usize, usize)) -> f32 {
        let scale = self.settings.text_scale;
        (fit(size, scale) + 0.1 * scale).min(scale)
    }

    /// The camera of a picture of `size` pixels, whose words and curve do not cover the figure.
    pub(super) fn with_room(&self, mut camera: Camera, size: (usize, usize)) -> Camera {
        let (right, down) = self.aside(size);
        camera.pan(right, down, size);
        camera
    }

    /// Looks at a pair from farther away.
    pub(super) fn step_back(&mut self, size: (usize, usize)) {
        if self.aside(size) != (0.0, 0.0) {
            let high = self.stage.breadth(Vec3::Y) * self.camera.view(size).focal / self.camera.distance;
            let room = (size.1 as f32 - WORDS * self.words(size)).max(1.0);
            self.camera.zoom((high / room).max(1.0));
        }
    }
}
