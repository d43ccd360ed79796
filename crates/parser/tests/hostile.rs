//! No text, however bad, makes the reader panic or take more memory than it is worth.
//!
//! All memory of this process is counted, so the tests take turns.

mod common;

use std::io::Read;
use std::sync::{Mutex, MutexGuard, PoisonError};

use common::damage::any_damage;
use common::repeated::repeated;
use common::{GOOD, with};
use parser::bvh;
use peak_alloc::PeakAlloc;
use proptest::prelude::*;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory that every reading takes: one chunk of text, room for the first numbers, and what the tests around it
/// take.
const SMALL_CHANGE: usize = 256 * 1024;

/// Memory for each byte of text, at most. The worst are short joints: a joint takes some hundred bytes, and a
/// list that grows is there twice for a moment.
const PER_BYTE: usize = 16;

fn take_turns() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Reads, and gives what came of it and how much more memory was in use than before.
fn measure(source: impl Read) -> (Result<bvh::Reading, bvh::Error>, usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = bvh::read(source);
    (result, MEMORY.peak_usage().saturating_sub(before))
}

const FRAMES: &str = "1 2 3\n4 5 6\n";

fn head(frames: u64) -> String {
    with("Frames: 2", &format!("Frames: {frames}")).replace(FRAMES, "")
}

#[test]
fn numbers_are_held_once() {
    let _turn = take_turns();
    let frames = 200_000;
    let (reading, memory) =
        measure(repeated(&[(&head(frames), 1), ("1.234567 -12.345678 123.456789\n", frames)]));
    let motion = reading.expect("a large motion").motion;
    let size = 4 * motion.values().len();
    assert_eq!(size, 2_400_000);
    // Twice while the list grows for the last time, if the system cannot make it longer where it is.
    assert!(memory <= 2 * size + SMALL_CHANGE, "{memory} bytes for {size} bytes of numbers");
    let held = MEMORY.current_usage();
    drop(motion);
    assert_eq!(
        held - MEMORY.current_usage() - size,
        skeleton_size(),
        "nothing is left over behind the numbers"
    );
}

/// The memory of the skeleton of [`GOOD`].
fn skeleton_size() -> usize {
    let (reading, _) = measure(GOOD.as_bytes());
    let motion = reading.expect("a good file").motion;
    let numbers = 4 * motion.values().len();
    let held = MEMORY.current_usage();
    drop(motion);
    held - MEMORY.current_usage() - numbers
}

#[test]
fn a_count_of_frames_reserves_nothing() {
    let _turn = take_turns();
    for count in ["999999999999", "18446744073709551615", "99999999999999999999999999"] {
        let text = with("Frames: 2", &format!("Frames: {count}"));
        let (reading, memory) = measure(text.as_bytes());
        assert!(reading.is_err());
        assert!(memory < SMALL_CHANGE, "{memory} bytes for {count} frames");
    }
}

#[test]
fn what_is_left_out_takes_no_memory() {
    let _turn = take_turns();
    let many = 2_000_000;
    let surplus = [(GOOD, 1), ("7 8 9\n", many / 2)];
    let one_line = [(&*with("1 2 3\n4 5 6\n", ""), 1), ("1 2 3 ", many / 2)];
    for text in [&surplus, &one_line] {
        let (reading, memory) = measure(repeated(text));
        assert_eq!(reading.expect("two frames").motion.frame_count(), 2);
        assert!(memory < SMALL_CHANGE, "{memory} bytes");
    }
}

#[test]
fn endless_words_and_lines_take_no_memory() {
    let _turn = take_turns();
    let many = 8_000_000;
    let endless: [&[(&str, u64)]; 8] = [
        &[("x", many)],
        &[(" ", many)],
        &[("\n", many)],
        &[("HIERARCHY\nROOT ", 1), ("x ", many / 2)],
        &[("HIERARCHY\nROOT a { OFFSET ", 1), ("1", many)],
        &[("HIERARCHY\nROOT a { CHANNELS 99999999 ", 1), ("Xrotation ", many / 10)],
        &[("HIERARCHY\nROOT a { OFFSET 0 0 0 CHANNELS 0 } MOTION Frames: ", 1), ("9", many)],
        &[(&head(2), 1), ("1", many)],
    ];
    for text in endless {
        let (reading, memory) = measure(repeated(text));
        assert!(reading.is_err());
        assert!(memory < SMALL_CHANGE, "{memory} bytes for {text:?}");
    }
}

/// A chain of joints.
fn chain(depth: u64) -> [(&'static str, u64); 4] {
    [
        ("HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n", 1),
        ("JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n", depth),
        ("}\n", depth + 1),
        ("MOTION\nFrames: 1\nFrame Time: 1\n45\n", 1),
    ]
}

#[test]
fn a_million_joints_deep_is_not_too_deep() {
    let _turn = take_turns();
    let depth = 1_000_000;
    let text = chain(depth);
    let size = text.iter().map(|(part, times)| part.len() * *times as usize).sum::<usize>();
    let (reading, memory) = measure(repeated(&text));
    assert_eq!(reading.expect("a deep skeleton").motion.skeleton().len() as u64, depth + 1);
    assert!(memory < PER_BYTE * size, "{memory} bytes for a text of {size}");

    let (reading, memory) = measure(repeated(&text[..2]));
    let message = reading.expect_err("a skeleton without its end").to_string();
    assert!(message.contains("expected `}`: the joint `a`"), "{message}");
    assert!(memory < PER_BYTE * size, "{memory} bytes for a text of {size}");
}

#[test]
fn the_shortest_joints_take_the_most_memory() {
    let _turn = take_turns();
    let tip = "End Site { OFFSET 0 0 0}";
    // Just more than a list that doubles can hold without growing.
    let many = (1 << 17) + 1;
    let text = [
        ("HIERARCHY\nROOT r {\nOFFSET 0 0 0\nCHANNELS 0\n", 1),
        (tip, many),
        ("}MOTION\nFrames: 0\nFrame Time: 1\n", 1),
    ];
    let (reading, memory) = measure(repeated(&text));
    assert_eq!(reading.expect("a root with many tips").motion.skeleton().len() as u64, many + 1);
    let size = tip.len() * many as usize;
    assert!(memory < PER_BYTE * size, "{memory} bytes for a text of {size}");
}

#[test]
fn a_deep_skeleton_can_be_written() {
    let _turn = take_turns();
    let motion = bvh::read(repeated(&chain(20_000))).expect("a deep skeleton").motion;
    let mut written = Vec::new();
    bvh::write(&motion, &mut written).expect("a deep skeleton can be written");
    assert!(written.len() < 20_000 * 1000, "the indentation has an end");
    assert_eq!(bvh::read(&written[..]).expect("what has been written").motion, motion);
}

#[test]
fn many_complaints_take_no_memory() {
    let _turn = take_turns();
    let (roots, names) = (100_000, "ROOT a\r{\rOFFSET 0 0 0\r}\r");
    let text = [("HIERARCHY\r", 1), (names, roots), ("MOTION\rFrames: 0\rFrame Time: 0\r", 1)];
    let (reading, memory) = measure(repeated(&text));
    let warnings = reading.expect("many roots").warnings;
    assert_eq!(warnings.len(), 5, "one of each kind: {warnings:?}");
    assert!(memory < PER_BYTE * names.len() * roots as usize);
}

const JUNK: &[&[u8]] = &[
    b"{",
    b"}",
    b"\n}\n",
    b" { ",
    b":",
    b"\0",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\r",
    b"\n\n",
    b" nan ",
    b" 1e999 ",
    b" -",
    b"9999999999999999999",
    b"CHANNELS 999999999 ",
    b" Xrotation ",
    b"Frames: 1000000000000\n",
    b"<<<<<<< HEAD\n",
    b"ROOT a\n{\n",
    b"JOINT b\n{\nOFFSET 1 1 1\n",
    b"End Site\n{\n",
    b"MOTION\n",
    b"\xf0\x9f",
    b",",
    b"\x1b[31m",
    b"HIERARCHY\n",
];

/// A text with everything in it that the reader knows.
const RICH: &str = "HIERARCHY\r
ROOT Hips x\r
{\r
  OFFSET 0.5 -1e-3 .5\r
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\r
  JOINT Left:Leg {\r
    CHANNELS 2 Yrotation Xrotation\r
    OFFSET 0 5. 0\r
    End Site20\r
    {\r
      OFFSET 0 0 0\r
    }\r
  }\r
}\r
MOTION\r
Frames:\t3\r
Frame Time: .0083333\r
0 1 2 3 4 5 6 7\r
-0.5 1.25e-006 2.0000 -3.123456 4 5 6 7\r
0 1 2 3 4 5 6 7";

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_damaged_text_is_read_or_refused(rich in any::<bool>(), damages in prop::collection::vec(any_damage(JUNK), 1..6)) {
        let mut text = if rich { RICH } else { GOOD }.as_bytes().to_vec();
        damages.iter().for_each(|damage| damage.apply(&mut text));
        let _turn = take_turns();
        let (result, memory) = measure(&text[..]);
        prop_assert!(memory <= PER_BYTE * text.len() + SMALL_CHANGE, "{} bytes for {}", memory, text.len());
        match result {
            Ok(reading) => {
                let motion = reading.motion;
                prop_assert_eq!(motion.values().len(), motion.frame_count() * motion.skeleton().channel_count());
                prop_assert!(motion.values().iter().all(|value| value.is_finite()));
                // What has been read can be written, and is the same then.
                let mut written = Vec::new();
                bvh::write(&motion, &mut written).expect("what has been read can be written");
                prop_assert_eq!(bvh::read(&written[..]).expect("what has been written").motion, motion);
            }
            Err(error) => prop_assert!(error.line() >= 1 && error.column() >= 1),
        }
    }
}
