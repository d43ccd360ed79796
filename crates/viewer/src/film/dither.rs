//! From any colour to one of a palette.
//!
//! A colour between two of the palette becomes a pattern of both (ordered dithering, Bayer 1973). The pattern stands still: the
//! same colour at the same place is always the same index, so that nothing flickers where nothing moves.

use super::palette::WEIGHTS;
use crate::canvas::Color;

/// How much a pattern of two colours is disliked for being a pattern: 0 mixes colours that lie far apart, 1 none.
const DISLIKE: f32 = 0.25;

/// How many colours are remembered: a power of two.
const REMEMBERED: usize = 1 << 16;

/// Finds colours of a palette.
pub(super) struct Dither {
    palette: Vec<[f32; 3]>,
    memory: Vec<Mix>,
}

/// What stands for a colour.
#[derive(Clone, Copy)]
struct Mix {
    color: u32,
    near: u8,
    other: u8,
    /// How many of 64 pixels are of the other colour.
    share: u8,
}

/// A number that is no colour.
const NONE: u32 = u32::MAX;

impl Dither {
    /// `colors` are 1 to 256.
    pub fn new(colors: &[[u8; 3]]) -> Dither {
        let palette = colors.iter().map(|color| stretched(*color)).collect();
        Dither { palette, memory: vec![Mix { color: NONE, near: 0, other: 0, share: 0 }; REMEMBERED] }
    }

    /// The palette's index for `color` at a place of the picture.
    pub fn index(&mut self, color: u32, x: usize, y: usize) -> u8 {
        // Fibonacci hashing: neighbouring colours get places far apart.
        let at = color.wrapping_mul(0x9E37_79B9) as usize >> 16 & (REMEMBERED - 1);
        if self.memory[at].color != color {
            self.memory[at] = self.mix(color);
        }
        let mix = self.memory[at];
        if THRESHOLDS[y % 8][x % 8] < mix.share { mix.other } else { mix.near }
    }

    /// The nearest colour, and the one that makes the best pattern with it.
    fn mix(&self, color: u32) -> Mix {
        let wanted = stretched(Color(color).channels());
        let distance = |at: &[f32; 3]| squared(sub(*at, wanted));
        let near = least(self.palette.iter().map(distance));
        let from = self.palette[near];
        let to_wanted = sub(wanted, from);
        let share = |at: &[f32; 3]| {
            let along = sub(*at, from);
            (dot(to_wanted, along) / squared(along).max(1e-6)).clamp(0.0, 0.5)
        };
        let other = least(self.palette.iter().map(|at| {
            let (along, share) = (sub(*at, from), share(at));
            let left = sub(to_wanted, along.map(|length| share * length));
            squared(left) + DISLIKE * share * (1.0 - share) * squared(along)
        }));
        let share = (64.0 * share(&self.palette[other])).round() as u8;
        Mix { color, near: near as u8, other: other as u8, share }
    }
}

/// The index of the least number.
fn least(numbers: impl Iterator<Item = f32>) -> usize {
    let mut best = (f32::INFINITY, 0);
    for (index, number) in numbers.enumerate() {
        if number < best.0 {
            best = (number, index);
        }
    }
    best.1
}

fn stretched(channels: [u8; 3]) -> [f32; 3] {
    [0, 1, 2].map(|c| f32::from(channels[c]) * (WEIGHTS[c] as f32).sqrt())
}

fn sub(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn squared(a: [f32; 3]) -> f32 {
    dot(a, a)
}

/// Bayer's pattern: of each share the pixels lie as far apart as they can.
const THRESHOLDS: [[u8; 8]; 8] = {
    let mut table = [[0; 8]; 8];
    let mut at = 0;
    while at < 64 {
        let (x, y) = (at % 8, at / 8);
        // The bits of x ^ y and y, woven together, the lowest first.
        let (a, b) = (x ^ y, y);
        let mut value = 0;
        let mut bit = 0;
        while bit < 3 {
            value = value << 2 | (a >> bit & 1) << 1 | (b >> bit & 1);
            bit += 1;
        }
        table[y][x] = value as u8;
        at += 1;
    }
    table
};
