//! How long it takes to reduce a motion to keyframes, for motions of different lengths and next to the naive
//! algorithm, in the same run.
//!
//! `cargo bench -p reduction --bench greedy` prints milliseconds and ratios, medians of interleaved rounds. Short
//! reductions are repeated until they take about as long as those that they are compared with, so that whatever else
//! a machine does slows all of them down alike. It fails when the time grows clearly faster than n log n with the
//! number n of frames, when the naive algorithm is not far behind, or when a motion that stands still is not nearly
//! free.
//!
//! The motion is that of `data/running.bvh`. Longer ones play it back and forth: that is as much movement in a second
//! as in the original, as in a longer recording, which resampling it would not be. The naive algorithm looks at the
//! costs of all removals after each one. For that it poses the gap that would come of each, as fast as the other
//! algorithm poses; the errors of the gaps that are there, which it also needs, it remembers.
#![allow(clippy::unwrap_used)]

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use reduction::{Errors, greedy};
use skeleton::{Frame, Representation};

const ROUNDS: usize = 9;
const SIZES: [usize; 5] = [500, 1_000, 2_000, 4_000, 8_000];
const COUNT: usize = 20;
/// From the smallest size to the largest the time may grow like this power of the number of frames. n log n grows
/// like 1.13.
const STEEPEST: f64 = 1.35;
/// The naive algorithm takes at least so many times as long.
const NAIVE: f64 = 60.0;
/// So many times a reduction is repeated while the naive algorithm runs once.
const REPEATED: usize = 80;
/// A still motion of so many frames takes at most as long as the runner, who has a quarter as many.
const STILL: usize = 5_508;

fn main() -> ExitCode {
    // `cargo test --benches` only wants to know whether this runs.
    let is_bench = std::env::args().any(|argument| argument == "--bench");
    let (rounds, sizes) = if is_bench { (ROUNDS, SIZES) } else { (1, [50, 60, 70, 80, 90]) };
    let motion = parser::bvh::read(&include_bytes!("../../../data/running.bvh")[..]).unwrap().motion;
    let runner: Vec<Frame> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    let shown = if is_bench { &runner[..] } else { &runner[..60] };
    let still = vec![runner[0].clone(); STILL];
    let mut complaints = Vec::new();
    for representation in Representation::ALL {
        let errors = |frames: &[Frame]| Errors::new(motion.skeleton(), frames, representation);
        println!("{representation}, to {COUNT} keyframes");

        let motions = sizes.map(|size| back_and_forth(&runner, size));
        let steps = sizes.map(|size| size as f64 * (size as f64).ln());
        let mut times = [const { Vec::new() }; SIZES.len()];
        for _ in 0..rounds {
            for index in 0..sizes.len() {
                let repeated = (steps[sizes.len() - 1] / steps[index]) as usize;
                times[index].push(reduction_time(&errors, &motions[index], repeated));
            }
        }
        println!("{:>10} {:>12} {:>12} {:>30}", "frames", "ms", "poses", "ms by n log n, to the first");
        for index in 0..sizes.len() {
            let errors = errors(&motions[index]);
            greedy(&errors, COUNT);
            let ratio = median(ratios(&times[index], &times[0])) * steps[0] / steps[index];
            let time = median(times[index].clone());
            println!("{:>10} {time:>12.2} {:>12} {ratio:>29.2}×", sizes[index], errors.poses());
        }
        let power = median(ratios(&times[sizes.len() - 1], &times[0]))
            .log(sizes[sizes.len() - 1] as f64 / sizes[0] as f64);
        println!("{:<36} n^{power:.2} (at most n^{STEEPEST})", "growth of the time");
        if power > STEEPEST {
            complaints.push("the time grows too fast with the number of frames");
        }

        let (heap, still_time) =
            (reduction_time(&errors, shown, REPEATED), reduction_time(&errors, &still, REPEATED));
        let (naive, posed) = naive_time(&errors(shown), shown.len());
        let heap = (heap + reduction_time(&errors, shown, REPEATED)) / 2.0;
        println!("{:<36} {heap:.2} ms", format!("{} frames", shown.len()));
        println!("{:<36} {naive:.0} ms, {posed} poses", "the same by the naive algorithm");
        println!("{:<36} {:.0}× (at least {NAIVE}×)", "naive to heap", naive / heap);
        println!(
            "{:<36} {:.3}× (at most 1×)\n",
            format!("{STILL} still frames, to these"),
            still_time / heap
        );
        if naive < NAIVE * heap {
            complaints.push("the naive algorithm should be farther behind");
        }
        if still_time > heap {
            complaints.push("standing still should be nearly free");
        }
    }
    if is_bench {
        complaints.iter().for_each(|complaint| println!("NOT GOOD ENOUGH: {complaint}"));
    }
    if is_bench && !complaints.is_empty() { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// The milliseconds of one reduction, when it is repeated so many times.
fn reduction_time(errors: &impl Fn(&[Frame]) -> Errors, frames: &[Frame], repeated: usize) -> f64 {
    let once = |_| {
        // Begins without memory, but with its frames prepared.
        let errors = errors(frames);
        milliseconds(|| black_box(greedy(&errors, COUNT)))
    };
    (0..repeated).map(once).sum::<f64>() / repeated as f64
}

fn ratios(times: &[f64], to: &[f64]) -> Vec<f64> {
    times.iter().zip(to).map(|(time, to)| time / to).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Once from the first frame to the last, then back, and so on.
fn back_and_forth(frames: &[Frame], count: usize) -> Vec<Frame> {
    let last = frames.len() - 1;
    let place = |index: usize| last.abs_diff(index % (2 * last));
    (0..count).map(|index| frames[last - place(index)].clone()).collect()
}

/// The milliseconds and the poses of the naive algorithm, which must leave the same keyframes.
fn naive_time(errors: &Errors, frame_count: usize) -> (f64, u64) {
    let mut keyframes: Vec<usize> = (0..frame_count).collect();
    // The error of the gap behind each keyframe.
    let mut gaps = vec![0.0; frame_count];
    let time = milliseconds(|| {
        while keyframes.len() > COUNT {
            let cost = |index: usize| {
                posed(errors, keyframes[index - 1], keyframes[index + 1]) - gaps[index - 1] - gaps[index]
            };
            let costs = (1..keyframes.len() - 1).map(|index| (index, cost(index)));
            let (index, _) = costs.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            gaps[index - 1] = posed(errors, keyframes[index - 1], keyframes[index + 1]);
            gaps.remove(index);
            keyframes.remove(index);
        }
    });
    let poses = errors.poses();
    assert_eq!(keyframes, greedy(errors, COUNT), "both algorithms leave the same keyframes");
    (time, poses)
}

/// The error of a gap, with nothing remembered.
fn posed(errors: &Errors, start: usize, end: usize) -> f64 {
    (start + 1..end).map(|frame| errors.of_frame(start, end, frame)).sum()
}

fn milliseconds<T>(run: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e3
}
