//! The bodies of bones, and which of them are close enough to take light from each other.

use std::ops::Range;

use glam::{Vec2, Vec3, Vec3Swizzles};

use super::{SUN, SUN_SPREAD};
use crate::scene::{Bone, Look, Side};

/// A cylinder with half balls at its ends.
#[derive(Clone, Copy, Debug)]
pub(in crate::draw) struct Capsule {
    pub from: Vec3,
    pub to: Vec3,
    /// From `from` to `to`, a unit vector.
    pub axis: Vec3,
    pub length: f32,
    pub radius: f32,
    /// The share of red, green and blue light that it throws back.
    pub albedo: Vec3,
    /// Whether it is drawn pale.
    pub pale: bool,
    /// Of which figure it is, and which joints it lies between.
    figure: usize,
    joints: (usize, usize),
}

/// Farther away from the camera's target than this, in sizes of the figure, single precision draws no true bodies.
const FARTHEST: f32 = 1e5;

impl Capsule {
    /// The body of `bone`, whose ends are given in the unit of drawing. None for what is not made of numbers.
    pub fn new(
        bone: &Bone,
        from: Vec3,
        to: Vec3,
        per_world: f32,
        figure: usize,
        look: Look,
    ) -> Option<Capsule> {
        let radius = bone.radius * per_world;
        let near = |place: Vec3| place.is_finite() && place.abs().max_element() < FARTHEST;
        if !(near(from) && near(to) && radius > 1e-6 && radius < FARTHEST) {
            return None;
        }
        let along = to - from;
        let length = along.length();
        // A bone without a length is a ball, which is the same in any direction.
        let (axis, length) = if length > 1e-6 { (along / length, length) } else { (Vec3::Y, 0.0) };
        let albedo = match bone.side {
            _ if look == Look::Flash => Vec3::new(0.03, 1.0, 0.10),
            Side::Left => Vec3::new(0.85, 0.31, 0.10),
            Side::Right => Vec3::new(0.062, 0.265, 0.75),
            Side::Middle => Vec3::new(0.79, 0.75, 0.66),
        };
        let pale = look == Look::Dimmed;
        Some(Capsule { from, to, axis, length, radius, albedo, pale, figure, joints: bone.joints })
    }

    /// The point of the axis that is nearest to `point`.
    pub fn nearest(&self, point: Vec3) -> Vec3 {
        self.from + self.axis * (point - self.from).dot(self.axis).clamp(0.0, self.length)
    }

    /// How far the axis passes from a ray that starts at `point` in the direction of the sun, and how far along the
    /// ray that is, below zero behind its start.
    pub fn sun_ray(&self, point: Vec3) -> (f32, f32) {
        let to_start = self.from - point;
        let lean = SUN.dot(self.axis);
        let apart = 1.0 - lean * lean;
        let along = if apart > 1e-6 {
            ((SUN.dot(to_start) * lean - self.axis.dot(to_start)) / apart).clamp(0.0, self.length)
        } else {
            0.0
        };
        let nearest = to_start + self.axis * along;
        let ahead = nearest.dot(SUN);
        ((nearest - SUN * ahead).length(), ahead)
    }

    /// The share of the sun's disc that is seen past this capsule from `point`, 0 to 1. `blur` is the least width of
    /// the shadow's edge.
    pub fn sun_share(&self, point: Vec3, blur: f32) -> f32 {
        let (distance, ahead) = self.sun_ray(point);
        if ahead <= 0.0 {
            return 1.0;
        }
        let spread = ahead * SUN_SPREAD + blur;
        let share = (0.5 + (distance - self.radius) / (2.0 * spread)).clamp(0.0, 1.0);
        // From far away the capsule covers only a part of the disc.
        (share * share * (3.0 - 2.0 * share)).max(1.0 - self.radius / spread)
    }

    /// Whether two bones of a figure meet at a joint.
    fn meets(&self, other: &Capsule) -> bool {
        let (from, to) = self.joints;
        self.figure == other.figure
            && (other.joints.0 == from
                || other.joints.0 == to
                || other.joints.1 == from
                || other.joints.1 == to)
    }

    /// The ball around it: centre and radius.
    fn ball(&self) -> (Vec3, f32) {
        (self.from.midpoint(self.to), 0.5 * self.length + self.radius)
    }
}

/// With more bodies than this, each is lit as if it were alone: looking at all pairs would take too long.
pub(super) const MOST_MUTUAL: usize = 250;

/// For each capsule, those that may stand between it and the sun, and those that may hide a part of the sky.
#[derive(Default)]
pub(super) struct Neighbours {
    shading: Vec<u16>,
    hiding: Vec<u16>,
    ends: Vec<(usize, usize)>,
}

impl Neighbours {
    pub fn find(&mut self, capsules: &[Capsule]) {
        self.shading.clear();
        self.hiding.clear();
        self.ends.clear();
        if capsules.len() <= MOST_MUTUAL {
            // As many as there are in any pose.
            self.shading.reserve(capsules.len() * capsules.len());
            self.hiding.reserve(capsules.len() * capsules.len());
        }
        for capsule in capsules {
            if capsules.len() <= MOST_MUTUAL {
                self.add(capsule, capsules);
            }
            self.ends.push((self.shading.len(), self.hiding.len()));
        }
    }

    fn add(&mut self, capsule: &Capsule, capsules: &[Capsule]) {
        let (centre, radius) = capsule.ball();
        for (index, other) in (0..).zip(capsules) {
            // Bones that meet grow into each other: there is no gap for a shadow. This leaves out the capsule itself.
            if capsule.meets(other) {
                continue;
            }
            let (other_centre, other_radius) = other.ball();
            let away = other_centre - centre;
            let reach = radius + other_radius;
            let along = away.dot(SUN);
            let aside = (away - SUN * along).length();
            if along > -reach && aside < reach + SUN_SPREAD * (along.max(0.0) + reach) {
                self.shading.push(index);
            }
            if away.length() < reach + 3.0 * other.radius {
                self.hiding.push(index);
            }
        }
    }

    /// Those that may stand between the capsule and the sun.
    pub fn shading(&self, capsule: usize) -> &[u16] {
        &self.shading[self.range(capsule, |ends| ends.0)]
    }

    /// Those that may hide a part of the sky from the capsule.
    pub fn hiding(&self, capsule: usize) -> &[u16] {
        &self.hiding[self.range(capsule, |ends| ends.1)]
    }

    fn range(&self, capsule: usize, end: fn(&(usize, usize)) -> usize) -> Range<usize> {
        let start = capsule.checked_sub(1).map_or(0, |before| end(&self.ends[before]));
        start..end(&self.ends[capsule])
    }
}

/// The smallest rectangle on a level plane around some points.
#[derive(Clone, Copy, Debug)]
pub(in crate::draw) struct Footprint {
    pub low: Vec2,
    pub high: Vec2,
}

impl Footprint {
    pub const NOTHING: Footprint =
        Footprint { low: Vec2::splat(f32::INFINITY), high: Vec2::splat(f32::NEG_INFINITY) };

    /// Makes room for a square around `centre`.
    pub fn add(&mut self, centre: Vec2, half: f32) {
        self.low = self.low.min(centre - half);
        self.high = self.high.max(centre + half);
    }

    /// What both rectangles have in common.
    pub fn within(self, other: Footprint) -> Footprint {
        Footprint { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    pub fn is_empty(self) -> bool {
        !(self.low.x < self.high.x && self.low.y < self.high.y)
    }
}

impl Capsule {
    /// Where its shadow falls on the plane at height `floor`, edges included; `None` when all of it is below.
    pub fn shadow(&self, floor: f32) -> Option<Footprint> {
        let mut footprint = Footprint::NOTHING;
        for end in [self.from, self.to] {
            // What is below the plane casts no shadow; a leg that stands in it casts one from the plane up.
            let height = (end.y - floor).max(0.0) / SUN.y;
            let half = (self.radius + height * SUN_SPREAD) * 1.35;
            footprint.add(end.xz() - SUN.xz() * height, half);
        }
        (self.from.y.max(self.to.y) + self.radius > floor).then_some(footprint)
    }

    /// Where it takes light from the plane at height `floor` by being close; `None` when it is too far above or below.
    pub fn contact(&self, floor: f32) -> Option<Footprint> {
        let (low, high) = (self.from.y.min(self.to.y) - floor, self.from.y.max(self.to.y) - floor);
        let mut footprint = Footprint::NOTHING;
        footprint.add(self.from.xz(), CONTACT * self.radius);
        footprint.add(self.to.xz(), CONTACT * self.radius);
        (low < CONTACT * self.radius && high > -self.radius).then_some(footprint)
    }

    /// The share of the sky's light that it takes from `point`, which lies on a level plane: 0 to 1.
    pub fn contact_share(&self, point: Vec3) -> f32 {
        let away = self.nearest(point) - point;
        let squared = away.length_squared().max(1e-12);
        let reach = CONTACT * self.radius;
        let fade = (1.0 - squared / (reach * reach)).max(0.0);
        let size = (self.radius * self.radius / squared).min(1.0);
        let above = (away.y / squared.sqrt()).clamp(0.0, 1.0);
        above * size * fade * fade
    }
}

/// How far a body's contact shade reaches, in its radii.
const CONTACT: f32 = 5.0;
