//! A long film takes no more memory than a short one. Alone in its program, as it counts all that is allocated.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::convert::Infallible;

use peak_alloc::PeakAlloc;
use viewer::canvas::{Canvas, Color};
use viewer::film::{self, Format, Frames};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The most bytes that are in use while a film of `count` pictures is written.
fn peak(format: Format, count: usize) -> usize {
    let folder = tempfile::tempdir().unwrap();
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let frames = Frames { count, size: (160, 120), seconds: 0.04 };
    let draw = |index: usize, canvas: &mut Canvas| -> Result<(), Infallible> {
        canvas.clear(Color((index as u32).wrapping_mul(0x00_9E_37_79) & 0xFF_FF_FF));
        Ok(())
    };
    film::write(&folder.path().join("film"), format, frames, draw, |_| ()).unwrap();
    MEMORY.peak_usage() - before
}

#[test]
fn a_long_film_takes_no_more_memory_than_a_short_one() {
    for format in [Format::Gif, Format::Apng] {
        let (short, long) = (peak(format, 5), peak(format, 500));
        // One picture more would be 77 KB.
        assert!(long < short + 40_000, "{format:?}: {short} bytes for 5 pictures, {long} for 500");
    }
}
