//! Reduced motions, error curves and their numbers as files.

mod arguments;

use std::ops::ControlFlow;
use std::path::Path;

use indicatif::ProgressBar;
use parser::bvh;
use reduction::{Curve, Errors, curve};
use skeleton::{Frame, Motion, Representation};

pub use arguments::{KeyframeArguments, MEANINGLESS};

use super::bar::bar;
use super::convert::{self, Format, fact, not_written, warn};
use super::print::number;
use super::say;
use super::targets::shown;
use crate::motion::source::Source;
use crate::motion::stage::Stage;
use crate::output::beside::write_whole;
use crate::output::edit::{self, Choice, Reduced, TooLong};
use crate::view::texts::count;

/// So many keyframes are listed.
const MOST_LISTED: usize = 200;

/// Writes the reduced motion of `source` to `out`, and the curves that the command line asks for. The targets have been looked
/// at.
pub fn write(arguments: &KeyframeArguments, out: Option<&Path>, source: &Source) -> Result<(), String> {
    let loaded = convert::read(source)?;
    let motion = loaded.stage.motion();
    if motion.frame_count() == 0 {
        return Err(format!("{}: there are no frames, and so no keyframes", source.title()));
    }
    let (stage, frames) = (&loaded.stage, loaded.stage.frames());
    let work = Work { arguments, source, title: source.title(), stage, motion, frames };
    if let Some(path) = out {
        work.write_motion(path)?;
    }
    if arguments.plot().or(arguments.csv()).is_some() {
        work.write_curves()?;
    }
    Ok(())
}

/// A motion, and what is to become of it.
struct Work<'a> {
    arguments: &'a KeyframeArguments,
    source: &'a Source,
    title: String,
    stage: &'a Stage,
    motion: &'a Motion,
    frames: Vec<Frame>,
}

impl Work<'_> {
    fn errors(&self, representation: Representation) -> Errors {
        Errors::new(self.motion.skeleton(), &self.frames, representation)
    }

    fn write_motion(&self, path: &Path) -> Result<(), String> {
        let (errors, method) = (self.errors(self.arguments.representation()), self.arguments.method());
        let bar = work_bar("choosing keyframes");
        let choice =
            method.choose(&errors, self.arguments.count(), &mut |done, all| move_bar(&bar, done, all));
        bar.finish_and_clear();
        let choice = choice.map_err(|TooLong| self.too_long())?;
        let Reduced { motion, misfits } = edit::reduced(self.motion, errors.clip(), &choice.keyframes);
        let more = self.write_reduced(path, &motion)?;
        warn(&self.title, &motion, &misfits);
        say(&format!("{}: {}{more}", shown(path), self.summary(&errors, &choice)))
    }

    /// Writes the motion in the format that the file's name says, and gives what else there is to say of it.
    fn write_reduced(&self, path: &Path, motion: &Motion) -> Result<String, String> {
        let Format::Amc { skeleton } = Format::of(path) else {
            write_whole(path, |out| bvh::write(motion, out))
                .map_err(|error| not_written("motion", path, &error))?;
            return Ok(convert::made_joints(self.source, self.stage));
        };
        let (bones, changes) = convert::to_bones(self.source, motion)?;
        convert::write_pair([&skeleton, path], &bones)?;
        let lost = convert::lost_with_bones(self.stage);
        Ok(convert::beside(&skeleton, motion.playable_frame_time()) + &lost + &changes)
    }

    fn too_long(&self) -> String {
        format!(
            "{}: to find the best {} keyframes of {} would take too long; --method moves comes close to them",
            self.title,
            self.arguments.count(),
            count(self.motion.frame_count(), "frame", "frames"),
        )
    }

    fn summary(&self, errors: &Errors, choice: &Choice) -> String {
        let Choice { keyframes, cap } = choice;
        let (frames, asked) = (self.motion.frame_count(), self.arguments.count());
        let why = match keyframes.len() {
            kept if kept == asked => "",
            kept if kept < asked => ": there are no more",
            _ => ": the first and the last one always stay",
        };
        let listed: Vec<String> = keyframes.iter().take(MOST_LISTED).map(usize::to_string).collect();
        let more = keyframes.len() - listed.len();
        let more = if more > 0 { format!(", and {more} more") } else { String::new() };
        let capped = cap.map_or(String::new(), |cap| {
            format!(" of all keyframes at most {cap} frames apart; with longer gaps there may be better ones")
        });
        let error = errors.of_keyframes(keyframes);
        let facts = [
            ("keyframes", format!("{}{more}", listed.join(", "))),
            ("chosen", format!("{}{capped}", self.arguments.method().name())),
            ("interpolated", self.arguments.representation().to_string()),
            (
                "accumulated error",
                format!("{} squared units of the file, over all frames and tips", significant(error)),
            ),
            (
                "RMS distance",
                format!("{} units of the file, per tip and frame", significant(edit::rms(errors, error))),
            ),
        ];
        let counts = [count(frames, "frame", "frames"), count(keyframes.len(), "keyframe", "keyframes")]
            .map(|count| count.to_string());
        facts
            .iter()
            .fold(format!("{}{why}\n", counts.join(", ")), |text, (name, value)| text + &fact(name, value))
    }

    fn write_curves(&self) -> Result<(), String> {
        let [euler, quaternions] = Representation::ALL.map(|representation| self.curve(representation));
        if let Some(path) = self.arguments.plot() {
            let title = format!("Accumulated error of {}", self.title);
            let svg = edit::svg(&title, self.motion.frame_count(), &euler, &quaternions)?;
            write_whole(path, |out| out.write_all(svg.as_bytes()))
                .map_err(|error| not_written("picture", path, &error))?;
            let interpolated = count(euler.removed.len(), "interpolated frame", "interpolated frames");
            say(&format!("{}: both curves, up to {interpolated}\n", shown(path)))?;
        }
        if let Some(path) = self.arguments.csv() {
            write_whole(path, |out| edit::write_csv(&euler, &quaternions, out))
                .map_err(|error| not_written("table", path, &error))?;
            let rows = count(euler.errors.len().max(quaternions.errors.len()), "row", "rows");
            say(&format!("{}: {rows} of numbers\n", shown(path)))?;
        }
        Ok(())
    }

    fn curve(&self, representation: Representation) -> Curve {
        let bar = work_bar(&representation.to_string());
        let curve = curve(&self.errors(representation), self.arguments.count(), &mut |done, all| {
            move_bar(&bar, done, all);
            ControlFlow::Continue(())
        });
        bar.finish_and_clear();
        curve
    }
}

/// A number with at least four digits that say something, and at least one behind the point.
fn significant(value: f64) -> String {
    let digits = if value > 0.0 { 3 - value.log10().floor() as i32 } else { 1 };
    number(value, digits.clamp(1, 5) as usize)
}

/// A bar in the terminal for what is done.
fn work_bar(what: &str) -> ProgressBar {
    bar(0, "{bar:40} {msg}, {percent} %").with_message(what.to_owned())
}

fn move_bar(bar: &ProgressBar, done: usize, all: usize) {
    bar.set_length(all as u64);
    bar.set_position(done as u64);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_say_something_whatever_the_unit_is() {
        let numbers = [
            (0.0, "0.0"),
            (14995.04, "14995.0"),
            (3.8984, "3.898"),
            (0.123_456, "0.1235"),
            (0.001_234_5, "0.0012345"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ];
        for (number, text) in numbers {
            assert_eq!(significant(number), text);
        }
    }
}
