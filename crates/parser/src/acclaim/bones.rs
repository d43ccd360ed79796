//! The section `:bonedata`.

use std::collections::HashMap;

use glam::Vec3;
use skeleton::Channel;
use skeleton::acclaim::{AngleUnit, BoneData, DegreeOfFreedom, LocalAxes, Skeleton, SkeletonError};

use super::root::take_part;
use super::sections::{at_section, skip_line};
use super::words::{angle, axis_order, dofs, looks_like_number, name, three};
use super::{Error, ErrorKind, Warning, WarningKind};
use crate::number::{self, BadNumber};
use crate::snippet::printable_start;
use crate::source::{LONGEST_WORD, Place, Source};
use crate::warning::warn;
use crate::words;

/// The bones in the order of the file, not hung on each other yet.
#[derive(Default)]
pub(super) struct Bones {
    pub data: Vec<BoneData>,
    /// Where each bone's name stands.
    pub places: Vec<Place>,
    by_name: HashMap<String, usize>,
}

impl Bones {
    /// Reads everything behind `:bonedata`.
    pub fn read(source: &mut Source, unit: AngleUnit, warnings: &mut Vec<Warning>) -> Result<Self, Error> {
        let mut bones = Bones::default();
        while !at_section(source) {
            let line = source.place().line;
            words::take(source, "begin", "`begin` of the next bone, or the next section")?;
            let read = |source: &mut Source| Bone::read(source, unit, &bones, warnings, line);
            let (bone, place) = source.as_list(true, read)?;
            bones.by_name.insert(bone.name.to_ascii_lowercase(), bones.data.len());
            bones.data.push(bone);
            bones.places.push(place);
        }
        Ok(bones)
    }

    /// The bone with this name, in upper or lower case.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.by_name.get(&name.to_ascii_lowercase()).copied()
    }
}

/// A limit as it is if it is meant in the file's unit of length, and if it is meant as an angle: in degrees.
#[derive(Clone, Copy)]
struct Limit {
    plain: f32,
    degrees: f32,
}

impl Limit {
    const LOWEST: Limit = Limit { plain: f32::NEG_INFINITY, degrees: f32::NEG_INFINITY };
    const HIGHEST: Limit = Limit { plain: f32::INFINITY, degrees: f32::INFINITY };
}

/// What has been read of one bone.
#[derive(Default)]
struct Bone {
    name: Option<(String, Place)>,
    direction: Option<Vec3>,
    length: Option<f32>,
    axis: Option<LocalAxes>,
    dofs: Option<Vec<DegreeOfFreedom>>,
    limits: Option<(Vec<Limit>, Place)>,
}

impl Bone {
    /// Reads everything behind `begin`, up to and with `end`. Gives where the name stands, too.
    fn read(
        source: &mut Source,
        unit: AngleUnit,
        others: &Bones,
        warnings: &mut Vec<Warning>,
        line: u64,
    ) -> Result<(BoneData, Place), Error> {
        let mut bone = Bone::default();
        while !source.is_word("end") {
            if at_section(source) || source.is_word("begin") {
                let what = match &bone.name {
                    Some((name, _)) => format!("the bone `{}`", printable_start(name.as_bytes())),
                    None => String::from("a bone"),
                };
                return Err(not_closed(source, what, line));
            }
            bone.part(source, unit, others, warnings)?;
        }
        let bone = bone.finish(source, warnings, line)?;
        source.take_word("end");
        Ok(bone)
    }

    fn part(
        &mut self,
        source: &mut Source,
        unit: AngleUnit,
        others: &Bones,
        warnings: &mut Vec<Warning>,
    ) -> Result<(), Error> {
        const LEFT_OUT: [&str; 3] = ["id", "bodymass", "cofmass"];
        if take_part(source, "name", self.name.is_some())? {
            self.name = Some(source.as_list(false, |source| bone_name(source, others, warnings))?);
        } else if take_part(source, "direction", self.direction.is_some())? {
            self.direction = Some(Vec3::from_array(three(source, words::number)?));
        } else if take_part(source, "length", self.length.is_some())? {
            self.length = Some(words::number(source)?);
        } else if take_part(source, "axis", self.axis.is_some())? {
            let angles = three(source, |source| angle(source, unit))?;
            self.axis = Some(LocalAxes { angles, order: axis_order(source)? });
        } else if take_part(source, "dof", self.dofs.is_some())? {
            self.dofs = Some(dofs(source)?.into_iter().map(DegreeOfFreedom::unlimited).collect());
        } else if take_part(source, "limits", self.limits.is_some())? {
            let place = source.place();
            self.limits = Some((limits(source, unit)?, place));
        } else if LEFT_OUT.into_iter().any(|word| source.take_word(word)) {
            source.take_line();
        } else {
            skip_line(source, warnings, "another part of the bone or its `end`")?;
        }
        Ok(())
    }

    /// The bone, unless something is missing.
    fn finish(
        self,
        source: &mut Source,
        warnings: &mut Vec<Warning>,
        line: u64,
    ) -> Result<(BoneData, Place), Error> {
        let missing = |source: &mut Source, part| Error::here(source, ErrorKind::MissingPart { part, line });
        let (name, place) = self.name.ok_or_else(|| missing(source, "name"))?;
        let direction = self.direction.ok_or_else(|| missing(source, "direction"))?;
        let length = self.length.ok_or_else(|| missing(source, "length"))?;
        let bone = printable_start(name.as_bytes());
        let axis = self.axis.unwrap_or_else(|| {
            warn(warnings, place, WarningKind::NoAxis { bone: bone.clone() });
            LocalAxes::WORLD
        });
        if length != 0.0 && (direction.length() - 1.0).abs() > 1e-3 {
            let kind = WarningKind::Direction { bone: bone.clone(), length: direction.length() };
            warn(warnings, place, kind);
        }
        let mut dofs = self.dofs.unwrap_or_default();
        if let Some((limits, place)) = self.limits {
            if limits.len() != 2 * dofs.len() {
                let kind = WarningKind::Limits { bone, found: limits.len(), dofs: dofs.len() };
                warn(warnings, place, kind);
            }
            for (dof, limits) in dofs.iter_mut().zip(limits.chunks_exact(2)) {
                let limit = |Limit { plain, degrees }| match dof.channel {
                    Channel::Rotation(_) => degrees,
                    Channel::Position(_) => plain,
                };
                (dof.low, dof.high) = (limit(limits[0]), limit(limits[1]));
            }
        }
        Ok((BoneData { name, direction, length, axis, dofs }, place))
    }
}

/// The text goes on with something else although `what`, begun in `line`, has no `end`.
pub(super) fn not_closed(source: &mut Source, what: String, line: u64) -> Error {
    let found = match source.peek() {
        [] => String::from("the end of the file"),
        word => format!("`{}`", printable_start(word)),
    };
    Error::here(source, ErrorKind::NotClosed { found, what, line })
}

/// Takes the word behind `name`, which must be the last of its line and none of those of the other bones. Gives where
/// it stands, too.
fn bone_name(
    source: &mut Source,
    others: &Bones,
    warnings: &mut Vec<Warning>,
) -> Result<(String, Place), Error> {
    if source.line_ends() {
        return Err(Error::here(source, ErrorKind::NoName));
    }
    let place = source.place();
    let found = String::from_utf8_lossy(source.peek()).into_owned();
    let shown = printable_start(found.as_bytes());
    if let Some(other) = others.find(&found) {
        let line = others.places[other].line;
        return Err(Error::here(source, ErrorKind::RepeatedName { name: shown, line }));
    }
    if found.len() <= LONGEST_WORD && !Skeleton::accepts_name(&found) {
        return Err(Error::here(source, ErrorKind::Skeleton(SkeletonError::Name(shown))));
    }
    let name = name(source, warnings)?;
    if !source.line_ends() {
        let found = printable_start(source.peek());
        return Err(Error::here(source, ErrorKind::NameOfWords { name: shown, found }));
    }
    Ok((name, place))
}

/// Takes all numbers that come. Infinite ones are numbers here.
fn limits(source: &mut Source, unit: AngleUnit) -> Result<Vec<Limit>, Error> {
    let mut limits = Vec::new();
    loop {
        // Between limits a comma is never a decimal point.
        let word = source.peek_between(b",");
        let (number, length) = (limit(word, unit), word.len());
        match number {
            Some(Ok(number)) => limits.push(number),
            Some(Err(problem)) => {
                let word = word.to_vec();
                return Err(Error::bad_number(source, &word, problem));
            }
            None => return Ok(limits),
        }
        source.take(length);
    }
}

/// The limit that a word is, if it looks like one.
fn limit(word: &[u8], unit: AngleUnit) -> Option<Result<Limit, BadNumber>> {
    // The last is how programs made with Microsoft's compilers write it.
    let is_infinite = |word: &[u8]| {
        ["inf", "infinity", "1.#INF"].into_iter().any(|known| word.eq_ignore_ascii_case(known.as_bytes()))
    };
    match word {
        [b'-', word @ ..] if is_infinite(word) => Some(Ok(Limit::LOWEST)),
        [b'+', word @ ..] | word if is_infinite(word) => Some(Ok(Limit::HIGHEST)),
        word if looks_like_number(word) => {
            let both = number::parse(word).and_then(|plain| {
                // As large as it may become: it is meant as an angle only if the dof is a rotation.
                let degrees = match unit {
                    AngleUnit::Degrees => plain,
                    AngleUnit::Radians => number::parse::<f64>(word)?.to_degrees() as f32,
                };
                Ok(Limit { plain, degrees })
            });
            Some(both)
        }
        _ => None,
    }
}
