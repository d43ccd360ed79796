//! Words that both files have: angles, names, lists.

use skeleton::acclaim::{AngleUnit, DegreeOfFreedom};
use skeleton::{Axis, Channel, RotationOrder};

use super::{Error, ErrorKind, Warning, WarningKind};
use crate::number::{self, BadNumber};
use crate::snippet::printable_start;
use crate::source::{LONGEST_WORD, Source};
use crate::warning::warn;

/// Takes an angle, which becomes degrees.
pub(super) fn angle(source: &mut Source, unit: AngleUnit) -> Result<f32, Error> {
    let word = source.peek();
    let length = word.len();
    match parse_angle(word, unit) {
        Ok(degrees) => {
            source.take(length);
            Ok(degrees)
        }
        Err(problem) => {
            let word = word.to_vec();
            Err(Error::bad_number(source, &word, problem))
        }
    }
}

fn parse_angle(word: &[u8], unit: AngleUnit) -> Result<f32, BadNumber> {
    match unit {
        AngleUnit::Degrees => number::parse(word),
        AngleUnit::Radians => {
            let degrees = number::parse::<f64>(word)?.to_degrees() as f32;
            if degrees.is_finite() { Ok(degrees) } else { Err(BadNumber::NotFinite) }
        }
    }
}

/// Takes three numbers by `number`.
pub(super) fn three(
    source: &mut Source,
    mut number: impl FnMut(&mut Source) -> Result<f32, Error>,
) -> Result<[f32; 3], Error> {
    Ok([number(source)?, number(source)?, number(source)?])
}

/// Takes the next word as a name.
pub(super) fn name(source: &mut Source, warnings: &mut Vec<Warning>) -> Result<String, Error> {
    let word = source.peek();
    let length = word.len();
    if length > LONGEST_WORD {
        return Err(Error::here(source, ErrorKind::LongName { longest: LONGEST_WORD }));
    }
    let name = String::from_utf8_lossy(word);
    let is_utf8 = matches!(name, std::borrow::Cow::Borrowed(_));
    let name = name.into_owned();
    if !is_utf8 {
        let kind = WarningKind::NameEncoding { name: printable_start(name.as_bytes()) };
        warn(warnings, source.place(), kind);
    }
    source.take(length);
    Ok(name)
}

/// Takes the dofs that stand in the rest of the line, and in the next lines if the list goes on there.
pub(super) fn dofs(source: &mut Source) -> Result<Vec<Channel>, Error> {
    let channel_of = |word: &[u8]| std::str::from_utf8(word).ok().and_then(DegreeOfFreedom::channel_of);
    let mut dofs = Vec::new();
    while !source.line_ends() || channel_of(source.peek()).is_some() {
        let word = source.peek();
        let length = word.len();
        let Some(channel) = channel_of(word) else {
            let kind = match word {
                b"l" | b"L" => ErrorKind::LengthDof,
                word => ErrorKind::UnknownDof { found: printable_start(word) },
            };
            return Err(Error::here(source, kind));
        };
        if dofs.contains(&channel) {
            let kind = ErrorKind::RepeatedDof { dof: DegreeOfFreedom::word(channel) };
            return Err(Error::here(source, kind));
        }
        dofs.push(channel);
        source.take(length);
    }
    Ok(dofs)
}

/// Takes a word such as `XYZ`: rotations about fixed axes, the first letter's first. In the order of their product the
/// first letter's is the last.
pub(super) fn axis_order(source: &mut Source) -> Result<RotationOrder, Error> {
    let word = source.peek();
    let length = word.len();
    let axes: Option<Vec<Axis>> = word.iter().rev().map(|&letter| axis(letter)).collect();
    let order = axes.filter(|axes| axes.len() == 3).map(|axes| {
        let channels: Vec<Channel> = axes.iter().copied().map(Channel::Rotation).collect();
        (RotationOrder::of_channels(&channels), axes)
    });
    match order {
        // An axis that comes twice leaves another one out, which is then put in, and the order is another one.
        Some((order, axes)) if order.axes().is_some_and(|all| all[..] == axes[..]) => {
            source.take(length);
            Ok(order)
        }
        _ if length == 0 => Err(Error::unexpected(source, "the order of three rotations, such as XYZ")),
        _ => {
            let found = printable_start(source.peek());
            Err(Error::here(source, ErrorKind::AxisOrder { found }))
        }
    }
}

fn axis(letter: u8) -> Option<Axis> {
    match letter.to_ascii_uppercase() {
        b'X' => Some(Axis::X),
        b'Y' => Some(Axis::Y),
        b'Z' => Some(Axis::Z),
        _ => None,
    }
}

/// Whether a word begins as numbers do.
pub(super) fn looks_like_number(word: &[u8]) -> bool {
    matches!(word, [b'0'..=b'9' | b'+' | b'-' | b'.', ..])
}
