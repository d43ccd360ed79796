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
    // The names of all are searched for in the texts of all: that takes more.
    for (anonymous, most) in [(false, 1_500), (true, 4_000)] {
        let peak = |count| {
            let folder = tempfile::tempdir().unwrap();
            MEMORY.reset_peak_usage();
            write_class(folder.path(), count, &Options { anonymous, ..Options::default() });
            MEMORY.peak_usage()
        };
        let (few, many) = (peak(100), peak(700));
        let each = many.saturating_sub(few) / 600;
        assert!(each < most, "{each} bytes for each record (anonymous: {anonymous})");
    }
}
