//! How fast motions are read, next to the crate `bvh_anim`, in the same run.
//!
//! `cargo bench -p parser` prints megabytes per second, and how many times as fast this crate is. The two take
//! turns, many rounds long. Of the speeds the best counts, because whatever else a machine does can only slow a
//! round down. The ratio is that of the best speeds, and then the median of the ratios in each round.

use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 31;

fn main() {
    // `cargo test --benches` only wants to know whether this runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { ROUNDS } else { 1 };
    println!("{:<44} {:>12} {:>12} {:>8} {:>8}", "", "parser", "bvh_anim", "best", "median");
    compare("6 decimals, 20,000 frames of 63 channels", &motion(20_000, 63, decimals(6)), rounds);
    compare("4 decimals, 2,752 frames of 96 channels", &motion(2_752, 96, decimals(4)), rounds);
    compare("4 decimals, 1 of 8 with exponent", &motion(2_752, 96, some_exponents), rounds);
    compare("exponents everywhere", &motion(2_752, 96, exponent), rounds);
}

fn compare(title: &str, text: &str, rounds: usize) {
    let (mut ours, mut theirs, mut ratios) = (f64::MAX, f64::MAX, Vec::new());
    for _ in 0..rounds {
        let our = seconds(|| black_box(parser::bvh::read(text.as_bytes()).is_ok()));
        let their = seconds(|| black_box(bvh_anim::from_bytes(text).is_ok()));
        (ours, theirs) = (ours.min(our), theirs.min(their));
        ratios.push(their / our);
    }
    ratios.sort_by(f64::total_cmp);
    let (best, median) = (theirs / ours, ratios[rounds / 2]);
    let [ours, theirs] = [ours, theirs].map(|seconds| text.len() as f64 / 1e6 / seconds);
    println!("{title:<44} {ours:>7.0} MB/s {theirs:>7.0} MB/s {best:>7.1}× {median:>7.1}×");
}

fn seconds(read: impl FnOnce() -> bool) -> f64 {
    let start = Instant::now();
    assert!(read(), "the text is read");
    start.elapsed().as_secs_f64()
}

/// A chain of joints with `channels` channels in all, and `frames` rows of numbers made by `number`.
fn motion(frames: usize, channels: usize, number: impl Fn(&mut String, f64)) -> String {
    let mut text = String::from("HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 0\n");
    text.push_str("\tCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n");
    let joints = (channels - 6) / 3;
    for joint in 0..joints {
        let _ = writeln!(
            text,
            "JOINT Joint{joint}\n{{\nOFFSET 0 1.5 0\nCHANNELS 3 Zrotation Yrotation Xrotation"
        );
    }
    text.push_str("End Site\n{\nOFFSET 0 1.5 0\n}\n");
    text.push_str(&"}\n".repeat(joints + 1));
    let _ = writeln!(text, "MOTION\nFrames: {frames}\nFrame Time: 0.0083333");
    // Every channel swings on its own, as in a real motion: by how much, how fast, and about which angle.
    let swings: Vec<[f64; 3]> = (0..channels)
        .map(|channel| channel as f64 * 0.618)
        .map(|x| {
            [
                60.0 * x.fract().powi(2),
                0.02 + 0.05 * (x * 7.0).fract(),
                200.0 * ((x * 3.0).fract() - 0.5).powi(3),
            ]
        })
        .collect();
    for frame in 0..frames {
        for (channel, [size, speed, middle]) in swings.iter().enumerate() {
            text.push_str(if channel == 0 { "" } else { " " });
            number(&mut text, middle + size * (speed * frame as f64 + channel as f64).sin());
        }
        text.push('\n');
    }
    text
}

fn decimals(count: usize) -> impl Fn(&mut String, f64) {
    move |text, value| {
        let _ = write!(text, "{value:.count$}");
    }
}

/// Numbers close to zero as C programs write them: `-1.30506e-006`.
fn some_exponents(text: &mut String, value: f64) {
    if value.abs() < 0.35 { exponent(text, value * 1e-5) } else { decimals(4)(text, value) }
}

fn exponent(text: &mut String, value: f64) {
    let shown = format!("{value:.5e}");
    let (digits, exponent) = shown.split_once('e').unwrap_or((&shown, "0"));
    let (sign, exponent) = exponent.strip_prefix('-').map_or(("+", exponent), |exponent| ("-", exponent));
    let _ = write!(text, "{digits}e{sign}{exponent:0>3}");
}
