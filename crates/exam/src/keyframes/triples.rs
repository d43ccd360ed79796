//! One number for any three frames.

use serde::{Deserialize, Serialize};

/// One number for every three frames a < b < c of a short motion. A million triples belong to 180 frames.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Triples {
    frames: usize,
    values: Vec<f64>,
}

impl Triples {
    /// Asks `value` for all triples of a motion of `frames` frames.
    pub fn new(frames: usize, mut value: impl FnMut(usize, usize, usize) -> f64) -> Triples {
        let mut values = Vec::new();
        for_each(frames, |a, b, c| values.push(value(a, b, c)));
        Triples { frames, values }
    }

    /// The number that belongs to a < b < c; not a number for any others.
    pub fn get(&self, a: usize, b: usize, c: usize) -> f64 {
        if !(a < b && b < c && c < self.frames) {
            return f64::NAN;
        }
        self.values.get(rank(self.frames, a, b, c)).copied().unwrap_or(f64::NAN)
    }
}

/// Visits all triples of `frames` frames in their order: by the first, then by the second, then by the third.
pub(crate) fn for_each(frames: usize, mut visit: impl FnMut(usize, usize, usize)) {
    for a in 0..frames {
        for b in a + 1..frames {
            for c in b + 1..frames {
                visit(a, b, c);
            }
        }
    }
}

/// The place of a < b < c in that order.
pub(crate) fn rank(frames: usize, a: usize, b: usize, c: usize) -> usize {
    let pairs = |n: usize| n * n.saturating_sub(1) / 2;
    let triples = |n: usize| pairs(n) * n.saturating_sub(2) / 3;
    let before_a = triples(frames) - triples(frames - a);
    let before_b = pairs(frames - a - 1) - pairs(frames - b);
    before_a + before_b + (c - b - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_triple_has_its_own_place() {
        for frames in [0, 1, 2, 3, 4, 7, 12] {
            let mut next = 0;
            for_each(frames, |a, b, c| {
                assert_eq!(rank(frames, a, b, c), next, "{a} {b} {c} of {frames}");
                next += 1;
            });
        }
    }

    #[test]
    fn what_is_no_triple_has_no_number() {
        let triples = Triples::new(5, |a, b, c| (100 * a + 10 * b + c) as f64);
        assert_eq!(triples.get(1, 3, 4), 134.0);
        for (a, b, c) in [(1, 1, 2), (2, 1, 3), (0, 1, 5), (7, 8, 9)] {
            assert!(triples.get(a, b, c).is_nan());
        }
    }
}
