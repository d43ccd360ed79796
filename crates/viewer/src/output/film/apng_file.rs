//! Animated PNG files.

use std::io::{self, Write};

use super::changed::Part;
use super::pace::fraction;
use super::{Failure, Reel};
use crate::output::picture;

pub(super) fn write(
    file: &mut dyn Write,
    mut reel: Reel,
    progress: &mut dyn FnMut(usize),
) -> Result<(), Failure> {
    let (width, height) = reel.frames.size;
    let count = u32::try_from(reel.frames.count)
        .map_err(|_| io::Error::other(format!("{} pictures are more than fit", reel.frames.count)))?;
    let mut encoder = png::Encoder::new(file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // Two thirds of the fastest level's size, and still twice as fast as a single picture.
    encoder.set_deflate_compression(png::DeflateCompression::Level(2));
    encoder.set_filter(png::Filter::MinEntropy);
    // For ever.
    encoder.set_animated(count, 0)?;
    let (numerator, denominator) = fraction(reel.frames.seconds);
    encoder.set_frame_delay(numerator, denominator)?;
    encoder.set_blend_op(png::BlendOp::Source)?;
    encoder.set_dispose_op(png::DisposeOp::None)?;
    let mut writer = encoder.write_header()?;

    let mut shown: Vec<u32> = Vec::new();
    let mut bytes: Vec<u8> = Vec::new();
    for index in 0..reel.frames.count {
        let pixels = reel.picture(index)?;
        let part = match index {
            0 => Part::whole((width, height)),
            _ => Part::changed(&shown, pixels, width),
        };
        bytes.clear();
        part.rows(pixels, width).for_each(|(_, row)| picture::add_channels(row, &mut bytes));
        shown.clear();
        shown.extend_from_slice(pixels);
        if index > 0 {
            // The upper left corner first, as no part may reach out of the picture even for a moment.
            writer.set_frame_position(0, 0)?;
            writer.set_frame_dimension(part.width as u32, part.height as u32)?;
            writer.set_frame_position(part.left as u32, part.top as u32)?;
        }
        writer.write_image_data(&bytes)?;
        progress(index + 1);
    }
    writer.finish()?;
    Ok(())
}
