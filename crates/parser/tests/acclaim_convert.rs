//! Bones become joints and joints bones, and everything stays where it is.

mod common;

use common::acclaim::{AMC, amc, asf, figure, motion, motion_and_warnings, skeleton, skeleton_and_warnings};
use common::bones::{any_angles, any_moving_skeleton, any_rotations, any_skeleton, ends, measure};
use glam::{Quat, Vec3};
use parser::acclaim::{to_bones, to_joints};
use parser::bvh;
use proptest::prelude::*;
use skeleton::acclaim::{self, Columns};
use skeleton::{Axis, Channel, JointId, Motion, Pose, RotationOrder, Skeleton, pose_frame};

/// Where the joints and End Sites of a frame are, by the reference solution.
fn joint_positions(motion: &Motion, frame: usize) -> Vec<Vec3> {
    let mut pose = Pose::default();
    pose_frame(motion.skeleton(), &motion.frame(frame), &solutions::FK, &mut pose);
    pose.transforms().iter().map(|joint| joint.position).collect()
}

/// How a joint is turned in a frame, by the reference solution.
fn joint_rotation(motion: &Motion, frame: usize, joint: usize) -> Quat {
    let mut pose = Pose::default();
    pose_frame(motion.skeleton(), &motion.frame(frame), &solutions::FK, &mut pose);
    pose[JointId(joint)].rotation
}

/// How far bones are from the joints that were made of them, as a part of the extent, at worst.
fn worst(bones: &acclaim::Motion, joints: &Motion) -> f32 {
    let skeleton = bones.skeleton();
    let named =
        |name: &str| joints.skeleton().joints().iter().find(|joint| joint.name == name).expect("a joint");
    let mut worst = 0.0_f32;
    for frame in 0..bones.frame_count() {
        let positions = joint_positions(joints, frame);
        let ends = ends(skeleton, &bones.posture(frame));
        for bone in skeleton.bones() {
            let joint = named(&bone.name);
            let start = bone.parent.map_or(ends[0], |parent| ends[parent.0]);
            let mut off = start.distance(positions[joint.id.0]);
            for hung in joints.skeleton().joints().iter().filter(|hung| hung.parent == Some(joint.id)) {
                off = off.max(ends[bone.id.0].distance(positions[hung.id.0]));
            }
            worst = worst.max(off);
        }
    }
    worst / measure(skeleton)
}

fn channels(motion: &Motion, joint: usize) -> Vec<String> {
    motion.skeleton().joints()[joint].channels.iter().map(ToString::to_string).collect()
}

#[test]
fn bones_become_joints_where_they_start() {
    let joints = to_joints(&motion(AMC), 0.5).expect("joints");
    assert_eq!((joints.frame_count(), joints.frame_time()), (2, 0.5));
    let shown: Vec<(&str, Option<usize>, Vec3)> = joints
        .skeleton()
        .joints()
        .iter()
        .map(|joint| (joint.name.as_str(), joint.parent.map(|id| id.0), joint.offset))
        .collect();
    let expected = [
        ("root", None, Vec3::ZERO),
        ("hip", Some(0), Vec3::ZERO),
        ("thigh", Some(1), Vec3::X * 2.0),
        ("shin", Some(2), Vec3::NEG_Y * 4.0),
        ("End Site", Some(3), 3.5 * Vec3::new(0.0, 0.6, -0.8)),
    ];
    assert_eq!(shown, expected);
    assert_eq!(channels(&joints, 1), [""; 0], "a bone without dofs");
    assert_eq!(channels(&joints, 3), ["Zrotation", "Yrotation", "Xrotation"]);
    assert!(worst(&motion(AMC), &joints) < 1e-6);
}

#[test]
fn angles_about_the_worlds_axes_stay_as_they_are() {
    let text = asf("axis 10 0 20 XYZ", "axis 0 0 0 ZXY").replace("dof rx ry rz", "dof ry rz rx");
    let (bones, _) = motion_and_warnings(AMC, &skeleton(text));
    let joints = to_joints(&bones, 0.1).expect("joints");
    assert_eq!(channels(&joints, 2), ["Xrotation", "Zrotation", "Yrotation"]);
    assert_eq!(joints.row(0).map(|row| &row[..9]), Some(&[1.0, 2.0, 3.0, 6.0, 5.0, 4.0, 9.0, 8.0, 7.0][..]));
    assert!(worst(&bones, &joints) < 1e-6);
}

#[test]
fn what_hangs_on_a_bone_that_is_moved_says_where_it_is() {
    let (skeleton, _) =
        skeleton_and_warnings(asf("dof rx ry rz", "dof rx ry rz tz").replace("dof rx\n", "dof ty rx\n"));
    let text = AMC.replace("shin 10", "shin 0.5 10").replace("shin 20", "shin -0.5 20");
    let text = text.replace("7 8 9", "7 8 9 3").replace("17 18 19", "17 18 19 -2");
    let (bones, _) = motion_and_warnings(text, &skeleton);
    let joints = to_joints(&bones, 0.1).expect("joints");
    let names: Vec<&str> = joints.skeleton().joints().iter().map(|joint| &*joint.name).collect();
    assert_eq!(names, ["root", "hip", "thigh", "shin", "shin_end", "End Site"]);
    let positions = ["Xposition", "Yposition", "Zposition"];
    assert_eq!(channels(&joints, 2).len(), 3, "the bone itself only turns");
    assert_eq!(channels(&joints, 3)[..3], positions);
    assert_eq!(channels(&joints, 4), positions);
    assert!(worst(&bones, &joints) < 1e-6);
    let still = bones.posture(0).translations.iter().skip(1).all(|translation| *translation == Vec3::ZERO);
    assert!(!still, "the bones are moved");
}

#[test]
fn a_bone_that_only_moves_does_not_turn() {
    let (skeleton, _) = skeleton_and_warnings(asf("dof rx\n    limits (-10.0 170.0)", "dof ty"));
    let (bones, _) = motion_and_warnings(AMC, &skeleton);
    let joints = to_joints(&bones, 0.1).expect("joints");
    assert_eq!((channels(&joints, 3), channels(&joints, 4).len()), (vec![], 3));
    assert!(worst(&bones, &joints) < 1e-6);

    // But it does where the motion says so.
    let text = amc(":FULLY-SPECIFIED\n", ":FULLY-SPECIFIED\n:FORCE-ALL-JOINTS-BE-3DOF\n");
    let text = text.replace("shin 10", "shin 1 30 40 50").replace("shin 20", "shin 2 60 70 80");
    let (bones, _) = motion_and_warnings(text, &skeleton);
    let joints = to_joints(&bones, 0.1).expect("joints");
    assert_eq!((channels(&joints, 3).len(), channels(&joints, 4).len()), (3, 3));
    assert!(worst(&bones, &joints) < 1e-6);
    let turned = joint_rotation(&joints, 0, 3).angle_between(joint_rotation(&joints, 0, 2));
    assert!(turned > 0.5, "{turned}");
}

#[test]
fn a_root_alone_is_a_joint() {
    let bones =
        acclaim::Skeleton::new(acclaim::Root { order: vec![], ..acclaim::Root::default() }).expect("a root");
    let motion = acclaim::Motion::new(Columns::new(bones), 2, vec![]).expect("two frames");
    let joints = to_joints(&motion, 0.1).expect("a joint");
    assert_eq!((joints.skeleton().len(), joints.values()), (1, &[0.0; 12][..]));
    assert_eq!(to_bones(&joints).expect("a root").frame_count(), 2);
}

/// A figure of joints: two legs, one of them with a knee, that hang on hips below a root.
fn joints() -> Skeleton {
    let rotations = |axes: [Axis; 3]| axes.map(Channel::Rotation).to_vec();
    let mut skeleton = Skeleton::new();
    let root = [vec![Channel::Position(Axis::Y)], rotations([Axis::Z, Axis::X, Axis::Y])].concat();
    let root = skeleton.add_joint(None, "Hips", Vec3::X * 5.0, root).expect("a joint");
    let mut add = |parent, name: &str, offset, channels: Vec<Channel>| {
        skeleton.add_joint(Some(parent), name, offset, channels).expect("a joint")
    };
    let fork = add(root, "The Fork", Vec3::Y, rotations([Axis::X, Axis::Y, Axis::Z]));
    let left = add(fork, "leg", Vec3::X, rotations([Axis::Y, Axis::X, Axis::Z]));
    let knee = add(left, "knee", Vec3::NEG_Y, vec![Channel::Rotation(Axis::X)]);
    let right = add(fork, "Leg", Vec3::NEG_X, vec![Channel::Rotation(Axis::Z), Channel::Rotation(Axis::Y)]);
    add(fork, "end", Vec3::ZERO, vec![Channel::Rotation(Axis::Z)]);
    for joint in [knee, right] {
        skeleton.add_end_site(joint, "End Site", Vec3::NEG_Y * 2.0).expect("an End Site");
    }
    skeleton
}

#[test]
fn joints_become_bones_to_the_next_joint() {
    let skeleton = joints();
    let values = (0..skeleton.channel_count()).map(|value| 10.0 * value as f32).collect();
    let motion = Motion::new(skeleton, 1, 0.1, values).expect("a frame");
    let bones = to_bones(&motion).expect("bones");
    let name = |id: acclaim::BoneId| bones.skeleton().bones()[id.0].name.clone();
    let shown: Vec<(String, Option<String>, f32, String)> = bones
        .skeleton()
        .bones()
        .iter()
        .map(|bone| {
            let dofs: Vec<String> = bone.dofs.iter().map(ToString::to_string).collect();
            (bone.name.clone(), bone.parent.map(name), bone.length, dofs.join(" "))
        })
        .collect();
    let expected = [
        ("root", None, 0.0, "tx ty tz ry rx rz"),
        ("Hips_The_Fork", Some("root"), 1.0, ""),
        ("The_Fork", Some("Hips_The_Fork"), 0.0, "rz ry rx"),
        ("The_Fork_leg", Some("The_Fork"), 1.0, ""),
        ("leg", Some("The_Fork_leg"), 1.0, "rz rx ry"),
        ("knee", Some("leg"), 2.0, "rx"),
        ("The_Fork_Leg_2", Some("The_Fork"), 1.0, ""),
        ("Leg_2", Some("The_Fork_Leg_2"), 2.0, "ry rz"),
        ("_end", Some("The_Fork"), 0.0, "rz"),
    ];
    let expected = expected.map(|(name, parent, length, dofs)| {
        (name.to_owned(), parent.map(str::to_owned), length, dofs.to_owned())
    });
    assert_eq!(shown, expected);
    // What has no channel stays where the OFFSET puts it, and the numbers of a bone come from last to first.
    let row =
        [5.0, 0.0, 0.0, 30.0, 20.0, 10.0, 60.0, 50.0, 40.0, 90.0, 80.0, 70.0, 100.0, 120.0, 110.0, 130.0];
    assert_eq!(bones.row(0), Some(&row[..]));
}

#[test]
fn what_bones_cannot_say_is_said() {
    let convert = |skeleton: Skeleton, frames: usize, values: Vec<f32>| {
        let motion = Motion::new(skeleton, frames, 0.1, values).expect("a motion");
        to_bones(&motion).expect_err("what bones cannot say").to_string()
    };
    assert_eq!(
        convert(Skeleton::new(), 0, vec![]),
        "there is no joint, and a skeleton of bones has a root at least"
    );
    let mut two = joints();
    two.add_joint(None, "Prop", Vec3::ZERO, []).expect("a joint");
    assert_eq!(convert(two, 0, vec![]), "`Prop` is a second root, and a skeleton of bones has one");
    let slides = |values: [f32; 3]| {
        let mut skeleton = joints();
        let channels = [Channel::Position(Axis::Z)];
        skeleton.add_joint(Some(JointId(0)), "slide", Vec3::ONE, channels).expect("a joint");
        let width = skeleton.channel_count();
        let row = |value: f32| [vec![0.0; width - 1], vec![value]].concat();
        Motion::new(skeleton, 3, 0.1, values.map(row).concat()).expect("a motion")
    };
    let error = to_bones(&slides([1.0, 1.0, 1.1])).expect_err("a joint that slides").to_string();
    let expected = "in frame 3 (counted from 1) the joint `slide` is elsewhere on its parent than before: bones do not \
                    change their length";
    assert_eq!(error, expected);
    let bones = to_bones(&slides([7.0; 3])).expect("a joint that does not slide");
    let slide = bones.skeleton().find("Hips_slide").expect("a bone to the slide");
    assert!(slide.rest_vector().abs_diff_eq(Vec3::new(1.0, 1.0, 7.0), 1e-5));
}

/// A motion of joints that do not change their distances, with names that can be those of bones.
fn any_joints() -> impl Strategy<Value = Motion> {
    let joint =
        (any::<prop::sample::Index>(), prop::array::uniform3(-2f32..2.0), any_rotations(), any::<bool>());
    let plan = prop::collection::vec(joint, 0..10);
    (plan, any_rotations(), any_angles()).prop_map(|(plan, rotations, values)| {
        let mut skeleton = Skeleton::new();
        let root = [vec![Channel::Position(Axis::X)], rotations].concat();
        skeleton.add_joint(None, "root", Vec3::ONE, root).expect("a root");
        for (parent, offset, channels, is_tip) in plan {
            let parent = JointId(parent.index(skeleton.len()));
            let offset = if offset[0] < -1.0 { Vec3::ZERO } else { Vec3::from_array(offset) };
            let name = format!("joint{}", skeleton.len());
            // What would hang on an End Site is left out.
            let _ = match is_tip {
                true => skeleton.add_end_site(parent, name, offset),
                false => skeleton.add_joint(Some(parent), name, offset, channels),
            };
        }
        let values = (0..skeleton.channel_count()).map(|i| values[i % 3] + 7.0 * i as f32).collect();
        Motion::new(skeleton, 1, 0.1, values).expect("a frame")
    })
}

/// Three frames of numbers for these bones.
fn three_frames(skeleton: acclaim::Skeleton) -> impl Strategy<Value = acclaim::Motion> {
    let columns = Columns::new(skeleton);
    prop::collection::vec(any_angles(), columns.len()).prop_map(move |rows| {
        let values = (0..3).flat_map(|frame| rows.iter().map(move |row| row[frame])).collect();
        acclaim::Motion::new(columns.clone(), 3, values).expect("three frames")
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn bones_stay_where_they_are(
        bones in any_skeleton().prop_flat_map(three_frames),
    ) {
        let joints = to_joints(&bones, 1.0 / 120.0).expect("joints");
        prop_assert!(worst(&bones, &joints) < 1e-4, "{}", worst(&bones, &joints));
        // And back again: the same bones, with more of them where several hang on one.
        let again = to_bones(&joints).expect("bones");
        for frame in 0..3 {
            let [before, after] = [&bones, &again].map(|motion| ends(motion.skeleton(), &motion.posture(frame)));
            for end in before {
                let off = after.iter().map(|other| other.distance(end)).fold(f32::INFINITY, f32::min);
                prop_assert!(off < 1e-4 * measure(bones.skeleton()), "{off}");
            }
        }
    }

    #[test]
    fn bones_that_are_moved_stay_where_they_are(
        bones in any_moving_skeleton().prop_flat_map(three_frames),
    ) {
        let joints = to_joints(&bones, 1.0 / 120.0).expect("joints");
        let all_ends = (0..3).flat_map(|frame| ends(bones.skeleton(), &bones.posture(frame)));
        let reach = all_ends.map(Vec3::length).fold(measure(bones.skeleton()), f32::max);
        let off = worst(&bones, &joints) * measure(bones.skeleton()) / reach;
        prop_assert!(off < 1e-5, "{off}");
        // A file says the same as the joints.
        let mut file = Vec::new();
        bvh::write(&joints, &mut file).expect("a file");
        let read = bvh::read(&*file).expect("the same").motion;
        prop_assert_eq!(read.skeleton(), joints.skeleton());
    }

    #[test]
    fn joints_stay_where_they_are(joints in any_joints()) {
        let bones = to_bones(&joints).expect("bones");
        let ends = ends(bones.skeleton(), &bones.posture(0));
        let positions = joint_positions(&joints, 0);
        let tolerance = 1e-4 * measure(bones.skeleton());
        for joint in joints.skeleton().joints() {
            let position = positions[joint.id.0];
            let off = if joint.is_end_site {
                ends.iter().map(|end| end.distance(position)).fold(f32::INFINITY, f32::min)
            } else {
                let bone = bones.skeleton().find(&joint.name).expect("the joint's bone");
                bone.parent.map_or(ends[0], |parent| ends[parent.0]).distance(position)
            };
            prop_assert!(off < tolerance, "{}: {off}", joint.name);
        }
        let again = to_joints(&bones, 0.1).expect("joints again");
        prop_assert!(worst(&bones, &again) < 1e-4);
    }
}

#[test]
fn a_long_motion_has_no_leaps() {
    // The bone swings to and fro through where angles about Z, Y and X lose their meaning.
    let skeleton = skeleton(asf("axis 10 0 20 XYZ", "axis 0 90 30 XYZ"));
    let frames = 720;
    let columns = Columns::new(skeleton).without(&[acclaim::BoneId::ROOT, acclaim::BoneId(3)]);
    let values = (0..frames).flat_map(|frame| {
        let phase = f32::to_radians(frame as f32);
        [80.0 * phase.sin(), 70.0 * phase.cos(), 60.0 * (2.0 * phase).sin()]
    });
    let bones = acclaim::Motion::new(columns, frames, values.collect()).expect("a motion");
    let joints = to_joints(&bones, 0.1).expect("joints");
    assert_eq!(joints.skeleton().joints()[2].rotation_order, RotationOrder::Zyx);
    let widest = widest_leap(&joints);
    assert!(widest < 5.0, "{widest}");
    assert!(worst(&bones, &joints) < 1e-5);
}

#[test]
fn a_wheel_goes_on_turning() {
    let columns = Columns::new(figure()).without(&[acclaim::BoneId::ROOT, acclaim::BoneId(2)]);
    let values = (0..720).map(|frame| 40.0 * frame as f32).collect();
    let bones = acclaim::Motion::new(columns, 720, values).expect("a motion");
    let joints = to_joints(&bones, 0.1).expect("joints");
    let widest = widest_leap(&joints);
    assert!((40.0..45.0).contains(&widest), "{widest}");
    assert!(worst(&bones, &joints) < 1e-4);
}

/// By how much a number changes at most from a frame to the next.
fn widest_leap(joints: &Motion) -> f32 {
    let rows: Vec<&[f32]> = (0..joints.frame_count()).filter_map(|frame| joints.row(frame)).collect();
    let leaps = rows.windows(2).flat_map(|rows| rows[0].iter().zip(rows[1]).map(|(a, b)| (a - b).abs()));
    leaps.fold(0.0, f32::max)
}

#[test]
fn a_deep_figure_can_be_converted() {
    let mut deep = Skeleton::new();
    let mut last = deep.add_joint(None, "r", Vec3::ZERO, []).expect("a root");
    for _ in 0..100_000 {
        last = deep.add_joint(Some(last), "j", Vec3::Y, [Channel::Rotation(Axis::X)]).expect("a joint");
    }
    let values = vec![0.0; deep.channel_count()];
    let bones = to_bones(&Motion::new(deep, 1, 0.1, values).expect("a frame")).expect("bones");
    let joints = to_joints(&bones, 0.1).expect("joints");
    assert_eq!(joints.skeleton().len(), bones.skeleton().len() + 1);
}

#[test]
fn what_went_to_and_fro_once_does_so_again_without_a_change() {
    for name in ["running", "dance"] {
        let path = format!("{}/../../data/{name}.bvh", env!("CARGO_MANIFEST_DIR"));
        let bones = to_bones(&bvh::read_file(path).unwrap().motion).unwrap();
        let joints = to_joints(&bones, 0.01).unwrap();
        let again = to_bones(&joints).unwrap();
        assert_eq!(again, bones);
        assert_eq!(to_joints(&again, 0.01).unwrap(), joints);
    }
}

#[test]
fn very_small_and_very_large_joints_keep_their_length() {
    for offset in [Vec3::new(1e-30, 2e-40, 0.0), Vec3::new(1e38, -2e38, 1e38), Vec3::Y * 1e-45] {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "r", Vec3::ZERO, []).unwrap();
        skeleton.add_joint(Some(root), "j", offset, []).unwrap();
        let bones = to_bones(&Motion::new(skeleton, 0, 0.1, Vec::new()).unwrap()).unwrap();
        assert!(bones.skeleton().bones().iter().any(|bone| bone.rest_vector() == offset), "{offset}");
    }
}
