//! The options about keyframes.

use std::path::{Path, PathBuf};

use clap::{ArgGroup, Args, ValueEnum};
use skeleton::Representation;

use crate::command::targets::Target;
use crate::output::edit::Method;

/// How many keyframes there are to be when nobody says so.
const USUAL: usize = 20;

/// Options that have to do with the window or a picture, or with the student's functions, and mean nothing here.
const MEANINGLESS: [&str; 13] = [
    "exercise", "output", "frame", "frames", "pictures", "speed", "size", "scale", "camera", "lines",
    "joint", "hide", "show",
];

/// A motion reduced to keyframes, and what that costs.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Keyframes (the reference solution chooses and interpolates)")]
#[command(group = ArgGroup::new("reduction").multiple(true).conflicts_with_all(MEANINGLESS))]
pub struct KeyframeArguments {
    /// Writes the motion reduced to keyframes, with all frames between them interpolated, so that every program plays
    /// it
    #[arg(long, value_name = "MOTION", group = "reduction")]
    out: Option<PathBuf>,

    /// Draws how the accumulated error grows with the number of interpolated frames, for Euler angles and for quaternions
    #[arg(long, value_name = "PICTURE", group = "reduction")]
    plot: Option<PathBuf>,

    /// Writes the numbers behind these curves
    #[arg(long, value_name = "TABLE", group = "reduction")]
    csv: Option<PathBuf>,

    /// How many keyframes stay; the curves end there [default: 20]
    #[arg(long, value_name = "N", requires = "reduction", allow_negative_numbers = true)]
    keyframes: Option<usize>,

    /// What is interpolated in the motion that --out writes; the curves are for both
    #[arg(long, value_enum, default_value_t = Mode::Quaternion, requires = "out")]
    mode: Mode,

    /// How the keyframes for --out are chosen; the curves are always greedy
    #[arg(long, value_enum, default_value_t = Method::Greedy, requires = "out")]
    pub method: Method,

    /// Lets --out take the place of a file that is there already, though never of FILE
    #[arg(long, requires = "out")]
    overwrite: bool,
}

/// [`Representation`] in the words of the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Mode {
    /// Each of a joint's three angles by itself
    Euler,
    /// The rotation that the angles make, about one axis
    #[value(alias = "quaternions")]
    Quaternion,
}

impl KeyframeArguments {
    /// What is to be written; empty when nothing is said about it.
    pub fn targets(&self) -> Vec<Target<'_>> {
        let motion = self.out().map(|path| Target {
            path,
            option: "--out",
            what: "new motion",
            endings: &["bvh"],
            may_replace: self.overwrite,
        });
        let picture = self.plot().map(|path| Target {
            path,
            option: "--plot",
            what: "picture",
            endings: &["svg"],
            may_replace: true,
        });
        let table = self.csv().map(|path| Target {
            path,
            option: "--csv",
            what: "table",
            endings: &["csv"],
            may_replace: true,
        });
        motion.into_iter().chain(picture).chain(table).collect()
    }

    /// Where the reduced motion goes.
    pub fn out(&self) -> Option<&Path> {
        self.out.as_deref()
    }

    /// Where the picture of the curves goes.
    pub fn plot(&self) -> Option<&Path> {
        self.plot.as_deref()
    }

    /// Where the numbers of the curves go.
    pub fn csv(&self) -> Option<&Path> {
        self.csv.as_deref()
    }

    /// How many keyframes stay.
    pub fn count(&self) -> usize {
        self.keyframes.unwrap_or(USUAL)
    }

    /// What is interpolated in a motion.
    pub fn representation(&self) -> Representation {
        match self.mode {
            Mode::Euler => Representation::Euler,
            Mode::Quaternion => Representation::Quaternion,
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use crate::command::arguments::Arguments;

    #[test]
    fn what_has_no_part_in_a_reduction_is_refused_and_not_ignored() {
        let parsed = |more: &[&str]| {
            Arguments::try_parse_from([&["cargo view", "--out", "keys.bvh"], more].concat()).map(drop)
        };
        parsed(&[]).unwrap();
        parsed(&["--solution", "--keyframes", "12", "--mode", "euler"]).unwrap();
        for useless in [["--exercise", "keyframes"], ["--png", "a.png"], ["--frame", "3"]] {
            let told = parsed(&useless).unwrap_err().to_string();
            assert!(told.contains("cannot be used with"), "{told}");
        }
        let told = parsed(&["--keyframes", "-3"]).unwrap_err().to_string();
        assert!(told.contains("invalid value '-3' for '--keyframes"), "{told}");
    }
}
