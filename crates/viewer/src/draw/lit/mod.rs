//! Bones as bodies: capsules in the light of a sun and the sky, with soft shadows on the ground and on each other.
//!
//! Everything here is calculated in units of the figure's size around the camera's target, whatever the unit of the
//! file is. Light that changes slowly over a body, that of the sky and the sun's shadows, is calculated for a few
//! places on each ([`light`]) and looked up for every pixel ([`raster`]).

mod capsule;
mod light;
mod raster;
mod shade;
mod shadow;
mod shape;

use glam::Vec3;

use crate::camera::View;
use crate::draw::canvas::Canvas;
use crate::scene::{Bone, Dot, Figure, Scene};

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
        let lens = View { eye: unit.place(view.eye), near: view.near * unit.per_world, ..*view };
        if !(lens.eye.is_finite() && lens.near > 0.0) {
            return;
        }
        for (index, figure) in scene.figures.iter().enumerate() {
            if figure.look.is_solid() {
                let bones = figure.bones.iter();
                self.capsules.extend(bones.filter_map(|bone| {
                    Capsule::new(
                        bone,
                        unit.place(bone.from),
                        unit.place(bone.to),
                        unit.per_world,
                        index,
                        figure.look,
                    )
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
        self.light.shine(&self.capsules, &self.neighbours, &self.ground, &lens, canvas.size());
        self.raster.draw(&self.capsules, &self.light, &lens, unit.per_world, canvas);
    }
}

/// How far the bodies of a figure's own bones reach in front of each of its joints, towards the camera, in world units:
/// what marks a joint is moved by this to be seen upon them. Bones that merely pass in front of a joint hide it.
pub(super) fn cover(figure: &Figure, view: &View, covers: &mut Vec<f32>) {
    covers.clear();
    covers.resize(figure.joints.len(), 0.0);
    let to_eye = |joint: &Dot| (view.eye - joint.place).normalize_or_zero();
    let look = |bone: &Bone, joint: &Dot, cover: &mut f32| {
        *cover = cover.max(cover_of(bone, joint.place, to_eye(joint)) * -to_eye(joint).dot(view.forward));
    };
    if figure.bones.len() <= MOST_COVERING {
        for (joint, cover) in figure.joints.iter().zip(covers) {
            figure.bones.iter().for_each(|bone| look(bone, joint, cover));
        }
        return;
    }
    for bone in &figure.bones {
        for index in [bone.joints.0, bone.joints.1] {
            if let (Some(joint), Some(cover)) = (figure.joints.get(index), covers.get_mut(index)) {
                look(bone, joint, cover);
            }
        }
    }
}

/// With more bones than this, only those that end at a joint are looked at.
const MOST_COVERING: usize = 400;

/// How far a bone's body reaches from `place` inside of it in direction `to_eye`; zero when `place` is not inside.
fn cover_of(bone: &Bone, place: Vec3, to_eye: Vec3) -> f32 {
    let (from, along) = (place - bone.from, bone.to - bone.from);
    let length = along.length();
    let axis = if length > 0.0 { along / length } else { Vec3::ZERO };
    let at = from.dot(axis);
    let radius = bone.radius;
    if !(length.is_finite() && radius.is_finite()) {
        return 0.0;
    }
    // Joints at the ends of a bone are inside even when rounding says otherwise.
    let inside = from.distance(axis * at.clamp(0.0, length)) < radius;
    if !inside {
        return 0.0;
    }
    let leave = |offset: Vec3, ray: Vec3| {
        let (squared, ahead) = (ray.length_squared(), offset.dot(ray));
        let room = ahead * ahead - squared * (offset.length_squared() - radius * radius);
        if room >= 0.0 && squared > 1e-6 { (room.sqrt() - ahead) / squared } else { 0.0 }
    };
    let beside = leave(from - axis * at, to_eye - axis * to_eye.dot(axis));
    let left_at = at + beside * to_eye.dot(axis);
    let beside = if (0.0..=length).contains(&left_at) { beside } else { 0.0 };
    let ends = leave(from, to_eye).max(leave(place - bone.to, to_eye));
    // Looking along a limb, what lies far behind its end is not shown through all of it.
    beside.max(ends).min(3.0 * radius) * 1.02
}
