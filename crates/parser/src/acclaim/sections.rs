//! The skeleton's text: its sections.

use skeleton::acclaim::{AngleUnit, Root, Skeleton, Units};

use super::bones::Bones;
use super::{Error, ErrorKind, Warning, WarningKind, Which, hierarchy, root};
use crate::encoding::not_a_text;
use crate::error::is_conflict_mark;
use crate::snippet::printable_start;
use crate::source::{LONGEST_WORD, Source, is_blank};
use crate::warning::warn;
use crate::words;

/// The sections that the format knows, in their usual order.
const SECTIONS: [&str; 8] =
    [":version", ":name", ":units", ":documentation", ":root", ":bonedata", ":hierarchy", ":skin"];

/// Reads the whole text.
pub(super) fn read(source: &mut Source, warnings: &mut Vec<Warning>) -> Result<Skeleton, Error> {
    check_beginning(source, Which::Skeleton)?;
    let mut parts = Parts::default();
    // The sections so far, and their lines.
    let mut seen: Vec<(&str, u64)> = Vec::new();
    while !source.peek().is_empty() {
        let Some(section) = SECTIONS.into_iter().find(|section| source.is_word(section)) else {
            skip_unknown(source, warnings)?;
            continue;
        };
        if let Some(&(_, line)) = seen.iter().find(|(other, _)| *other == section) {
            return Err(Error::here(source, ErrorKind::RepeatedSection { section, line }));
        }
        parts.check_order(source, section)?;
        seen.push((section, source.place().line));
        source.take(section.len());
        parts.read(source, section, warnings)?;
    }
    match parts {
        Parts { skeleton: Some(mut skeleton), name, units, .. } => {
            // Both may stand behind the hierarchy.
            (skeleton.name, skeleton.units) = (name, units);
            Ok(skeleton)
        }
        Parts { root: None, .. } => Err(Error::unexpected(source, "`:root`")),
        Parts { bones: None, .. } => Err(Error::unexpected(source, "`:bonedata`")),
        _ => Err(Error::unexpected(source, "`:hierarchy`")),
    }
}

/// What the sections so far have said.
#[derive(Default)]
struct Parts {
    name: String,
    units: Units,
    root: Option<Root>,
    bones: Option<Bones>,
    skeleton: Option<Skeleton>,
}

impl Parts {
    /// The hierarchy needs the root and the bones.
    fn check_order(&self, source: &mut Source, section: &'static str) -> Result<(), Error> {
        let before = match section {
            ":hierarchy" if self.root.is_none() => ":root",
            ":hierarchy" if self.bones.is_none() => ":bonedata",
            _ => return Ok(()),
        };
        Err(Error::here(source, ErrorKind::SectionOrder { section, before }))
    }

    fn read(&mut self, source: &mut Source, section: &str, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        match section {
            ":name" => self.name = rest_of_line(source)?,
            ":units" => self.units(source, warnings)?,
            ":root" => self.root = Some(root::read(source, self.units.angle, warnings)?),
            ":bonedata" => self.bones = Some(Bones::read(source, self.units.angle, warnings)?),
            ":hierarchy" => {
                let (root, bones) =
                    (self.root.clone().unwrap_or_default(), self.bones.take().unwrap_or_default());
                self.skeleton = Some(hierarchy::read(source, root, bones, warnings)?);
            }
            _ => skip_section(source),
        }
        Ok(())
    }

    fn units(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        loop {
            if source.take_word("mass") {
                self.units.mass = words::number(source)?;
            } else if source.take_word("length") {
                self.units.length = words::number(source)?;
            } else if source.take_word("angle") {
                self.angle_unit(source)?;
            } else if at_section(source) {
                return Ok(());
            } else {
                skip_line(source, warnings, "mass, length, angle or the next section")?;
            }
        }
    }

    fn angle_unit(&mut self, source: &mut Source) -> Result<(), Error> {
        self.units.angle = match source.peek() {
            word if word.eq_ignore_ascii_case(b"deg") => AngleUnit::Degrees,
            word if word.eq_ignore_ascii_case(b"rad") => AngleUnit::Radians,
            [] => return Err(Error::unexpected(source, "deg or rad")),
            word => {
                let found = printable_start(word);
                return Err(Error::here(source, ErrorKind::AngleUnit { found }));
            }
        };
        let angles_are_known = self.root.is_some() || self.bones.is_some();
        if self.units.angle == AngleUnit::Radians && angles_are_known {
            return Err(Error::here(source, ErrorKind::LateRadians));
        }
        source.take(3);
        Ok(())
    }
}

/// Whether the next word begins a section, or the text ends.
pub(super) fn at_section(source: &mut Source) -> bool {
    matches!(source.peek(), [] | [b':', ..])
}

/// Leaves out a line that begins with a word which nobody knows. Something that looks like a number is too much
/// behind what stands in front of it.
pub(super) fn skip_line(
    source: &mut Source,
    warnings: &mut Vec<Warning>,
    expected: &'static str,
) -> Result<(), Error> {
    let word = source.peek();
    if is_conflict_mark(word) || super::words::looks_like_number(word) {
        return Err(Error::unexpected(source, expected));
    }
    let found = printable_start(word);
    warn(warnings, source.place(), WarningKind::UnknownLine { found });
    source.take_line();
    Ok(())
}

/// Leaves out all up to the next section.
fn skip_section(source: &mut Source) {
    source.take_line();
    while !at_section(source) {
        source.take_line();
    }
}

/// Leaves out a section that nobody knows.
fn skip_unknown(source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
    let [b':', ..] = source.peek() else {
        return Err(Error::unexpected(source, "the next section, such as `:hierarchy`"));
    };
    let found = printable_start(source.peek());
    warn(warnings, source.place(), WarningKind::UnknownSection { found });
    skip_section(source);
    Ok(())
}

/// Takes the rest of the line, without blanks around it and without a comment.
fn rest_of_line(source: &mut Source) -> Result<String, Error> {
    let line = source.peek_line();
    if line.len() > LONGEST_WORD {
        return Err(Error::here(source, ErrorKind::LongName { longest: LONGEST_WORD }));
    }
    let is_comment = |at: &usize| line[*at] == b'#' && (*at == 0 || is_blank(line[*at - 1]));
    let end = (0..line.len()).find(is_comment).unwrap_or(line.len());
    let text = String::from_utf8_lossy(&line[..end]).trim_end().to_owned();
    source.take_line();
    Ok(text)
}

/// The first word must be a keyword of this kind of file. What else may the file be?
pub(super) fn check_beginning(source: &mut Source, which: Which) -> Result<(), Error> {
    let is_keyword = |source: &mut Source, words: &[&str]| words.iter().any(|word| source.is_word(word));
    let is_skeleton = is_keyword(source, &SECTIONS);
    let is_motion = is_keyword(source, &super::frames::FLAGS);
    let word = source.peek();
    let no_text = not_a_text(word);
    let guess = match word {
        [] => return Err(Error::here(source, ErrorKind::Empty { which })),
        word if is_conflict_mark(word) => return Err(Error::unexpected(source, "a keyword")),
        word if no_text.is_some() => {
            let (found, guess) = (printable_start(word), no_text.unwrap_or_default());
            let (place, kind) = (source.place(), ErrorKind::NotAcclaim { which, found, guess });
            return Err(Error::before(place, None, source, kind));
        }
        _ if is_skeleton && which == Which::Motion => " (the skeleton, .asf?)",
        _ if is_motion && which == Which::Skeleton => " (a motion, .amc?)",
        [b':', ..] => return Ok(()),
        // The keywords of a motion may be missing.
        [b'0'..=b'9', ..] if which == Which::Motion => return Ok(()),
        word if word.eq_ignore_ascii_case(b"HIERARCHY") => " (BVH?)",
        [b'{' | b'[', ..] => " (JSON?)",
        [b'<', ..] => " (XML?)",
        _ => "",
    };
    let found = printable_start(source.peek());
    Err(Error::here(source, ErrorKind::NotAcclaim { which, found, guess }))
}
