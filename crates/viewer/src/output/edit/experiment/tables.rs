//! The tables, as Markdown.

use std::thread;

use clap::ValueEnum;
use inbetween::{InbetweenClip, Scratch};
use reduction::Errors;
use skeleton::RotationOrder;

use super::Clip;
use crate::output::edit::{Choice, Method, reordered, rms};

/// Keyframes as far apart as this, in frames.
const GAPS: [usize; 6] = [2, 4, 8, 16, 32, 64];

/// What the four ways of choosing `count` keyframes come to. Without `optimum`, that one is left out.
pub fn methods(clip: &mut Clip, count: usize, optimum: bool) -> String {
    let mut text = header(&[
        "keyframes",
        "error, Euler angles",
        "error, quaternions",
        "RMS, Euler angles",
        "RMS, quaternions",
    ]);
    for method in
        Method::value_variants().iter().copied().filter(|method| optimum || *method != Method::Optimum)
    {
        // One thread for each representation: the optimum of a long motion takes a while.
        let [euler, quaternions] = thread::scope(|scope| {
            let threads =
                clip.errors.each_mut().map(|errors| scope.spawn(move || error_of(method, errors, count)));
            threads.map(|thread| thread.join().unwrap_or(f64::NAN))
        });
        let of = |at: usize, error| format!("{:.2}", rms(&clip.errors[at], error));
        text += &row(&[
            method.name().to_owned(),
            grouped(euler),
            grouped(quaternions),
            of(0, euler),
            of(1, quaternions),
        ]);
    }
    text
}

/// Not a number when an optimum takes too long, or is not that of all keyframes.
fn error_of(method: Method, errors: &Errors, count: usize) -> f64 {
    match method.choose(errors, count, &mut |_, _| ()) {
        Ok(Choice { keyframes, cap: None }) => errors.of_keyframes(&keyframes),
        _ => f64::NAN,
    }
}

/// By how much the error of quaternions is larger or smaller than that of Euler angles when every so-manieth frame is a
/// keyframe.
pub fn gaps(clips: &[&Clip]) -> String {
    let names: Vec<String> = clips.iter().map(|clip| format!("`{}.bvh`", clip.name)).collect();
    let mut titles = vec!["a keyframe every"];
    titles.extend(names.iter().map(String::as_str));
    let mut text = header(&titles);
    for gap in GAPS {
        let mut cells = vec![format!("{gap} frames")];
        for clip in clips {
            let keyframes = every(gap, clip.motion.frame_count());
            let [euler, quaternions] = clip.errors.each_ref().map(|errors| errors.of_keyframes(&keyframes));
            cells.push(percent(quaternions / euler - 1.0));
        }
        text += &row(&cells);
    }
    text
}

/// The same for each tip, with a keyframe every `gap` frames.
pub fn tips(clip: &Clip, gap: usize) -> String {
    let keyframes = every(gap, clip.motion.frame_count());
    let sums = clip.errors.each_ref().map(|errors| errors_of_tips(errors.clip(), &keyframes));
    let mut text =
        header(&["tip", "error, Euler angles", "error, quaternions", "quaternions against Euler angles"]);
    let skeleton = clip.motion.skeleton();
    let is_parent = |id| skeleton.joints().iter().any(|joint| joint.parent == Some(id));
    let tips = skeleton.joints().iter().filter(|joint| !is_parent(joint.id));
    for ((tip, euler), quaternions) in tips.zip(&sums[0]).zip(&sums[1]) {
        text += &row(&[
            skeleton.label(tip.id),
            grouped(*euler),
            grouped(*quaternions),
            percent(quaternions / euler - 1.0),
        ]);
    }
    text
}

fn errors_of_tips(clip: &InbetweenClip, keyframes: &[usize]) -> Vec<f64> {
    let mut sums = vec![0.0; clip.tips(0).len()];
    let mut scratch = Scratch::default();
    for gap in keyframes.windows(2) {
        for frame in gap[0]..gap[1] {
            let tips = clip.tips_between(gap[0], gap[1], frame, &mut scratch);
            for (sum, (tip, original)) in sums.iter_mut().zip(tips.iter().zip(clip.tips(frame))) {
                *sum += f64::from(tip.distance_squared(*original));
            }
        }
    }
    sums
}

/// Keyframes so many frames apart, and the last frame.
fn every(gap: usize, frame_count: usize) -> Vec<usize> {
    let last = frame_count.saturating_sub(1);
    (0..last).step_by(gap).chain([last]).collect()
}

/// How far one gets with each representation.
pub fn curves(clips: &[&Clip]) -> String {
    let mut text = header(&[
        "motion",
        "interpolated",
        "frames that can be interpolated up to an RMS of 1",
        "of all frames",
    ]);
    for clip in clips {
        for (errors, curve) in clip.errors.iter().zip(&clip.curves) {
            let good = curve.errors.iter().take_while(|error| rms(errors, **error) <= 1.0).count();
            let good = good.saturating_sub(1);
            text += &row(&[
                format!("`{}.bvh`", clip.name),
                errors.clip().representation().to_string(),
                grouped(good as f64),
                format!("{:.0} %", 100.0 * good as f64 / clip.motion.frame_count() as f64),
            ]);
        }
    }
    text
}

/// The removals that lower the error.
pub fn falls(clip: &Clip) -> String {
    let mut text = header(&[
        "interpolated",
        "keyframe removed",
        "next keyframes",
        "errors of the two gaps before",
        "error of the gap after",
    ]);
    for (errors, curve) in clip.errors.iter().zip(&clip.curves) {
        for (at, removed) in curve.removed.iter().enumerate() {
            if curve.errors[at + 1] >= curve.errors[at] {
                continue;
            }
            let gone = &curve.removed[..at];
            let before = (0..*removed).rev().find(|frame| !gone.contains(frame)).unwrap_or(0);
            let after = (removed + 1..).find(|frame| !gone.contains(frame)).unwrap_or(*removed);
            text += &row(&[
                errors.clip().representation().to_string(),
                removed.to_string(),
                format!("{before} and {after}"),
                format!(
                    "{} + {}",
                    grouped(errors.of_gap(before, *removed)),
                    grouped(errors.of_gap(*removed, after))
                ),
                grouped(errors.of_gap(before, after)),
            ]);
        }
    }
    text
}

/// The same motion with the angles of all joints in one order, and then in another.
pub fn orders(clip: &Clip, count: usize) -> String {
    let mut text = header(&[
        "order of the angles",
        "Euler, greedy",
        "quaternions",
        "Euler, evenly spaced",
        "quaternions",
    ]);
    let others = RotationOrder::ROTATING.into_iter().filter_map(|order| {
        let motion = reordered(&clip.motion, order).ok()?;
        Some((order.to_string(), Clip::new(clip.name, motion)))
    });
    let others: Vec<(String, Clip)> = others.collect();
    let own = ("as in the file".to_owned(), clip);
    for (name, clip) in
        std::iter::once(own).chain(others.iter().map(|(name, clip)| (format!("all `{name}`"), clip)))
    {
        let mut cells = vec![name];
        for method in [Method::Greedy, Method::Even] {
            for errors in &clip.errors {
                cells.push(format!("{:.2}", rms(errors, error_of(method, errors, count))));
            }
        }
        text += &row(&cells);
    }
    text
}

/// The first two lines of a table. All columns but the first hold numbers, mostly.
pub fn header(titles: &[&str]) -> String {
    let rule = "|---".to_owned() + &"|---:".repeat(titles.len().saturating_sub(1)) + "|\n";
    format!("| {} |\n{rule}", titles.join(" | "))
}

pub fn row(cells: &[String]) -> String {
    format!("| {} |\n", cells.join(" | "))
}

/// A whole number with commas between thousands.
pub fn grouped(number: f64) -> String {
    let digits = format!("{number:.0}");
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        let rest = digits.len() - at;
        if at > 0 && rest.is_multiple_of(3) && digit.is_ascii_digit() {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A share in per cent, with its sign.
fn percent(share: f64) -> String {
    let percent = format!("{:+.1} %", 100.0 * share);
    percent.replace("-0.0", "+0.0").replace("+0.0", "0.0").replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_easy_to_read() {
        let groups = [(0.4, "0"), (999.0, "999"), (1000.0, "1,000"), (12_345_678.9, "12,345,679")];
        for (number, text) in groups {
            assert_eq!(grouped(number), text);
        }
        let shares = [(0.051, "+5.1 %"), (-0.0049, "−0.5 %"), (-0.0001, "0.0 %"), (0.0001, "0.0 %")];
        for (share, text) in shares {
            assert_eq!(percent(share), text);
        }
    }
}
