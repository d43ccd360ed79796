//! How much of a greedy choice is chance.

use std::ops::ControlFlow;

use reduction::curve;
use skeleton::Motion;

use super::Clip;
use super::tables::{grouped, header, row};

/// So many motions are tried that differ in their last digits only.
const TRIALS: u64 = 8;

/// Numbers change by at most so much, up or down: what a file with four decimals has lost by rounding.
const MOST: f64 = 0.000_05;

/// The greedy error of motions that nobody could tell from the original.
pub fn table(clips: &[(&Clip, &[usize])]) -> String {
    let mut text =
        header(&["motion", "keyframes", "interpolated", "greedy error, least", "greedy error, largest"]);
    for (clip, counts) in clips {
        let fewest = counts.iter().copied().min().unwrap_or(2);
        let all: Vec<Clip> =
            (0..TRIALS).map(|trial| Clip::new(clip.name, with_noise(&clip.motion, trial))).collect();
        let down = |errors| curve(errors, fewest, &mut |_, _| ControlFlow::Continue(())).errors;
        let curves: Vec<[Vec<f64>; 2]> = all.iter().map(|clip| clip.errors.each_ref().map(down)).collect();
        for count in *counts {
            let interpolated = clip.motion.frame_count().saturating_sub(*count);
            for (at, errors) in clip.errors.iter().enumerate() {
                let ends = curves.iter().filter_map(|curves| curves[at].get(interpolated).copied());
                let (least, largest) = ends.fold((f64::INFINITY, 0.0_f64), |(least, largest), error| {
                    (least.min(error), largest.max(error))
                });
                text += &row(&[
                    format!("`{}.bvh`", clip.name),
                    count.to_string(),
                    errors.clip().representation().to_string(),
                    grouped(least),
                    grouped(largest),
                ]);
            }
        }
    }
    text
}

/// All numbers are a little larger or smaller, as if the file had been rounded in another way.
fn with_noise(motion: &Motion, trial: u64) -> Motion {
    // Steps of D. Lehmer's generator, good enough for this.
    let mut state = 2 * trial + 1;
    let mut other = |value: &f32| {
        state = state.wrapping_mul(0xda94_2042_e4dd_58b5);
        let share = (state >> 32) as f64 / f64::from(u32::MAX);
        (f64::from(*value) + MOST * (2.0 * share - 1.0)) as f32
    };
    let values = motion.values().iter().map(&mut other).collect();
    let noisy = Motion::new(motion.skeleton().clone(), motion.frame_count(), motion.frame_time(), values);
    noisy.expect("there are as many values as before")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_even_and_small_and_every_time_the_same() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/dance.bvh");
        let motion = parser::bvh::read_file(path).unwrap().motion;
        for trial in 0..TRIALS {
            let noisy = with_noise(&motion, trial);
            assert_eq!(with_noise(&motion, trial), noisy);
            let pairs = noisy.values().iter().zip(motion.values());
            let changes: Vec<f64> = pairs.map(|(a, b)| f64::from(*a) - f64::from(*b)).collect();
            // Numbers of some hundreds are rounded once more, to 0.00003.
            assert!(changes.iter().all(|change| change.abs() < MOST + 0.000_04));
            let mean = changes.iter().sum::<f64>() / changes.len() as f64;
            let middle = changes.iter().filter(|change| change.abs() < MOST / 2.0).count() as f64;
            assert!(mean.abs() < 0.05 * MOST, "{mean}");
            assert!((0.45..0.55).contains(&(middle / changes.len() as f64)));
        }
    }
}
