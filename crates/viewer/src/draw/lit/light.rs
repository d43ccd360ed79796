//! The light that changes slowly over a body: what arrives from the sky and the ground, and which share of the sun is
//! seen past the other bodies. It is calculated at the crossings of a net over each capsule.

use std::f32::consts::TAU;
use std::ops::Range;

use glam::{Vec3, Vec4};

use super::SUN;
use super::capsule::{Capsule, MOST_MUTUAL, Neighbours};
use super::shadow::GroundShadow;
use super::shape::Body;
use crate::camera::View;

/// The net's crossings lie about this many pixels apart in the picture…
const PIXELS_APART: f32 = 7.0;
/// … but there are never more or fewer of them than this, along a capsule and around it.
const ALONG: (f32, f32) = (5.0, 18.0);
const AROUND: (f32, f32) = (8.0, 20.0);

/// The light of the sky from straight above, and of the ground from straight below.
const SKY: Vec3 = Vec3::new(0.40, 0.47, 0.58);
const GROUND: Vec3 = Vec3::new(0.30, 0.28, 0.25);

/// How far points are lifted off their surface, and the least width of a shadow's edge, in sizes of the figure.
const LIFT: f32 = 0.005;
const BLUR: f32 = 0.004;

/// Closer to another bone's axis than this many squared radii a point lies inside of it: nobody sees it, and a shade
/// there would show as a dark rim where the two bodies meet.
const INSIDE: f32 = 1.1;

/// The nets of all capsules.
#[derive(Default)]
pub(super) struct LightMaps {
    /// The light from all around as red, green and blue, and the share of the sun.
    light: Vec<Vec4>,
    nets: Vec<Net>,
}

/// Where the net of one capsule is in the list, and how it lies on the capsule.
#[derive(Clone, Copy)]
pub(super) struct Net {
    first: usize,
    along: usize,
    around: usize,
    /// Crossings per length.
    per_length: f32,
    /// Crossings per quarter turn.
    per_quarter: f32,
    radius: f32,
    /// At a right angle to the capsule and to each other.
    aside: [Vec3; 2],
}

impl LightMaps {
    /// Lights those of `capsules` anew that may be seen in a picture of `size`.
    pub fn shine(
        &mut self,
        capsules: &[Capsule],
        near: &Neighbours,
        ground: &GroundShadow,
        lens: &View,
        size: (usize, usize),
    ) {
        self.light.clear();
        self.nets.clear();
        // As much as any view of them needs: the next picture takes no new memory.
        self.light.reserve(capsules.len().min(MOST_MUTUAL) * (ALONG.1 * (AROUND.1 + 1.0)) as usize);
        for (index, capsule) in capsules.iter().enumerate() {
            let net = Net::new(capsule, self.light.len(), lens);
            self.nets.push(net);
            if !Body::new(capsule, lens).is_some_and(|body| body.is_inside(size)) {
                continue;
            }
            let around =
                Surroundings { capsules, shading: near.shading(index), hiding: near.hiding(index), ground };
            for row in 0..net.around {
                let outwards = net.outwards(4.0 * row as f32 / net.around as f32);
                let hidden = net.hidden_columns(capsule, outwards, lens);
                for column in 0..net.along {
                    let (point, normal) = net.surface(capsule, column, outwards);
                    let light =
                        if hidden.contains(&column) { Vec4::ZERO } else { around.light(point, normal) };
                    self.light.push(light);
                }
            }
            // The first row once more, so that a look-up needs no end.
            self.light.extend_from_within(net.first..net.first + net.along);
        }
    }

    /// The net of a capsule.
    pub fn net(&self, capsule: usize) -> Net {
        self.nets[capsule]
    }

    /// The light, and the share of the sun, on a net where its capsule's surface is this far along the axis and has
    /// this normal.
    #[inline]
    pub fn at(&self, net: &Net, along: f32, normal: Vec3) -> Vec4 {
        let column = ((along + net.radius) * net.per_length).clamp(0.0, net.along as f32 - 1.001);
        let quarters = quarters(normal.dot(net.aside[0]), normal.dot(net.aside[1]));
        let row = (quarters * net.per_quarter).clamp(0.0, net.around as f32 - 0.001);
        let (left, upper) = (column as usize, row as usize);
        let (right, down) = (column - left as f32, row - upper as f32);
        let first = net.first + upper * net.along + left;
        let Some(light) = self.light.get(first..first + net.along + 2) else { return Vec4::ONE };
        let upper = light[0] + (light[1] - light[0]) * right;
        let lower = light[net.along] + (light[net.along + 1] - light[net.along]) * right;
        upper + (lower - upper) * down
    }
}

impl Net {
    fn new(capsule: &Capsule, first: usize, lens: &View) -> Net {
        let depth = (capsule.from.midpoint(capsule.to) - lens.eye).length().max(capsule.radius);
        let per_length = lens.focal / (depth * PIXELS_APART);
        let length = capsule.length + 2.0 * capsule.radius;
        let along = (length * per_length).clamp(ALONG.0, ALONG.1) as usize;
        let around = (TAU * capsule.radius * per_length).clamp(AROUND.0, AROUND.1) as usize;
        // Turned to the sun, so that the net does not jump over the body when the bone moves a little.
        let across = capsule.axis.cross(SUN);
        let one = across.try_normalize().unwrap_or_else(|| capsule.axis.any_orthonormal_vector());
        Net {
            first,
            along,
            around,
            per_length: (along - 1) as f32 / length,
            per_quarter: 0.25 * around as f32,
            radius: capsule.radius,
            aside: [one, capsule.axis.cross(one)],
        }
    }

    /// The direction away from the axis after this many quarter turns, in the measure of [`quarters`].
    fn outwards(&self, turned: f32) -> Vec3 {
        let (one, other) = match turned {
            ..1.0 => (1.0 - turned, turned),
            ..2.0 => (1.0 - turned, 2.0 - turned),
            ..3.0 => (turned - 3.0, 2.0 - turned),
            _ => (turned - 3.0, turned - 4.0),
        };
        (self.aside[0] * one + self.aside[1] * other).normalize_or_zero()
    }

    /// The columns of a row that nobody looks up, because that side of the capsule is turned away from the camera. The
    /// ends of the capsule, which are turned to all sides, are not among them.
    fn hidden_columns(&self, capsule: &Capsule, outwards: Vec3, lens: &View) -> Range<usize> {
        let to_eye = lens.eye - capsule.from;
        let away = (to_eye - capsule.axis * to_eye.dot(capsule.axis)).normalize_or_zero();
        // Rows are looked up as long as one beside them is seen.
        let turned_away = outwards.dot(away) < -8.5 / self.around as f32;
        let first = (capsule.radius * self.per_length).ceil() as usize + 1;
        let end = ((capsule.radius + capsule.length) * self.per_length).floor() as usize;
        if turned_away { first..end } else { 0..0 }
    }

    /// The point of a capsule's surface at a column of the net, and the normal there.
    fn surface(&self, capsule: &Capsule, column: usize, outwards: Vec3) -> (Vec3, Vec3) {
        let along = column as f32 / self.per_length - capsule.radius;
        let on_axis = along.clamp(0.0, capsule.length);
        let lean = ((along - on_axis) / capsule.radius).clamp(-1.0, 1.0);
        let normal = capsule.axis * lean + outwards * (1.0 - lean * lean).sqrt();
        (capsule.from + capsule.axis * on_axis + normal * capsule.radius, normal)
    }
}

/// A direction in the plane as the way along a square that stands on its corner, 0 to 4: it grows with the angle as
/// an arc tangent does, and is found without one.
#[inline]
fn quarters(one: f32, other: f32) -> f32 {
    let share = other / (one.abs() + other.abs()).max(1e-6);
    match (one >= 0.0, share >= 0.0) {
        (true, true) => share,
        (true, false) => 4.0 + share,
        (false, _) => 2.0 - share,
    }
}

/// What takes light from a capsule.
struct Surroundings<'a> {
    capsules: &'a [Capsule],
    shading: &'a [u16],
    hiding: &'a [u16],
    ground: &'a GroundShadow,
}

impl Surroundings<'_> {
    fn light(&self, point: Vec3, normal: Vec3) -> Vec4 {
        let open = self.open(point, normal);
        let up = 0.5 + 0.5 * normal.y;
        // Close above the ground, the body itself keeps the sky's light from what is below it.
        let height = point.y - self.ground.floor();
        let lifted = 1.0 - 0.55 * (-normal.y).max(0.0) * (1.0 - 4.8 * height).clamp(0.0, 1.0);
        let thrown_back = (1.0 - up) * (0.4 + 0.6 * self.ground.sun_below(point));
        let around = SKY * ((0.15 + 0.85 * up) * lifted) + GROUND * thrown_back;
        (around * open).extend(self.sun(point, normal))
    }

    /// The share of the sun.
    fn sun(&self, point: Vec3, normal: Vec3) -> f32 {
        // Surfaces that turn away from it are dark in any case.
        if normal.dot(SUN) < -0.25 {
            return 1.0;
        }
        let lifted = point + normal * LIFT;
        let mut share = 1.0f32;
        for other in self.shading.iter().map(|index| &self.capsules[usize::from(*index)]) {
            let inside = INSIDE * other.radius * other.radius;
            if share > 0.0 && other.nearest(point).distance_squared(point) > inside {
                share = share.min(other.sun_share(lifted, BLUR));
            }
        }
        share
    }

    /// The share of the light from all around that other bodies leave.
    fn open(&self, point: Vec3, normal: Vec3) -> f32 {
        let mut open = 1.0;
        for other in self.hiding.iter().map(|index| &self.capsules[usize::from(*index)]) {
            let away = other.nearest(point) - point;
            let (squared, radius_squared) = (away.length_squared(), other.radius * other.radius);
            if squared > INSIDE * radius_squared {
                let ahead = (0.8 * normal.dot(away) / squared.sqrt() + 0.2).clamp(0.0, 1.0);
                open *= 1.0 - 0.75 * ahead * (radius_squared / squared).min(1.0);
            }
        }
        open
    }
}
