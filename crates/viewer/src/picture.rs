//! Pictures as PNG files.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::canvas::{Canvas, Color};

/// Writes `canvas` as a PNG file, in place of any file that is there.
///
/// # Errors
///
/// When the file cannot be written.
pub fn save(canvas: &Canvas, path: &Path) -> io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    file.write_all(&encode(canvas)?)?;
    file.flush()
}

/// `canvas` as the bytes of a PNG file, 8 bits per channel, without transparency.
///
/// # Errors
///
/// Only if there is not enough memory to encode it.
pub fn encode(canvas: &Canvas) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, canvas.size().0 as u32, canvas.size().1 as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().map_err(io::Error::other)?;
    let data: Vec<u8> = canvas.pixels().iter().flat_map(|pixel| Color(*pixel).channels()).collect();
    writer.write_image_data(&data).map_err(io::Error::other)?;
    writer.finish().map_err(io::Error::other)?;
    Ok(bytes)
}
