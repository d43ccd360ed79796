//! A motion warped to many frames takes no more memory than one warped to few.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::io;

use parser::{acclaim, bvh};
use viewer::motion::time_map::TimeMap;
use viewer::output::warped::{fitting, write_bones, write_joints};

/// The most bytes that are in use at once, beside the motion itself, while something is written.
fn most_bytes(write: impl FnOnce()) -> u64 {
    allocation_counter::measure(write).bytes_max
}

fn data(name: &str) -> String {
    format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn many_frames_take_no_more_memory_than_few() {
    let walk = acclaim::read_skeleton_file(data("walk.asf")).unwrap().skeleton;
    let walk = acclaim::read_motion_file(data("walk.amc"), &walk).unwrap().motion;
    let run = bvh::read_file(data("running.bvh")).unwrap().motion;
    let joints = |new: usize| {
        let map = TimeMap::Whole { old: run.frame_count(), new };
        most_bytes(|| drop(write_joints(&run, map, io::sink(), &mut |_| ()).unwrap()))
    };
    let bones = |new: usize| {
        let map = TimeMap::Whole { old: walk.frame_count(), new };
        let (walk, freed) = fitting(walk.clone(), map, &mut |_| ());
        assert_eq!(freed, None);
        most_bytes(|| write_bones(&walk, map, io::sink(), &mut |_| ()).unwrap())
    };
    let fitted = |new: usize| {
        let map = TimeMap::Whole { old: walk.frame_count(), new };
        let walk = walk.clone();
        most_bytes(move || drop(fitting(walk, map, &mut |_| ())))
    };
    for most in [&joints as &dyn Fn(usize) -> u64, &bones, &fitted] {
        let (few, many) = (most(1_000), most(20_000));
        // One number a frame would be 76,000 bytes more.
        assert!(many < few + 20_000, "{few} bytes for 1000 frames, {many} for 20000");
    }
}
