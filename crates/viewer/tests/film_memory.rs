//! A long film takes no more memory than a short one.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::convert::Infallible;

use viewer::draw::canvas::{Canvas, Color};
use viewer::output::film::{self, Format, Frames};

/// The most bytes that are in use at once while a film of `count` pictures is written.
fn most_bytes(format: Format, count: usize) -> u64 {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film");
    let frames = Frames { count, size: (160, 120), seconds: 0.04 };
    let draw = |index: usize, canvas: &mut Canvas| -> Result<(), Infallible> {
        canvas.clear(Color((index as u32).wrapping_mul(0x00_9E_37_79) & 0xFF_FF_FF));
        Ok(())
    };
    allocation_counter::measure(|| film::write(&path, format, frames, draw, |_| ()).unwrap()).bytes_max
}

#[test]
fn a_long_film_takes_no_more_memory_than_a_short_one() {
    for format in [Format::Gif, Format::Apng] {
        let (short, long) = (most_bytes(format, 5), most_bytes(format, 500));
        // One picture more would be 77 KB.
        assert!(long < short + 40_000, "{format:?}: {short} bytes for 5 pictures, {long} for 500");
    }
}
