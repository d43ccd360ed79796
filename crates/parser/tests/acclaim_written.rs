//! What is written as Acclaim is what is read.

mod common;

use common::acclaim::{figure, motion};
use glam::Vec3;
use parser::acclaim::{self, WriteError};
use proptest::prelude::*;
use skeleton::acclaim::{
    AngleUnit, BoneData, BoneId, Columns, DegreeOfFreedom, LocalAxes, Motion, Root, Skeleton, Units,
};
use skeleton::{Axis, Channel, RotationOrder};

fn write_skeleton(skeleton: &Skeleton) -> String {
    let mut out = Vec::new();
    acclaim::write_skeleton(skeleton, &mut out).expect("a skeleton that can be written");
    String::from_utf8(out).expect("a text")
}

fn write_motion(motion: &Motion) -> String {
    let mut out = Vec::new();
    acclaim::write_motion(motion, &mut out).expect("a motion that can be written");
    String::from_utf8(out).expect("a text")
}

/// Why something cannot be written. Nothing may have been written, then.
fn refusal(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> WriteError {
    let mut out = Vec::new();
    let error = write(&mut out).expect_err("what cannot be written");
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert!(out.is_empty());
    let inner = error.into_inner().expect("a reason");
    *inner.downcast::<WriteError>().expect("a reason of ours")
}

#[test]
fn a_skeleton_is_written_in_the_usual_form() {
    let expected = "\
:version 1.10
:name FIGURE
:units
  mass 1
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name hip
    direction 1 0 0
    length 2
    axis 0 0 0 XYZ
  end
  begin
    id 2
    name thigh
    direction 0 -1 0
    length 4
    axis 10 0 20 XYZ
    dof rx ry rz
    limits (-160 20)
           (-70 70)
           (-60 70)
  end
  begin
    id 3
    name shin
    direction 0 0.6 -0.8
    length 3.5
    axis 0 0 20 XYZ
    dof rx
    limits (-10 170)
  end
:hierarchy
  begin
    root hip
    hip thigh
    thigh shin
  end
";
    assert_eq!(write_skeleton(&figure()), expected);
}

#[test]
fn a_motion_is_written_in_the_usual_form() {
    let text = ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 1 2 3 4 5 6\nthigh 7 8.5 -0\nshin 1e-7\n";
    assert_eq!(write_motion(&motion(text)), text);
    let text = ":FULLY-SPECIFIED\n:FORCE-ALL-JOINTS-BE-3DOF\n:DEGREES\n1\nroot 1 2 3 4 5 6\nthigh 7 8 9\nshin 1 2 3\n";
    assert_eq!(write_motion(&motion(text)), text);
}

#[test]
fn limits_are_written_where_there_are_some() {
    let dof = DegreeOfFreedom::unlimited;
    let half = DegreeOfFreedom { low: -1.5, ..dof(Channel::Position(Axis::X)) };
    let mut skeleton = Skeleton::new(Root::default()).expect("a root");
    let mut add = |name: &str, dofs| {
        let data =
            BoneData { name: name.into(), direction: Vec3::X, length: 1.0, dofs, ..BoneData::default() };
        skeleton.add_bone(BoneId::ROOT, data).expect("a bone");
    };
    add("free", vec![dof(Channel::Rotation(Axis::Y)), dof(Channel::Rotation(Axis::X))]);
    add("half", vec![dof(Channel::Rotation(Axis::Z)), half]);
    let text = write_skeleton(&skeleton);
    assert!(text.contains("dof ry rx\n  end\n"), "{text}");
    assert!(text.contains("dof rz tx\n    limits (-inf inf)\n           (-1.5 inf)\n  end\n"), "{text}");
}

#[test]
fn radians_are_written_in_few_digits_where_these_are_enough() {
    let mut skeleton = figure();
    skeleton.units.angle = AngleUnit::Radians;
    let quarter = |radians: f64| radians.to_degrees() as f32;
    let columns = Columns::new(skeleton).without(&[BoneId::ROOT, BoneId(2)]);
    let motion = Motion::new(columns, 3, vec![quarter(1.5), quarter(-0.1), 90.0]).expect("three frames");
    let text = write_motion(&motion);
    assert!(
        text.starts_with(":FULLY-SPECIFIED\n:RADIANS\n1\nshin 1.5\n2\nshin -0.1\n3\nshin 1.570796"),
        "{text}"
    );
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    for bad in [f32::NAN, f32::INFINITY] {
        let bone = |change: fn(&mut BoneData, f32)| {
            let mut data = BoneData { name: "a".into(), ..BoneData::default() };
            change(&mut data, bad);
            let mut skeleton = Skeleton::new(Root::default()).expect("a root");
            skeleton.add_bone(BoneId::ROOT, data).expect("a bone");
            refusal(|out| acclaim::write_skeleton(&skeleton, out))
        };
        let expected = WriteError::Bone { bone: "a".into() };
        assert_eq!(bone(|data, bad| data.length = bad), expected);
        assert_eq!(bone(|data, bad| data.direction.y = bad), expected);
        assert_eq!(bone(|data, bad| data.axis.angles[2] = bad), expected);
        let root = Root { position: Vec3::new(0.0, bad, 0.0), ..Root::default() };
        let root = Skeleton::new(root).expect("a root");
        let refused = refusal(|out| acclaim::write_skeleton(&root, out));
        assert_eq!(refused, WriteError::Bone { bone: "root".into() });
        let mut unit = figure();
        unit.units.length = bad;
        assert_eq!(refusal(|out| acclaim::write_skeleton(&unit, out)), WriteError::Units);
        let mut values = vec![0.0; 20];
        values[18] = bad;
        let motion = Motion::new(Columns::new(figure()), 2, values).expect("two frames");
        let expected = WriteError::Value { frame: 2, bone: "thigh".into() };
        assert_eq!(refusal(|out| acclaim::write_motion(&motion, out)), expected);
    }
    let mut skeleton = Skeleton::new(Root::default()).expect("a root");
    let dofs =
        vec![DegreeOfFreedom { low: f32::NAN, ..DegreeOfFreedom::unlimited(Channel::Rotation(Axis::X)) }];
    skeleton
        .add_bone(BoneId::ROOT, BoneData { name: "a".into(), dofs, ..BoneData::default() })
        .expect("a bone");
    let refused = refusal(|out| acclaim::write_skeleton(&skeleton, out));
    assert_eq!(refused, WriteError::Bone { bone: "a".into() });
}

#[test]
fn names_of_skeletons_that_would_be_read_as_something_else_are_refused() {
    for name in [" a", "a ", "a\nb", "a\rb", "#", "a #b", "a\t#", &"x".repeat(4097)] {
        let mut skeleton = figure();
        skeleton.name = name.to_owned();
        let refused = refusal(|out| acclaim::write_skeleton(&skeleton, out));
        assert_eq!(refused, WriteError::Name { name: name.to_owned() });
    }
    for name in ["", "a", "a  b#c :d", "Hüfte", ":units"] {
        let mut skeleton = figure();
        skeleton.name = name.to_owned();
        let again =
            acclaim::read_skeleton(write_skeleton(&skeleton).as_bytes()).expect("what has been written");
        assert_eq!((again.skeleton, again.warnings), (skeleton, vec![]));
    }
}

#[test]
fn frames_that_do_not_fit_are_refused_one_by_one() {
    let reason = |result: std::io::Result<()>| {
        let inner = result.expect_err("a frame that does not fit").into_inner().expect("a reason");
        *inner.downcast::<WriteError>().expect("a reason of ours")
    };
    let columns = Columns::new(figure());
    let (mut out, row) = (Vec::new(), vec![1.5; columns.len()]);
    let mut writer = acclaim::MotionWriter::new(&columns, &mut out).expect("a beginning");
    writer.write_row(&row).expect("a frame");
    let expected = WriteError::Row { frame: 2, columns: row.len(), found: 1 };
    assert_eq!(reason(writer.write_row(&[1.0])), expected);
    let mut bad = row.clone();
    bad[6] = f32::NAN;
    assert_eq!(reason(writer.write_row(&bad)), WriteError::Value { frame: 2, bone: "thigh".into() });
    writer.write_row(&row).expect("a frame");
    writer.finish().expect("the end");
    let whole = Motion::new(columns, 2, [row.clone(), row].concat()).expect("two frames");
    assert_eq!(String::from_utf8(out).expect("a text"), write_motion(&whole));
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
    let kind = |result: std::io::Result<()>| result.expect_err("no room").kind();
    assert_eq!(kind(acclaim::write_skeleton(&figure(), Full)), std::io::ErrorKind::StorageFull);
    let motion = motion(common::acclaim::AMC);
    assert_eq!(kind(acclaim::write_motion(&motion, Full)), std::io::ErrorKind::StorageFull);
}

fn any_finite() -> impl Strategy<Value = f32> {
    use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![-400f32..400.0, POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO]
}

fn any_axes() -> impl Strategy<Value = LocalAxes> {
    (prop::array::uniform3(any_finite()), prop::sample::select(RotationOrder::ROTATING.to_vec()))
        .prop_map(|(angles, order)| LocalAxes { angles, order })
}

fn any_dofs() -> impl Strategy<Value = Vec<DegreeOfFreedom>> {
    let all: Vec<Channel> =
        Axis::ALL.into_iter().flat_map(|axis| [Channel::Position(axis), Channel::Rotation(axis)]).collect();
    let limit = || prop_oneof![any_finite(), Just(f32::INFINITY), Just(f32::NEG_INFINITY)];
    let limits = prop_oneof![Just(None), (limit(), limit()).prop_map(Some)];
    (Just(all).prop_shuffle(), 0usize..=6, prop::array::uniform6(limits)).prop_map(|(all, count, limits)| {
        let limited = |(channel, limits): (&Channel, Option<(f32, f32)>)| {
            let free = DegreeOfFreedom::unlimited(*channel);
            limits.map_or(free, |(low, high)| DegreeOfFreedom { low, high, ..free })
        };
        all[..count].iter().zip(limits).map(limited).collect()
    })
}

fn any_bone() -> impl Strategy<Value = (prop::sample::Index, BoneData)> {
    let name =
        prop_oneof!["[a-z]{1,6}", "\\PC{1,6}"].prop_filter("a name", |name| Skeleton::accepts_name(name));
    let numbers = (prop::array::uniform3(any_finite()), any_finite());
    (any::<prop::sample::Index>(), name, numbers, any_axes(), any_dofs()).prop_map(
        |(parent, name, (direction, length), axis, dofs)| {
            (parent, BoneData { name, direction: Vec3::from_array(direction), length, axis, dofs })
        },
    )
}

fn any_skeleton() -> impl Strategy<Value = Skeleton> {
    let root = (any_dofs(), any_axes(), prop::array::uniform3(any_finite())).prop_map(
        |(dofs, orientation, position)| Root {
            order: dofs.iter().map(|dof| dof.channel).collect(),
            orientation,
            position: Vec3::from_array(position),
        },
    );
    let angle = prop::sample::select(vec![AngleUnit::Degrees, AngleUnit::Radians]);
    let units =
        (any_finite(), any_finite(), angle).prop_map(|(mass, length, angle)| Units { mass, length, angle });
    (root, units, "[a-z ]{0,8}", prop::collection::vec(any_bone(), 0..8)).prop_map(
        |(root, units, name, plan)| {
            let mut skeleton = Skeleton::new(root).expect("a root");
            (skeleton.units, skeleton.name) = (units, name.trim().to_owned());
            for (parent, bone) in plan {
                let parent = BoneId(parent.index(skeleton.len()));
                // A name that is there already is refused: one bone less.
                let _ = skeleton.add_bone(parent, bone);
            }
            skeleton
        },
    )
}

fn any_motion() -> impl Strategy<Value = Motion> {
    let still = prop::collection::vec(0usize..10, 0..4);
    (any_skeleton(), still, any::<bool>(), 0usize..5).prop_flat_map(|(skeleton, still, three, frames)| {
        let still: Vec<BoneId> = still.into_iter().map(BoneId).collect();
        let columns = Columns::new(skeleton).without(&still);
        let columns = if three { columns.with_three_angles() } else { columns };
        prop::collection::vec(any_finite(), frames * columns.len())
            .prop_map(move |values| Motion::new(columns.clone(), frames, values).expect("so many frames"))
    })
}

/// All numbers of a skeleton, to the last bit.
fn bits(skeleton: &Skeleton) -> Vec<u32> {
    let bones = skeleton.bones().iter().flat_map(|bone| {
        let limits = bone.dofs.iter().flat_map(|dof| [dof.low, dof.high]);
        bone.direction.to_array().into_iter().chain([bone.length]).chain(bone.axis.angles).chain(limits)
    });
    bones.chain(skeleton.position().to_array()).map(f32::to_bits).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn any_motion_is_the_same_after_writing_and_reading(motion in any_motion()) {
        let text = write_skeleton(motion.skeleton());
        let skeleton = acclaim::read_skeleton(text.as_bytes()).expect("what has been written").skeleton;
        prop_assert_eq!(bits(&skeleton), bits(motion.skeleton()));
        // Infinite numbers give rotations that are none, which differ from themselves.
        prop_assert_eq!(write_skeleton(&skeleton), text);
        let text = write_motion(&motion);
        prop_assert!(!text.contains('\r'));
        let again = acclaim::read_motion(text.as_bytes(), motion.skeleton()).expect("what has been written").motion;
        let values = |motion: &Motion| motion.values().iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(values(&again), values(&motion));
        prop_assert_eq!(again.frame_count(), motion.frame_count());
        prop_assert_eq!(again.columns().still(), motion.columns().still());
        prop_assert_eq!(write_motion(&again), text);
    }

    #[test]
    fn frame_by_frame_comes_out_what_the_whole_motion_does(motion in any_motion()) {
        let mut out = Vec::new();
        let mut writer = acclaim::MotionWriter::new(motion.columns(), &mut out).expect("a beginning");
        for frame in 0..motion.frame_count() {
            writer.write_row(motion.row(frame).expect("a frame")).expect("a frame that can be written");
        }
        writer.finish().expect("the end");
        prop_assert_eq!(String::from_utf8(out).expect("a text"), write_motion(&motion));
    }
}
