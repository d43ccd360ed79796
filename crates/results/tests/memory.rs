//! A large class takes little more memory than a small one.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use common::write_class;
use peak_alloc::PeakAlloc;
use results::Options;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

#[test]
fn of_each_record_only_a_small_row_is_kept() {
    for anonymous in [false, true] {
        let peak = |count| {
            let folder = tempfile::tempdir().unwrap();
            MEMORY.reset_peak_usage();
            write_class(folder.path(), count, &Options { anonymous, ..Options::default() });
            MEMORY.peak_usage()
        };
        let (few, many) = (peak(100), peak(700));
        let each = many.saturating_sub(few) / 600;
        // A record alone takes ten times as much.
        assert!(each < 2_500, "{each} bytes for each record (anonymous: {anonymous})");
    }
}
