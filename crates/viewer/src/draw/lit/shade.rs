//! The colours of a capsule's pixels.

use glam::Vec3;

use super::SUN;
use super::light::{LightMaps, Net};
use super::shape::{Body, Hit};
use crate::draw::canvas::Color;
use crate::draw::colors::PALE;

/// The sun's light.
const SUNLIGHT: Vec3 = Vec3::new(1.55, 1.48, 1.32);

/// How strongly the surface shines where it mirrors the sun, and at its rims.
const SHINE: f32 = 0.16;
const RIM: Vec3 = Vec3::new(0.10, 0.13, 0.16);

/// How much paler a body is that is not up to date.
const PALENESS: f32 = 0.62;

/// The directions of the rays through the pixels of a row, with a depth of 1.
pub(super) struct Rays {
    pub start: Vec3,
    pub step: Vec3,
}

/// What gives the pixels of a capsule their colours.
pub(super) struct Shader<'a> {
    pub light: &'a LightMaps,
    pub net: Net,
    pub tones: &'a Tones,
    /// How many pixels apart light is calculated; between them colours change evenly.
    pub apart: usize,
}

impl Shader<'_> {
    /// Colours the run of pixels that ends before `end`.
    pub fn paint(&self, body: &Body, run: &[Hit], rays: &Rays, end: usize, row: &mut [u32]) {
        let Some(last) = run.len().checked_sub(1) else { return };
        let first = end - run.len();
        let mut at = 0;
        let mut color = self.color(body, &run[0], rays, first);
        row[first] = packed(color);
        while at < last {
            // Close to the ends of the run, where surfaces mostly turn away, the steps are short.
            let step = self.apart.min(1 + at.min(last - at)).min(last - at);
            let next = self.color(body, &run[at + step], rays, first + at + step);
            let change = (next - color) / step as f32;
            for pixel in &mut row[first + at + 1..=first + at + step] {
                color += change;
                *pixel = packed(color);
            }
            (at, color) = (at + step, next);
        }
    }

    /// The colour of the pixel in column `x` of the row.
    pub fn pixel(&self, body: &Body, hit: &Hit, rays: &Rays, x: usize) -> Color {
        Color(packed(self.color(body, hit, rays, x)))
    }

    /// Red, green and blue from 0 to 255.
    #[inline]
    fn color(&self, body: &Body, hit: &Hit, rays: &Rays, x: usize) -> Vec3 {
        let capsule = body.capsule;
        let ray = rays.start + rays.step * x as f32;
        let on_axis = hit.along.max(body.start).min(body.end);
        let normal = (body.to_eye + ray * hit.depth - capsule.axis * on_axis).normalize_or_zero();
        // The net lies on the whole capsule, whatever is cut off.
        let light = self.light.at(&self.net, hit.along - body.own_start, normal);
        let (around, sun) = (light.truncate(), light.w);

        let sight = ray * ray.length_recip();
        let half = SUN - sight;
        let mirrored = normal.dot(half).max(0.0);
        let mirrored = (mirrored * mirrored / half.length_squared().max(1e-6)).powi(16);
        // A little light comes from the camera: it shows the shape of what lies in the shade.
        let facing = (-normal.dot(sight)).max(0.0);
        let around = around * (0.72 + 0.5 * facing);
        let rim = 1.0 - facing;
        let rim = rim * rim * rim * (around.x + around.z);
        let lit = capsule.albedo * (SUNLIGHT * (normal.dot(SUN).max(0.0) * sun) + around)
            + Vec3::splat(SHINE * mirrored * sun)
            + RIM * rim;
        let color = self.tones.color(lit);
        let pale = || Vec3::from(PALE.channels().map(f32::from));
        if capsule.pale { color.lerp(pale(), PALENESS) } else { color }
    }
}

/// A colour from 0 to 255 as a pixel.
#[inline]
fn packed(color: Vec3) -> u32 {
    // Beside 2²³ a float's last bits are its whole number.
    let bits = |value: f32| (value + 8_388_608.0).to_bits() & 0xFF;
    (bits(color.x) << 16) | (bits(color.y) << 8) | bits(color.z)
}

/// From light to the numbers of a picture (sRGB), with bright light held back so that it keeps its colour.
pub(super) struct Tones {
    shades: Vec<f32>,
}

const TONES: usize = 4096;

impl Tones {
    pub fn new() -> Tones {
        let shade = |step: usize| {
            let light = step as f32 / TONES as f32;
            let shade =
                if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
            shade * 255.0
        };
        Tones { shades: (0..=TONES).map(shade).collect() }
    }

    #[inline]
    fn color(&self, light: Vec3) -> Vec3 {
        let held = light / (Vec3::ONE + 0.28 * light);
        let shade = |light: f32| self.shades[((light * TONES as f32) as usize).min(TONES)];
        Vec3::new(shade(held.x), shade(held.y), shade(held.z))
    }
}
