//! GIF files.

use std::borrow::Cow;
use std::io::Write;

use super::changed::Part;
use super::dither::Dither;
use super::pace::hundredths;
use super::palette::{self, Census};
use super::{Failure, Reel};
use crate::output::sheet::spread;

/// How many pictures the palette is made from, at most.
const SAMPLES: usize = 12;

/// The index that leaves a pixel as it was.
const AS_BEFORE: u8 = palette::MOST as u8;

pub(super) fn write(
    file: &mut dyn Write,
    mut reel: Reel,
    progress: &mut dyn FnMut(usize),
) -> Result<(), Failure> {
    let (width, height) = reel.frames.size;
    let mut census = Census::new();
    for index in spread(0, reel.frames.count - 1, SAMPLES) {
        census.count(reel.picture(index)?);
    }
    let colors = palette::choose(census);
    let table: Vec<u8> =
        (0..=palette::MOST).flat_map(|i| colors.get(i).copied().unwrap_or_default()).collect();
    let mut dither = Dither::new(&colors);

    // No side is longer than `canvas::MAX_SIDE`.
    let mut encoder = gif::Encoder::new(file, width as u16, height as u16, &table)?;
    encoder.set_repeat(gif::Repeat::Infinite)?;
    let mut shown: Vec<u32> = Vec::new();
    let mut indices = vec![AS_BEFORE; width * height];
    let mut bytes: Vec<u8> = Vec::new();
    for index in 0..reel.frames.count {
        let pixels = reel.picture(index)?;
        let part = match index {
            0 => Part::whole((width, height)),
            _ => Part::changed(&shown, pixels, width),
        };
        bytes.clear();
        for (y, row) in part.rows(pixels, width) {
            let before = &mut indices[y * width + part.left..][..part.width];
            dither.row(row, (part.left, y), |x, now| {
                bytes.push(if now == before[x] { AS_BEFORE } else { now });
                before[x] = now;
            });
        }
        shown.clear();
        shown.extend_from_slice(pixels);
        encoder.write_frame(&gif::Frame {
            delay: hundredths(index, reel.frames.seconds),
            dispose: gif::DisposalMethod::Keep,
            transparent: (index > 0).then_some(AS_BEFORE),
            left: part.left as u16,
            top: part.top as u16,
            width: part.width as u16,
            height: part.height as u16,
            buffer: Cow::Borrowed(&bytes),
            ..gif::Frame::default()
        })?;
        progress(index + 1);
    }
    encoder.into_inner()?;
    Ok(())
}
