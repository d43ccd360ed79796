//! The options about keyframes.

use std::path::{Path, PathBuf};

use clap::{ArgGroup, Args, ValueEnum};
use skeleton::Representation;

use crate::command::targets::Target;
use crate::output::edit::Method;
use crate::view::app::EditSettings;

/// Options that have to do with the window or a picture, or with the student's functions, and mean nothing for new motions and
/// curves. Whatever needs a file names them too: next to one of them, clap no longer asks for what is needed.
pub const MEANINGLESS: [&str; 14] = [
    "exercise", "output", "frame", "frames", "pictures", "speed", "size", "scale", "camera", "lines",
    "joint", "hide", "show", "up",
];

/// A motion reduced to keyframes, and what that costs.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Keyframes (in files, the reference solution chooses and interpolates)")]
#[command(group = ArgGroup::new("reduction").multiple(true).conflicts_with_all(MEANINGLESS))]
pub struct KeyframeArguments {
    /// Draws how the accumulated error grows with the number of interpolated frames, for Euler angles and for quaternions
    #[arg(long, value_name = "PICTURE", group = "reduction")]
    plot: Option<PathBuf>,

    /// Writes the numbers behind these curves
    #[arg(long, value_name = "TABLE", group = "reduction")]
    csv: Option<PathBuf>,

    /// How many keyframes stay: the curves end there, and the window and pictures begin with so many [default: 20]
    #[arg(long, value_name = "N", conflicts_with = "print", allow_negative_numbers = true)]
    keyframes: Option<usize>,

    /// What is interpolated between them, in the motion that --out writes and at first in the window and in pictures; the
    /// curves are for both [default: quaternion]
    #[arg(long, value_enum, conflicts_with = "print")]
    mode: Option<Mode>,

    /// How the keyframes for --out are chosen; the curves are always greedy [default: greedy]
    #[arg(long, value_enum, requires = "out", conflicts_with_all = MEANINGLESS)]
    method: Option<Method>,
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
        let picture = self.plot().map(|path| Target {
            path: path.into(),
            option: "--plot",
            what: "picture",
            endings: &["svg"],
            may_replace: true,
        });
        let table = self.csv().map(|path| Target {
            path: path.into(),
            option: "--csv",
            what: "table",
            endings: &["csv"],
            may_replace: true,
        });
        picture.into_iter().chain(table).collect()
    }

    /// The options that are given; where there are any, what is written is about keyframes.
    pub fn given(&self) -> impl Iterator<Item = &'static str> {
        let given = [
            ("--plot", self.plot.is_some()),
            ("--csv", self.csv.is_some()),
            ("--keyframes", self.keyframes.is_some()),
            ("--mode", self.mode.is_some()),
            ("--method", self.method.is_some()),
        ];
        given.into_iter().filter_map(|(option, is_given)| is_given.then_some(option))
    }

    /// Where the picture of the curves goes.
    pub fn plot(&self) -> Option<&Path> {
        self.plot.as_deref()
    }

    /// Where the numbers of the curves go.
    pub fn csv(&self) -> Option<&Path> {
        self.csv.as_deref()
    }

    /// How keyframes are chosen.
    pub fn method(&self) -> Method {
        self.method.unwrap_or(Method::Greedy)
    }

    /// How many keyframes stay.
    pub fn count(&self) -> usize {
        self.keyframes.unwrap_or(EditSettings::default().keyframes)
    }

    /// What is interpolated in a motion.
    pub fn representation(&self) -> Representation {
        match self.mode {
            Some(Mode::Euler) => Representation::Euler,
            Some(Mode::Quaternion) | None => Representation::Quaternion,
        }
    }

    /// What the window and pictures begin with: automatic keyframes where anything is said about them, or else `usual`.
    pub fn begin(&self, usual: EditSettings) -> EditSettings {
        if self.keyframes.is_none() && self.mode.is_none() {
            return usual;
        }
        let representation = self.representation();
        let stretch = usual.stretch.map(|_| representation);
        EditSettings { automatic: true, keyframes: self.count(), representation, stretch, ..usual }
    }

    /// Sees to it that --mode is not said of curves alone; `is_alone` tells whether there is no new motion.
    ///
    /// # Errors
    ///
    /// When it is.
    pub fn check_mode(&self, is_alone: bool) -> Result<(), &'static str> {
        let only_curves = is_alone && (self.plot.is_some() || self.csv.is_some());
        match self.mode {
            Some(_) if only_curves => Err("--mode means nothing for --plot and --csv: they show both"),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, Parser};

    use super::*;
    use crate::command::Arguments;
    use crate::live::package::Package;

    fn begin(words: &[&str], exercise: Package) -> EditSettings {
        let arguments = Arguments::try_parse_from(["cargo view"].iter().chain(words)).unwrap();
        arguments.keyframes.begin(EditSettings::for_exercise(exercise))
    }

    #[test]
    fn where_keyframes_are_spoken_of_they_are_automatic_and_where_not_all_is_as_usual() {
        for exercise in [Package::Fk, Package::Interpolation, Package::Keyframes] {
            let usual = EditSettings::for_exercise(exercise);
            assert_eq!(begin(&[], exercise), usual);
            for (words, keyframes, representation) in [
                (&["--keyframes", "12"][..], 12, Representation::Quaternion),
                (&["--mode", "euler"], 20, Representation::Euler),
                (&["--keyframes", "12", "--mode", "euler"], 12, Representation::Euler),
            ] {
                let begin = begin(words, exercise);
                assert_eq!((begin.automatic, begin.keyframes), (true, keyframes));
                assert_eq!((begin.interpolated(), begin.errors), (Some(representation), usual.errors));
                // Without automatic keyframes the stretch is there as before, or is not.
                let by_hand = EditSettings { automatic: false, ..begin };
                assert_eq!(by_hand.interpolated(), usual.stretch.map(|_| representation));
            }
        }
    }

    #[test]
    fn the_help_tells_what_is_taken_when_nothing_is_said() {
        let help = Arguments::command().render_long_help().to_string();
        let nothing = Arguments::try_parse_from(["cargo view"]).unwrap().keyframes;
        let count = format!("[default: {}]", nothing.count());
        assert!(help.contains(&count) && help.contains("[default: quaternion]"), "{help}");
        assert_eq!(nothing.representation(), Representation::Quaternion);
    }

    #[test]
    fn what_has_no_part_in_a_reduction_is_refused_and_not_ignored() {
        let parsed = |more: &[&str]| {
            Arguments::try_parse_from([&["cargo view", "--out", "keys.bvh"], more].concat()).map(drop)
        };
        parsed(&[]).unwrap();
        parsed(&["--solution", "--keyframes", "12", "--mode", "euler"]).unwrap();
        for useless in [["--exercise", "keyframes"], ["--png", "a.png"], ["--frame", "3"], ["--up", "z"]] {
            let told = parsed(&useless).unwrap_err().to_string();
            assert!(told.contains("cannot be used with"), "{told}");
        }
        let told = parsed(&["--keyframes", "-3"]).unwrap_err().to_string();
        assert!(told.contains("invalid value '-3' for '--keyframes"), "{told}");
    }
}
