//! What is said of new motions in the terminal.

use std::io;
use std::path::Path;

use parser::printable;
use skeleton::Motion;
use skeleton::acclaim::Skeleton;

use crate::command::print::{number, shortened};
use crate::command::targets::shown;
use crate::motion::source::{Source, USUAL_RATE};
use crate::output::edit::Misfit;
use crate::view::texts::count;

/// So many joints that something is said about are listed.
const MOST_LISTED: usize = 10;

/// How much of a motion of joints there is in `frames` frames.
pub fn joints(motion: &Motion, frames: usize) -> String {
    let joints = motion.skeleton().joints().iter().filter(|joint| !joint.is_end_site).count();
    format!("{}, {}\n", count(frames, "frame", "frames"), count(joints, "joint", "joints"))
}

/// How much of a skeleton of bones there is.
pub fn bones(skeleton: &Skeleton) -> String {
    format!("{}\n", count(skeleton.len() - 1, "bone", "bones"))
}

/// What else there is to know about a motion of bones, with so many seconds from one frame to the next.
pub fn beside(skeleton: &Path, seconds: f64) -> String {
    let (rate, exact) = (rate(1.0 / seconds), exact_rate(seconds));
    let mut said = format!("{rate}; the file does not say it: --rate {rate} when you show it");
    if exact != rate {
        said += &format!(" (--rate {exact} gives the frame time {seconds} back)");
    }
    fact("skeleton", &shown(skeleton)) + &fact("frames per second", &said)
}

/// How fast a motion of joints is that was made of bones, which do not say it.
pub fn chosen_rate(source: &Source) -> String {
    let (rate, title) = (source.rate, source.title());
    let why = match rate == USUAL_RATE {
        true => format!("as in most recordings; {title} does not say it: --rate where it is another"),
        false => "as --rate says".into(),
    };
    fact("frames per second", &format!("{rate}, {why}"))
}

/// Frames per second with five digits: enough to tell 23.976 from 24, and none that come of a rounded frame time.
fn rate(rate: f64) -> String {
    let before_point = rate.log10().floor().clamp(-4.0, 4.0) as i32 + 1;
    shortened(number(rate, (5 - before_point).clamp(0, 7) as usize))
}

/// Frames per second with as few digits as make this frame time again, to the last bit of it where that can be.
fn exact_rate(seconds: f64) -> String {
    /// As many as the slowest motions take.
    const MOST_DIGITS: usize = 24;
    let rate = 1.0 / seconds;
    let gives_back = |text: &String| text.parse().is_ok_and(|rate: f64| 1.0 / rate == seconds);
    let with_digits = |digits: usize| format!("{rate:.digits$}");
    (0..=MOST_DIGITS).map(with_digits).find(gives_back).unwrap_or_else(|| rate.to_string())
}

/// One line below what was written.
pub fn fact(name: &str, fact: &str) -> String {
    format!("  {name:<18} {fact}\n")
}

/// Tells which joints could not be turned as they should be.
pub fn warn(title: &str, motion: &Motion, misfits: &[Misfit]) {
    for Misfit { joint, channels, degrees, frame } in misfits.iter().take(MOST_LISTED) {
        eprintln!(
            "{title}: {} has {}, which cannot hold every rotation: the closest were written, off by up to {} degrees \
             (frame {frame}, counted from 0)",
            printable(&motion.skeleton().label(*joint)),
            count(*channels, "rotation channel", "rotation channels"),
            number(*degrees, 2),
        );
    }
    if let Some(more @ 1..) = misfits.len().checked_sub(MOST_LISTED) {
        eprintln!("{title}: the same of {}", count(more, "more joint", "more joints"));
    }
}

/// Why a file is not there.
pub fn not_written(what: &str, path: &Path, error: &io::Error) -> String {
    format!("the {what} cannot be written to {}: {error}", shown(path))
}

/// Why a motion and its skeleton are not there.
pub fn pair_not_written(skeleton: &Path, motion: &Path, error: &io::Error) -> String {
    format!(
        "the motion and its skeleton cannot be written to {} and {}: {error}",
        shown(motion),
        shown(skeleton)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_has_the_digits_that_it_takes() {
        for (seconds, text) in [
            (0.008333, "120"),
            (0.0083333, "120"),
            (1.0 / 120.0, "120"),
            (0.0417083, "23.976"),
            (0.033367, "29.97"),
            (0.04, "25"),
            (3.0, "0.33333"),
            (700.0, "0.0014285714"),
            (1e-5, "100000"),
        ] {
            assert_eq!(rate(1.0 / seconds), text);
        }
    }

    #[test]
    fn the_exact_rate_gives_the_frame_time_back() {
        for (seconds, text) in [(1.0 / 120.0, "120"), (0.04, "25"), (0.0125, "80"), (3.2, "0.3125")] {
            assert_eq!(exact_rate(seconds), text);
        }
        for seconds in [0.3, 0.0333, 0.033333, 0.008333, 0.0083333, 0.016667, 0.041_708_3, 7e5, 1e-6, 1e6] {
            let text = exact_rate(seconds);
            assert_eq!(1.0 / text.parse::<f64>().unwrap(), seconds, "{text}");
            assert!(text.len() < 26, "{text}");
        }
    }

    #[test]
    fn where_few_digits_do_not_give_the_frame_time_back_more_are_told() {
        let told = |seconds| beside(Path::new("a.asf"), seconds);
        let plain = "  frames per second  25; the file does not say it: --rate 25 when you show it\n";
        assert!(told(0.04).ends_with(plain), "{}", told(0.04));
        let both =
            "--rate 3.3333 when you show it (--rate 3.3333333333333335 gives the frame time 0.3 back)\n";
        assert!(told(0.3).ends_with(both), "{}", told(0.3));
    }
}
