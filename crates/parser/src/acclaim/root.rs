//! The section `:root`.

use glam::Vec3;
use skeleton::acclaim::{AngleUnit, LocalAxes, Root};

use super::sections::{at_section, skip_line};
use super::words::{angle, axis_order, dofs, three};
use super::{Error, ErrorKind, Warning, WarningKind};
use crate::source::Source;
use crate::warning::warn;
use crate::words;

/// Reads everything behind `:root`.
pub(super) fn read(source: &mut Source, unit: AngleUnit, warnings: &mut Vec<Warning>) -> Result<Root, Error> {
    source.as_list(true, |source| read_parts(source, unit, warnings))
}

fn read_parts(source: &mut Source, unit: AngleUnit, warnings: &mut Vec<Warning>) -> Result<Root, Error> {
    let place = source.place();
    let (mut order, mut axis, mut position, mut orientation) = (None, None, None, None);
    while !at_section(source) {
        if take_part(source, "order", order.is_some())? {
            order = Some(dofs(source)?);
        } else if take_part(source, "axis", axis.is_some())? {
            axis = Some(axis_order(source)?);
        } else if take_part(source, "position", position.is_some())? {
            position = Some(three(source, words::number)?);
        } else if take_part(source, "orientation", orientation.is_some())? {
            orientation = Some(three(source, |source| angle(source, unit))?);
        } else {
            skip_line(source, warnings, "order, axis, position, orientation or the next section")?;
        }
    }
    if order.is_none() {
        warn(warnings, place, WarningKind::NoOrder);
    }
    let usual = Root::default();
    Ok(Root {
        order: order.unwrap_or(usual.order),
        orientation: LocalAxes {
            angles: orientation.unwrap_or_default(),
            order: axis.unwrap_or(usual.orientation.order),
        },
        position: Vec3::from_array(position.unwrap_or_default()),
    })
}

/// Takes the keyword of a part of the root or of a bone, if it comes next. It must be the first time.
pub(super) fn take_part(source: &mut Source, part: &'static str, is_known: bool) -> Result<bool, Error> {
    if is_known && source.is_word(part) {
        return Err(Error::here(source, ErrorKind::RepeatedPart { part }));
    }
    Ok(source.take_word(part))
}
