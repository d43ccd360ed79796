//! Numbers from a seed.

use std::f32::consts::TAU;

use glam::{Quat, Vec3};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The same seed gives the same throws for ever: ChaCha's numbers never change, and what is made of them is here.
pub(crate) struct Dice(ChaCha8Rng);

impl Dice {
    /// `topic` makes throws for different purposes independent of one another.
    pub(crate) fn new(seed: u64, topic: &str) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        bytes[8..16].copy_from_slice(&fnv1a(topic).to_le_bytes());
        Dice(ChaCha8Rng::from_seed(bytes))
    }

    /// From 0 up to, but not including, 1, in steps that an `f32` holds exactly.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.0.next_u32() >> 8) as f32 / (1 << 24) as f32
    }

    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// One of 0, 1, …, `count` - 1.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f32) as usize
    }

    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }

    /// An angle in degrees whose size is between `low` and `high`, of either sign, with two decimals as in a file.
    pub(crate) fn angle(&mut self, low: f32, high: f32) -> f32 {
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        two_decimals(sign * self.between(low, high))
    }

    /// A vector whose components are between `low` and `high` in size, of either sign.
    pub(crate) fn vector(&mut self, low: f32, high: f32) -> Vec3 {
        Vec3::new(self.angle(low, high), self.angle(low, high), self.angle(low, high))
    }

    /// A turn by 40° to 140° about an axis that no coordinate axis comes near.
    pub(crate) fn rotation(&mut self) -> Quat {
        let axis = self.vector(0.4, 1.0).normalize();
        Quat::from_axis_angle(axis, self.angle(40.0, 140.0) / 360.0 * TAU)
    }
}

/// With two decimals, as in a file.
pub(crate) fn two_decimals(number: f32) -> f32 {
    (number * 100.0).round() / 100.0
}

/// Throws the dice until what they show will do, so often `at_most`. Far fewer throws are needed: the tests of whoever calls
/// this make sure of it.
pub(crate) fn until<T>(at_most: usize, mut throw: impl FnMut() -> T, will_do: impl Fn(&T) -> bool) -> T {
    for _ in 1..at_most {
        let thrown = throw();
        if will_do(&thrown) {
            return thrown;
        }
    }
    #[cfg(test)]
    unreachable!("{at_most} throws, and none will do");
    #[cfg(not(test))]
    throw()
}

/// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits), which never changes.
fn fnv1a(text: &str) -> u64 {
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
