//! No Acclaim text, however bad, makes the reader panic or take more memory than it is worth.
//!
//! All memory of this process is counted, so the tests take turns.

mod common;

use std::io::Read;
use std::sync::{Mutex, MutexGuard, PoisonError};

use common::acclaim::{AMC, ASF, amc, asf, figure};
use common::damage::any_damage;
use common::repeated::repeated;
use parser::acclaim::{self, Error, MotionReading, SkeletonReading};
use peak_alloc::PeakAlloc;
use proptest::prelude::*;
use skeleton::acclaim::Skeleton;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory that every reading takes: one chunk of text, and what the tests around it take.
const SMALL_CHANGE: usize = 256 * 1024;

/// Memory for each byte of text, at most. The worst are short bones: a bone takes some hundred bytes, its name is
/// there several times, and a list that grows is there twice for a moment.
const PER_BYTE: usize = 24;

fn take_turns() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Gives what came of it, and how much more memory was in use than before.
fn measure<T>(read: impl FnOnce() -> T) -> (T, usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = read();
    (result, MEMORY.peak_usage().saturating_sub(before))
}

fn read_skeleton(source: impl Read) -> (Result<SkeletonReading, Error>, usize) {
    measure(|| acclaim::read_skeleton(source))
}

fn read_motion(source: impl Read, skeleton: &Skeleton) -> (Result<MotionReading, Error>, usize) {
    measure(|| acclaim::read_motion(source, skeleton))
}

#[test]
fn numbers_are_held_once() {
    let _turn = take_turns();
    // The frames need not be numbered one by one.
    let frames = 100_000;
    let text = [("1\nroot 1.5 -12.34567 123.4567 1 2 3\nthigh 1.25 2.5 -3.75\nshin 1e-3\n", frames)];
    let (reading, memory) = read_motion(repeated(&text), &figure());
    let motion = reading.expect("a large motion").motion;
    let size = 4 * motion.values().len();
    assert_eq!(size, 4_000_000);
    assert!(memory <= 3 * size + SMALL_CHANGE, "{memory} bytes for {size} bytes of numbers");
}

#[test]
fn endless_words_lines_and_comments_take_no_memory() {
    let _turn = take_turns();
    let many = 8_000_000;
    let skeletons: [&[(&str, u64)]; 10] = [
        &[("x", many)],
        &[(" ", many)],
        &[("\n", many)],
        &[(":", many)],
        &[("# ", many / 2)],
        &[(":name ", 1), ("x ", many / 2)],
        &[(":documentation\n", 1), ("x y\n", many / 4)],
        &[(":bonedata\nbegin\nname ", 1), ("x", many)],
        &[(":bonedata\nbegin\ndirection ", 1), ("1", many)],
        &[(":bonedata\nbegin\n", 1), ("colour red\n", many / 8)],
    ];
    for text in skeletons {
        let (reading, memory) = read_skeleton(repeated(text));
        assert!(reading.is_err());
        assert!(memory < SMALL_CHANGE, "{memory} bytes for {text:?}");
    }
    let motions: [&[(&str, u64)]; 6] = [
        &[("x", many)],
        &[(":DEGREES\n", many / 8), ("x", 1)],
        &[(":x\n", many / 2), ("x", 1)],
        &[("1\n", 1), ("x", many)],
        &[("1\nshin ", 1), (" ", many)],
        &[("1\nshin ", 1), ("1 ", many / 2)],
    ];
    let figure = figure();
    for text in motions {
        let (reading, memory) = read_motion(repeated(text), &figure);
        assert!(reading.is_err());
        assert!(memory < SMALL_CHANGE, "{memory} bytes for {text:?}");
    }
}

/// Bones with the shortest lines that there can be. `hangs` says on which one the one with this number hangs.
fn many_bones(count: usize, hangs: impl Fn(usize) -> Option<usize>) -> String {
    let name = |bone: Option<usize>| bone.map_or("root".to_owned(), |bone| format!("{bone:x}"));
    let bone = |bone| format!("begin\nname {bone:x}\ndirection 0 0 0\nlength 0\nend\n");
    let line = |bone| format!("{} {bone:x}\n", name(hangs(bone)));
    let bones: String = (0..count).map(bone).collect();
    let lines: String = (0..count).map(line).collect();
    format!(":root\n:bonedata\n{bones}:hierarchy\nbegin\n{lines}end\n")
}

#[test]
fn many_bones_deep_or_wide_take_no_more_memory_than_they_are_worth() {
    let _turn = take_turns();
    // Just more than a list that doubles can hold without growing.
    let count = (1 << 16) + 1;
    let shapes: [fn(usize) -> Option<usize>; 3] = [
        |bone| bone.checked_sub(1),
        |_| None,
        // Every bone hangs on the next one: the last of the file comes first.
        |bone| Some(bone + 1).filter(|&next| next <= 1 << 16),
    ];
    for hangs in shapes {
        let text = many_bones(count, hangs);
        let (reading, memory) = read_skeleton(text.as_bytes());
        let skeleton = reading.expect("many bones").skeleton;
        assert_eq!(skeleton.len(), count + 1);
        assert!(memory < PER_BYTE * text.len(), "{memory} bytes for a text of {}", text.len());

        let mut written = Vec::new();
        acclaim::write_skeleton(&skeleton, &mut written).expect("many bones can be written");
        assert_eq!(acclaim::read_skeleton(&written[..]).expect("what has been written").skeleton, skeleton);
    }
}

#[test]
fn many_bones_that_hang_together_wrongly_are_refused_in_time() {
    let _turn = take_turns();
    let count = 100_000;
    let circle = many_bones(count, |bone| Some(if bone == 0 { 99_999 } else { bone - 1 }));
    let message = acclaim::read_skeleton(circle.as_bytes()).expect_err("a circle").to_string();
    assert!(message.contains("on …)"), "{message}");
    let unknown = many_bones(count, |_| None) + ":x";
    let unknown = unknown.replace("root ffff\n", "root gggg\n");
    let message = acclaim::read_skeleton(unknown.as_bytes()).expect_err("no such bone").to_string();
    assert!(message.contains("found `gggg`, expected a bone"), "{message}");
}

#[test]
fn frames_of_few_bones_take_no_memory_for_the_others() {
    let _turn = take_turns();
    let count = 20_000;
    let text = many_bones(count, |_| None).replace("length 0\n", "length 0\ndof rx ry rz\n");
    let skeleton = acclaim::read_skeleton(text.as_bytes()).expect("many bones").skeleton;
    let frames = 20_000;
    for frame in ["7\n", "7\n0 1 2 3\n"] {
        let (reading, memory) = read_motion(repeated(&[(frame, frames)]), &skeleton);
        let motion = reading.expect("frames with few bones").motion;
        assert_eq!(motion.frame_count() as u64, frames);
        let sizes = text.len() + frame.len() * frames as usize;
        assert!(memory < PER_BYTE * sizes, "{memory} bytes for texts of {sizes}");
    }
}

#[test]
fn many_complaints_take_no_memory() {
    let _turn = take_turns();
    let text = [(ASF, 1), (":other\rx\r", 100_000)];
    let (reading, memory) = read_skeleton(repeated(&text));
    let warnings = reading.expect("many sections").warnings;
    assert_eq!(warnings.len(), 2, "one of each kind: {warnings:?}");
    assert!(memory < SMALL_CHANGE, "{memory} bytes");
}

const JUNK: &[&[u8]] = &[
    b":",
    b"#",
    b"(",
    b" ) ",
    b"\0",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\r",
    b"\n\n",
    b" nan ",
    b" -inf ",
    b" 1e999 ",
    b" -",
    b"9999999999999999999",
    b"\n1\n",
    b"\n99999999999999999999\n",
    b"begin\n",
    b"\nend\n",
    b" root ",
    b"\nshin 1\n",
    b" hip thigh\n",
    b":root\n",
    b":hierarchy\nbegin\n",
    b":bonedata\n",
    b":units\nangle rad\n",
    b":RADIANS\n",
    b":FORCE-ALL-JOINTS-BE-3DOF\n",
    b"<<<<<<< HEAD\n",
    b" dof rx ry rz\n",
    b" limits (",
    b" XYZ\n",
    b"\xf0\x9f",
    b",",
    b"\x1b[31m",
];

/// A skeleton with everything in it that the reader knows.
fn rich() -> String {
    asf("dof rx ry rz", "dof rz TX ry tz rx")
        .replace("angle deg", "angle rad")
        .replace("axis XYZ", "axis zxy")
        .replace("position 0 0 0", "orientation .5 -1e-3 5.")
        .replace("  orientation 0 0 0", "  position 1 2 3 # here")
        .replace("(-10.0 170.0)", "-inf, INF")
        .replace("hip", "Hüfte")
        .replace('\n', "\r\n")
        + ":skin a b\r\nc"
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_damaged_skeleton_is_read_or_refused(
        is_rich in any::<bool>(),
        damages in prop::collection::vec(any_damage(JUNK), 1..6),
    ) {
        let mut text = if is_rich { rich() } else { ASF.to_owned() }.into_bytes();
        damages.iter().for_each(|damage| damage.apply(&mut text));
        let _turn = take_turns();
        let (result, memory) = read_skeleton(&text[..]);
        prop_assert!(memory <= PER_BYTE * text.len() + SMALL_CHANGE, "{} bytes for {}", memory, text.len());
        match result {
            Ok(reading) => {
                // What has been read can be written, and is the same then.
                let mut written = Vec::new();
                acclaim::write_skeleton(&reading.skeleton, &mut written).expect("what has been read");
                let again = acclaim::read_skeleton(&written[..]).expect("what has been written").skeleton;
                prop_assert_eq!(again, reading.skeleton);
            }
            Err(error) => prop_assert!(error.line() >= 1 && error.column() >= 1),
        }
    }

    #[test]
    fn a_damaged_motion_is_read_or_refused(
        is_rich in any::<bool>(),
        damages in prop::collection::vec(any_damage(JUNK), 1..6),
    ) {
        let rich = amc(":DEGREES", ":RADIANS\n:OTHER x").replace('\n', " # 1\r\n").replace("thigh", "Thigh");
        let mut text = if is_rich { rich } else { AMC.to_owned() }.into_bytes();
        damages.iter().for_each(|damage| damage.apply(&mut text));
        let figure = figure();
        let _turn = take_turns();
        let (result, memory) = read_motion(&text[..], &figure);
        prop_assert!(memory <= PER_BYTE * text.len() + SMALL_CHANGE, "{} bytes for {}", memory, text.len());
        match result {
            Ok(reading) => {
                let motion = reading.motion;
                prop_assert!(motion.values().iter().all(|value| value.is_finite()));
                let mut written = Vec::new();
                acclaim::write_motion(&motion, &mut written).expect("what has been read");
                let again = acclaim::read_motion(&written[..], &figure).expect("what has been written").motion;
                prop_assert_eq!(again, motion);
            }
            Err(error) => prop_assert!(error.line() >= 1 && error.column() >= 1),
        }
    }
}
