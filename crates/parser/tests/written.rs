//! What is written is what is read.

mod common;

use common::GOOD;
use glam::Vec3;
use parser::bvh::{self, WriteError};
use proptest::prelude::*;
use skeleton::{Axis, Channel, JointId, Motion, Skeleton};

fn write(motion: &Motion) -> String {
    let mut out = Vec::new();
    bvh::write(motion, &mut out).expect("a motion that can be written");
    String::from_utf8(out).expect("a text")
}

/// Why a motion cannot be written. Nothing may have been written, then.
fn refusal(motion: &Motion) -> WriteError {
    let mut out = Vec::new();
    let error = bvh::write(motion, &mut out).expect_err("a motion that cannot be written");
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert!(out.is_empty());
    let inner = error.into_inner().expect("a reason");
    *inner.downcast::<WriteError>().expect("a reason of ours")
}

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|value| value.to_bits()).collect()
}

/// A skeleton of one joint that is called `name` and turns about Y.
fn one_joint(name: &str) -> Skeleton {
    let mut skeleton = Skeleton::new();
    skeleton.add_joint(None, name, Vec3::ZERO, [Channel::Rotation(Axis::Y)]).expect("a joint");
    skeleton
}

fn motion(skeleton: Skeleton, values: &[f32]) -> Motion {
    let frames = values.len() / skeleton.channel_count();
    Motion::new(skeleton, frames, 0.5, values.to_vec()).expect("a motion")
}

#[test]
fn a_file_in_the_usual_form_is_written_as_it_was() {
    assert_eq!(write(&bvh::read(GOOD.as_bytes()).expect("a good file").motion), GOOD);
}

#[test]
fn branches_are_closed_where_they_end() {
    let mut skeleton = one_joint("Hips");
    let child = |skeleton: &mut Skeleton, parent, name| {
        skeleton.add_joint(Some(JointId(parent)), name, Vec3::X, []).expect("a joint")
    };
    child(&mut skeleton, 0, "Spine");
    child(&mut skeleton, 1, "Head");
    child(&mut skeleton, 0, "Leg");
    skeleton.add_joint(None, "Prop", Vec3::ZERO, []).expect("a joint");
    let text = write(&motion(skeleton, &[]));
    let lines: Vec<&str> =
        text.lines().filter(|line| !line.contains("OFFSET") && !line.contains("CHANNELS")).collect();
    let expected = [
        "HIERARCHY",
        "ROOT Hips",
        "{",
        "\tJOINT Spine",
        "\t{",
        "\t\tJOINT Head",
        "\t\t{",
        "\t\t}",
        "\t}",
        "\tJOINT Leg",
        "\t{",
        "\t}",
        "}",
        "ROOT Prop",
        "{",
        "}",
        "MOTION",
        "Frames: 0",
        "Frame Time: 0.5",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn numbers_are_short() {
    let values = [0.0, -0.0, 1.0, 0.1, -12.5, 1e-7, 123456.79, 1e30, f32::MIN_POSITIVE, 16777216.0];
    let text = write(&motion(one_joint("a"), &values));
    let rows: Vec<&str> = text.lines().skip(9).collect();
    assert_eq!(
        rows,
        ["0", "-0", "1", "0.1", "-12.5", "1e-7", "123456.79", "1e30", "1.1754944e-38", "16777216"]
    );
}

#[test]
fn names_that_would_be_read_as_something_else_are_refused() {
    for name in ["", " a", "a ", "\ta", "a\nb", "a\rb", "a { b", "{", "a {", &"x".repeat(4097)] {
        let expected = WriteError::Name { name: name.to_owned() };
        assert_eq!(refusal(&motion(one_joint(name), &[])), expected, "{name:?}");
    }
    let mut skeleton = one_joint("a");
    skeleton.add_end_site(JointId(0), "Tip", Vec3::X).expect("an End Site");
    assert_eq!(refusal(&motion(skeleton, &[])), WriteError::EndSiteName { name: "Tip".into() });
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let mut two = Skeleton::new();
        let channels = [Channel::Rotation(Axis::X), Channel::Rotation(Axis::Y)];
        two.add_joint(None, "a", Vec3::ZERO, channels).expect("a joint");
        assert_eq!(refusal(&motion(two, &[1.0, 2.0, 3.0, bad])), WriteError::Value { frame: 2, column: 2 });
        let mut skeleton = Skeleton::new();
        skeleton
            .add_joint(None, "a", Vec3::new(0.0, bad, 0.0), [Channel::Rotation(Axis::Y)])
            .expect("a joint");
        assert_eq!(refusal(&motion(skeleton, &[])), WriteError::Offset { joint: "a".into() });
        let endless = Motion::new(one_joint("a"), 0, f64::from(bad), Vec::new()).expect("a motion");
        assert_eq!(refusal(&endless), WriteError::FrameTime);
    }
}

#[test]
fn skeletons_without_a_place_in_the_format_are_refused() {
    let empty = Motion::new(Skeleton::new(), 0, 0.5, Vec::new()).expect("a motion");
    assert_eq!(refusal(&empty), WriteError::NoJoints);

    let mut rigid = Skeleton::new();
    rigid.add_joint(None, "a", Vec3::ZERO, []).expect("a joint");
    let frames = Motion::new(rigid, 3, 0.5, Vec::new()).expect("a motion");
    assert_eq!(refusal(&frames), WriteError::EmptyFrames { frames: 3 });

    let mut mixed = one_joint("a");
    for (parent, name) in [(0, "b"), (0, "c"), (1, "d")] {
        mixed.add_joint(Some(JointId(parent)), name, Vec3::X, []).expect("a joint");
    }
    assert_eq!(refusal(&motion(mixed, &[])), WriteError::Order { joint: "d".into() });
}

#[test]
fn rows_that_do_not_fit_are_refused_one_by_one() {
    let reason = |result: std::io::Result<()>| {
        let inner = result.expect_err("a row that does not fit").into_inner().expect("a reason");
        *inner.downcast::<WriteError>().expect("a reason of ours")
    };
    let mut out = Vec::new();
    let mut writer = bvh::Writer::new(&one_joint("a"), 2, 0.5, &mut out).expect("a beginning");
    writer.write_row(&[1.0]).expect("a row");
    let expected = WriteError::Row { frame: 2, channels: 1, found: 2 };
    assert_eq!(reason(writer.write_row(&[1.0, 2.0])), expected);
    assert_eq!(reason(writer.write_row(&[f32::NAN])), WriteError::Value { frame: 2, column: 1 });
    writer.write_row(&[2.0]).expect("a row");
    assert_eq!(reason(writer.write_row(&[3.0])), WriteError::Frames { declared: 2, found: 3 });
    writer.finish().expect("all rows");
    assert_eq!(String::from_utf8(out).expect("a text"), write(&motion(one_joint("a"), &[1.0, 2.0])));

    let mut writer = bvh::Writer::new(&one_joint("a"), 2, 0.5, Vec::new()).expect("a beginning");
    writer.write_row(&[1.0]).expect("a row");
    assert_eq!(reason(writer.finish()), WriteError::Frames { declared: 2, found: 1 });
    let refused = bvh::Writer::new(&Skeleton::new(), 0, 0.5, Vec::new()).map(drop);
    assert_eq!(reason(refused), WriteError::NoJoints);
}

#[test]
fn a_full_disk_is_reported() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let motion = motion(one_joint("a"), &[1.0]);
    assert_eq!(bvh::write(&motion, Full).expect_err("no room").kind(), std::io::ErrorKind::StorageFull);
}

/// How a joint hangs on those before it, its name, its offset and its channels.
type JointPlan = (usize, String, [f32; 3], Vec<Channel>);

fn any_finite() -> impl Strategy<Value = f32> {
    use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

fn any_name() -> impl Strategy<Value = String> {
    const BLANKS: [char; 4] = [' ', '\t', '\x0b', '\x0c'];
    let usable =
        |name: &String| name.trim_matches(BLANKS) == name && !name.split(BLANKS).any(|word| word == "{");
    prop_oneof!["[A-Za-z]{1,8}", "[^\\r\\n]{1,8}".prop_filter("a name that can be written", usable)]
}

fn any_channels() -> impl Strategy<Value = Vec<Channel>> {
    let all: Vec<Channel> =
        Axis::ALL.into_iter().flat_map(|axis| [Channel::Position(axis), Channel::Rotation(axis)]).collect();
    (Just(all).prop_shuffle(), 0usize..=6).prop_map(|(all, count)| all[..count].to_vec())
}

fn any_joint() -> impl Strategy<Value = JointPlan> {
    (0usize..5, any_name(), prop::array::uniform3(any_finite()), any_channels())
}

/// The first joint is a root. Each other one hangs on one of the last joint's ancestors, on itself, or on
/// nothing; a joint without channels may be an End Site.
fn build(plan: &[JointPlan]) -> Skeleton {
    let mut skeleton = Skeleton::new();
    // From the last joint up to its root.
    let mut line: Vec<JointId> = Vec::new();
    for (up, name, offset, channels) in plan {
        line.truncate(line.len().saturating_sub(*up));
        let (offset, parent) = (Vec3::from_array(*offset), line.last().copied());
        match parent {
            Some(parent) if channels.is_empty() => {
                skeleton.add_end_site(parent, format!("End Site{name}"), offset).expect("an End Site");
            }
            _ => line.push(skeleton.add_joint(parent, name, offset, channels.clone()).expect("a joint")),
        }
    }
    skeleton
}

fn any_motion() -> impl Strategy<Value = Motion> {
    let skeleton = prop::collection::vec(any_joint(), 1..12).prop_map(|plan| build(&plan));
    let frame_time = prop_oneof![Just(1.0 / 30.0), proptest::num::f64::POSITIVE, Just(0.0)];
    (skeleton, 0usize..5, frame_time).prop_flat_map(|(skeleton, frames, frame_time)| {
        let channels = skeleton.channel_count();
        let frames = if channels == 0 { 0 } else { frames };
        prop::collection::vec(any_finite(), frames * channels).prop_map(move |values| {
            Motion::new(skeleton.clone(), frames, frame_time, values).expect("frames of that many channels")
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn any_motion_is_the_same_after_writing_and_reading(motion in any_motion()) {
        let text = write(&motion);
        prop_assert!(!text.contains('\r'));
        let again = bvh::read(text.as_bytes()).expect("what has been written").motion;
        prop_assert_eq!(again.skeleton(), motion.skeleton());
        for (joint, other) in motion.skeleton().joints().iter().zip(again.skeleton().joints()) {
            prop_assert_eq!(bits(&joint.offset.to_array()), bits(&other.offset.to_array()));
        }
        prop_assert_eq!(again.frame_count(), motion.frame_count());
        prop_assert_eq!(again.frame_time().to_bits(), motion.frame_time().to_bits());
        prop_assert_eq!(bits(again.values()), bits(motion.values()));
        prop_assert_eq!(write(&again), text);
    }

    #[test]
    fn row_by_row_comes_out_what_the_whole_motion_does(motion in any_motion()) {
        let (mut out, frames) = (Vec::new(), motion.frame_count());
        let mut writer =
            bvh::Writer::new(motion.skeleton(), frames, motion.frame_time(), &mut out).expect("a beginning");
        for frame in 0..frames {
            writer.write_row(motion.row(frame).expect("a frame")).expect("a row that can be written");
        }
        writer.finish().expect("all rows");
        prop_assert_eq!(String::from_utf8(out).expect("a text"), write(&motion));
    }
}
