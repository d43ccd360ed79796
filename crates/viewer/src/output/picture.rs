//! Pictures as PNG files.

use std::io;
use std::path::Path;

use crate::draw::canvas::{Canvas, Color};
use crate::output::beside::write_whole;

/// Writes `canvas` as a PNG file, in place of any file that is there. What is there is lost only when the whole picture
/// has been written.
///
/// # Errors
///
/// When the file cannot be written.
pub fn save(canvas: &Canvas, path: &Path) -> io::Result<()> {
    let bytes = encode(canvas)?;
    write_whole(path, |file| file.write_all(&bytes))
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
    // For the viewer's soft colours this is no larger than the highest level with the usual filter, and takes a fourth of the
    // time.
    encoder.set_deflate_compression(png::DeflateCompression::Level(4));
    encoder.set_filter(png::Filter::MinEntropy);
    let mut writer = encoder.write_header().map_err(io::Error::other)?;
    let mut data = Vec::new();
    add_channels(canvas.pixels(), &mut data);
    writer.write_image_data(&data).map_err(io::Error::other)?;
    writer.finish().map_err(io::Error::other)?;
    Ok(bytes)
}

/// Adds the red, green and blue of each pixel to `bytes`.
pub(crate) fn add_channels(pixels: &[u32], bytes: &mut Vec<u8>) {
    let start = bytes.len();
    // All the room first: an iterator over channels does not know how long it is, and took longer than compressing them.
    bytes.resize(start + 3 * pixels.len(), 0);
    for (channels, pixel) in bytes[start..].chunks_exact_mut(3).zip(pixels) {
        channels.copy_from_slice(&Color(*pixel).channels());
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_picture_that_cannot_be_put_in_its_place_leaves_everything_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let taken = folder.path().join("taken.png");
        fs::create_dir(&taken).unwrap();
        fs::write(taken.join("precious"), "x").unwrap();
        assert!(save(&Canvas::new(4, 4), &taken).is_err());
        assert!(taken.join("precious").exists());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left lying about");
    }

    #[test]
    fn a_picture_takes_the_place_of_an_older_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        fs::write(&path, "older").unwrap();
        let canvas = Canvas::new(4, 4);
        save(&canvas, &path).unwrap();
        assert_eq!(fs::read(&path).unwrap(), encode(&canvas).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
