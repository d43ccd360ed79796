//! From any colour to one of a palette.
//!
//! A colour between two of the palette becomes a pattern of both (ordered dithering, Bayer 1973). The pattern stands still: the
//! same colour at the same place is always the same index, so that nothing flickers where nothing moves.

use super::palette::WEIGHTS;
use crate::draw::canvas::Color;

/// How much a pattern of two colours is disliked for being seen: 0 mixes colours that lie far apart, 1 none.
const DISLIKE: f32 = 0.25;

/// Patterns of colours that are this near to each other, in steps of a channel, are not seen.
const UNSEEN: f32 = 6.0;

/// How many colours are remembered: a power of two.
const REMEMBERED: usize = 1 << 16;

/// Finds colours of a palette.
pub(super) struct Dither {
    palette: Palette,
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
        let nothing = Mix { color: NONE, near: 0, other: 0, share: 0 };
        Dither { palette: Palette::new(colors), memory: vec![nothing; REMEMBERED] }
    }

    /// Calls `put` for each pixel of a part of row `y`, which begins in column `left`, with its number in the part and
    /// the palette's index for it.
    pub fn row(&mut self, pixels: &[u32], (left, y): (usize, usize), mut put: impl FnMut(usize, u8)) {
        let thresholds = THRESHOLDS[y % 8];
        let mut mix = Mix { color: NONE, near: 0, other: 0, share: 0 };
        for (x, color) in pixels.iter().enumerate() {
            if mix.color != *color {
                mix = self.mix(*color);
            }
            put(x, if thresholds[(left + x) % 8] < mix.share { mix.other } else { mix.near });
        }
    }

    fn mix(&mut self, color: u32) -> Mix {
        // Fibonacci hashing: neighbouring colours get places far apart.
        let at = color.wrapping_mul(0x9E37_79B9) as usize >> 16 & (REMEMBERED - 1);
        if self.memory[at].color != color {
            self.memory[at] = self.palette.mix(color);
        }
        self.memory[at]
    }
}

/// The colours, channel by channel, so that many are looked at at once; the places that are left over hold the first.
struct Palette {
    channels: [[f32; 256]; 3],
}

impl Palette {
    fn new(colors: &[[u8; 3]]) -> Palette {
        let color = |i: usize| stretched(colors.get(i).or(colors.first()).copied().unwrap_or_default());
        Palette { channels: [0, 1, 2].map(|c| std::array::from_fn(|i| color(i)[c])) }
    }

    fn color(&self, index: usize) -> [f32; 3] {
        [0, 1, 2].map(|c| self.channels[c][index])
    }

    /// The nearest colour, and the one that makes the best pattern with it.
    fn mix(&self, color: u32) -> Mix {
        let unseen = UNSEEN * UNSEEN * WEIGHTS.iter().sum::<i32>() as f32;
        let wanted = stretched(Color(color).channels());
        let near = least(|i| squared(sub(self.color(i), wanted)));
        let from = self.color(near);
        let to_wanted = sub(wanted, from);
        let share = |along: [f32; 3]| (dot(to_wanted, along) / squared(along).max(1e-6)).clamp(0.0, 0.5);
        let other = least(|i| {
            let along = sub(self.color(i), from);
            let share = share(along);
            let left = sub(to_wanted, along.map(|length| share * length));
            squared(left) + DISLIKE * share * (1.0 - share) * (squared(along) - unseen).max(0.0)
        });
        let share = (64.0 * share(sub(self.color(other), from))).round() as u8;
        Mix { color, near: near as u8, other: other as u8, share }
    }
}

/// The index from 0 to 255 for which a number is least.
fn least(number: impl Fn(usize) -> f32) -> usize {
    let numbers: [f32; 256] = std::array::from_fn(number);
    let mut lanes = [f32::INFINITY; 8];
    for chunk in numbers.chunks_exact(8) {
        for (lane, number) in lanes.iter_mut().zip(chunk) {
            *lane = if number < lane { *number } else { *lane };
        }
    }
    let least = lanes.into_iter().fold(f32::INFINITY, f32::min);
    numbers.iter().position(|number| *number == least).unwrap_or(0)
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn indices(dither: &mut Dither, color: u32) -> Vec<u8> {
        let mut indices = Vec::new();
        for y in 0..8 {
            dither.row(&[color; 8], (0, y), |_, index| indices.push(index));
        }
        indices
    }

    #[test]
    fn every_threshold_occurs_once() {
        let mut all: Vec<u8> = THRESHOLDS.into_iter().flatten().collect();
        assert_eq!(THRESHOLDS[0][..4], [0, 32, 8, 40]);
        all.sort_unstable();
        assert_eq!(all, (0..64).collect::<Vec<u8>>());
    }

    #[test]
    fn a_colour_between_two_is_a_pattern_of_both_with_its_mean() {
        let mut dither = Dither::new(&[[100; 3], [108; 3], [255, 0, 0]]);
        for grey in 100..=108u32 {
            let indices = indices(&mut dither, grey << 16 | grey << 8 | grey);
            let light = indices.iter().filter(|index| **index == 1).count() as u32;
            assert!(indices.iter().all(|index| *index < 2));
            assert_eq!(light, 8 * (grey - 100), "of 64 pixels, for {grey}");
        }
    }

    #[test]
    fn colours_far_apart_are_not_mixed_and_those_of_the_palette_stay_plain() {
        let mut dither = Dither::new(&[[0; 3], [255; 3], [40, 90, 200]]);
        for (color, index) in [(0, 0), (0xFF_FF_FF, 1), (0x28_5A_C8, 2)] {
            assert_eq!(indices(&mut dither, color), [index; 64]);
        }
    }

    proptest! {
        #[test]
        fn a_part_of_a_row_is_what_it_is_in_the_whole_row(
            colors in proptest::collection::vec(any::<[u8; 3]>(), 1..=255),
            row in proptest::collection::vec(0u32..=0xFF_FF_FF, 1..40),
            cut in 0usize..40,
            y in 0usize..20,
        ) {
            let cut = cut.min(row.len());
            let mut whole = vec![0; row.len()];
            Dither::new(&colors).row(&row, (0, y), |x, index| whole[x] = index);
            prop_assert!(whole.iter().all(|index| usize::from(*index) < colors.len()));
            let mut part = vec![0; row.len() - cut];
            Dither::new(&colors).row(&row[cut..], (cut, y), |x, index| part[x] = index);
            prop_assert_eq!(&whole[cut..], &part[..]);
        }
    }
}
