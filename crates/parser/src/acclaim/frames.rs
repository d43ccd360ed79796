//! The motion's text: its flags and frames.

use skeleton::Channel;
use skeleton::acclaim::{AngleUnit, BoneId, Columns, DegreeOfFreedom, Motion, Skeleton};

use super::near::near;
use super::sections::check_beginning;
use super::words::{angle, looks_like_number};
use super::{Error, ErrorKind, Warning, WarningKind, Which};
use crate::error::is_conflict_mark;
use crate::shown::counted;
use crate::snippet::printable_start;
use crate::source::{Place, Source, is_blank};
use crate::warning::warn;
use crate::words;

/// The keywords that a motion can begin with.
pub(super) const FLAGS: [&str; 4] = [":FULLY-SPECIFIED", ":DEGREES", ":RADIANS", ":FORCE-ALL-JOINTS-BE-3DOF"];

/// Reads the whole text.
pub(super) fn read(
    source: &mut Source,
    skeleton: &Skeleton,
    warnings: &mut Vec<Warning>,
) -> Result<Motion, Error> {
    check_beginning(source, Which::Motion)?;
    let mut unit = skeleton.units.angle;
    let mut columns = Columns::new(skeleton.clone());
    while let [b':', ..] = source.peek() {
        match FLAGS.into_iter().find(|flag| source.take_word(flag)) {
            Some(":DEGREES") => unit = AngleUnit::Degrees,
            Some(":RADIANS") => unit = AngleUnit::Radians,
            Some(":FORCE-ALL-JOINTS-BE-3DOF") => columns = columns.with_three_angles(),
            Some(_) => {}
            None => {
                let found = printable_start(source.peek());
                warn(warnings, source.place(), WarningKind::UnknownSection { found });
                source.take_line();
            }
        }
    }
    let mut frames = Frames::new(columns, unit, source.place());
    frames.read(source, warnings)?;
    frames.finish(source, warnings)
}

struct Frames {
    columns: Columns,
    unit: AngleUnit,
    /// Frames that are complete, and their numbers.
    complete: usize,
    values: Vec<f32>,
    /// The number of the frame that is being read, once there is one, and its values so far.
    number: Option<u64>,
    row: Vec<f32>,
    /// Where the first frame begins.
    first: Place,
    /// For each bone how many frames had begun when it was met last.
    met: Vec<usize>,
    /// How many bones that have columns this frame has had, and how many every frame must have.
    bones: usize,
    moving: usize,
    /// The bones of the first frame, in the order of the file: in the next ones they mostly come like this again.
    order: Vec<BoneId>,
    /// How many lines of bones this frame has had.
    lines: usize,
}

impl Frames {
    fn new(columns: Columns, unit: AngleUnit, first: Place) -> Self {
        let (row, met) = (vec![0.0; columns.len()], vec![0; columns.skeleton().len()]);
        let (complete, values, number, order) = (0, Vec::new(), None, Vec::new());
        let (bones, moving, lines) = (0, 0, 0);
        Frames { columns, unit, complete, values, number, row, first, met, bones, moving, order, lines }
    }

    fn read(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        while !source.peek().is_empty() {
            if is_frame_number(source.peek_line()) {
                self.frame_number(source, warnings)?;
                continue;
            }
            match self.known_bone(source) {
                Some(bone) if self.number.is_some() => self.bone(source, bone)?,
                _ => return Err(self.neither_bone_nor_number(source)),
            }
        }
        Ok(())
    }

    /// The bone that the next word names.
    fn known_bone(&self, source: &mut Source) -> Option<BoneId> {
        let word = source.peek();
        let skeleton = self.columns.skeleton();
        let usual = self.order.get(self.lines).and_then(|bone| skeleton.get(*bone));
        match usual.filter(|bone| bone.name.as_bytes() == word) {
            Some(bone) => Some(bone.id),
            None => skeleton.find(&String::from_utf8_lossy(word)).map(|bone| bone.id),
        }
    }

    fn neither_bone_nor_number(&self, source: &mut Source) -> Error {
        const EXPECTED: &str = "a bone, or the number of the next frame on a line of its own";
        let word = source.peek();
        if is_conflict_mark(word) {
            return Error::unexpected(source, EXPECTED);
        }
        let found = printable_start(word);
        if self.number.is_none() {
            return Error::here(source, ErrorKind::NoFrameNumber { found });
        }
        if looks_like_number(word) || word.starts_with(b":") {
            return Error::unexpected(source, EXPECTED);
        }
        let names = self.columns.skeleton().bones().iter().map(|bone| bone.name.as_str());
        let near = near(&String::from_utf8_lossy(word), names);
        Error::here(source, ErrorKind::UnknownBone { found, near })
    }

    /// Takes the number of the next frame, which completes the one before.
    fn frame_number(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        self.complete_frame(source, warnings)?;
        let (found, place) = words::count(source, "the number of a frame")?;
        match self.number.map(|number| number.saturating_add(1)) {
            None => self.first = place,
            Some(expected) if expected != found => {
                warn(warnings, place, WarningKind::FrameNumber { found, expected });
            }
            Some(_) => {}
        }
        (self.number, self.bones, self.lines) = (Some(found), 0, 0);
        Ok(())
    }

    /// Reads the line of a bone.
    fn bone(&mut self, source: &mut Source, bone: BoneId) -> Result<(), Error> {
        self.check_turn(source, bone)?;
        let length = source.peek().len();
        source.take(length);
        source.as_list(true, |source| self.numbers(source, bone))?;
        if self.complete == 0 {
            self.order.push(bone);
        }
        self.bones += usize::from(!self.columns.range(bone).is_empty());
        self.lines += 1;
        Ok(())
    }

    /// Reads what stands behind the name of a bone.
    fn numbers(&mut self, source: &mut Source, bone: BoneId) -> Result<(), Error> {
        let range = self.columns.range(bone);
        for (found, column) in range.enumerate() {
            if source.line_ends() {
                let (bone, dofs) = (self.label(bone), self.dofs(bone));
                return Err(Error::here(source, ErrorKind::TooFewNumbers { bone, found, dofs }));
            }
            self.row[column] = match self.columns.channels(bone)[found] {
                Channel::Rotation(_) => angle(source, self.unit)?,
                Channel::Position(_) => words::number(source)?,
            };
        }
        if !source.line_ends() {
            let (bone, dofs, found) = (self.label(bone), self.dofs(bone), printable_start(source.peek()));
            return Err(Error::here(source, ErrorKind::TooManyNumbers { bone, found, dofs }));
        }
        Ok(())
    }

    /// A bone comes once in a frame, and in all frames or in none.
    fn check_turn(&mut self, source: &mut Source, bone: BoneId) -> Result<(), Error> {
        let frame = self.number.unwrap_or_default();
        let begun = self.complete + 1;
        if std::mem::replace(&mut self.met[bone.0], begun) == begun {
            let bone = self.label(bone);
            return Err(Error::here(source, ErrorKind::RepeatedBone { bone, frame }));
        }
        let has_dofs = self.columns.skeleton().get(bone).is_some_and(|bone| !bone.dofs.is_empty());
        if has_dofs && self.columns.range(bone).is_empty() {
            let bone = self.label(bone);
            return Err(Error::here(source, ErrorKind::NewBone { bone, frame }));
        }
        Ok(())
    }

    /// The frame that is being read, if there is one, is over.
    fn complete_frame(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        let Some(frame) = self.number else { return Ok(()) };
        if self.complete == 0 {
            self.fix_columns(warnings);
        } else if self.bones < self.moving
            && let Some(bone) = self.missing().next()
        {
            let kind = ErrorKind::MissingBone { bone: self.label(bone), frame };
            return Err(Error::here(source, kind));
        }
        self.values.extend(&self.row);
        self.complete += 1;
        Ok(())
    }

    /// The bones that have columns but no line in this frame.
    fn missing(&self) -> impl Iterator<Item = BoneId> {
        let is_missing =
            |bone: &BoneId| self.met[bone.0] <= self.complete && !self.columns.range(*bone).is_empty();
        (0..self.met.len()).map(BoneId).filter(is_missing)
    }

    /// The bones of the first frame are those of all frames.
    fn fix_columns(&mut self, warnings: &mut Vec<Warning>) {
        self.moving = self.bones;
        let still: Vec<BoneId> = self.missing().collect();
        let Some(&first) = still.first() else { return };
        let kind = WarningKind::StillBones { bone: self.label(first), count: still.len() };
        warn(warnings, self.first, kind);
        let columns = self.columns.clone().without(&still);
        let kept = (0..self.met.len()).map(BoneId).filter(|bone| !columns.range(*bone).is_empty());
        self.row = kept.flat_map(|bone| self.row[self.columns.range(bone)].iter().copied()).collect();
        self.columns = columns;
    }

    /// All frames as a motion.
    fn finish(mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<Motion, Error> {
        self.complete_frame(source, warnings)?;
        if self.number.is_none() {
            warn(warnings, source.place(), WarningKind::NoFrames);
        }
        Motion::new(self.columns, self.complete, self.values)
            .map_err(|error| Error::here(source, ErrorKind::Motion(error)))
    }

    fn label(&self, bone: BoneId) -> String {
        let name = self.columns.skeleton().get(bone).map_or("", |bone| &bone.name);
        printable_start(name.as_bytes())
    }

    /// How many numbers a bone has, and for which dofs.
    fn dofs(&self, bone: BoneId) -> String {
        match self.columns.channels(bone) {
            [] => String::from("none: it has no dofs in the skeleton"),
            channels => {
                let words: Vec<&str> =
                    channels.iter().map(|channel| DegreeOfFreedom::word(*channel)).collect();
                format!("{} ({})", counted(words.len() as u64, "number"), words.join(" "))
            }
        }
    }
}

/// Whether a line holds a whole number and nothing else.
fn is_frame_number(line: &[u8]) -> bool {
    let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut behind = line[digits..].iter();
    digits > 0
        && match behind.next() {
            None => true,
            Some(&byte) => {
                is_blank(byte) && matches!(behind.find(|byte| !is_blank(**byte)), None | Some(b'#'))
            }
        }
}
