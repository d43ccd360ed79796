//! Warped motions.

use glam::EulerRot;
use grading::fk::angle_between;
use skeleton::Channel;

use super::*;

/// How far an angle may be off, in degrees.
const CLOSE: f64 = 0.01;

/// Sees to it that both postures have every bone at the same place and turned in the same way.
fn assert_same(skeleton: &Skeleton, now: &Posture, then: &Posture, extent: f32, what: &str) {
    for (now, then) in places(skeleton, now).iter().zip(places(skeleton, then)) {
        assert!(now.end.distance(then.end) < 1e-4 * extent, "{what}: {now:?}, was {then:?}");
        assert!(angle_between(now.rotation, then.rotation) < CLOSE, "{what}: {now:?}, was {then:?}");
    }
}

#[test]
fn as_many_frames_as_there_were_are_those_that_there_were() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 5);
    for (file, frames) in [(data("walk.amc"), "480"), (odd, "5")] {
        let out = folder.text("same.amc");
        run(&[&file, "--warp", frames, "--out", &out, "--overwrite"]).unwrap();
        assert_eq!(read_bones(&out), read_bones(&file));
    }
    for name in ["dance.bvh", "arm.bvh"] {
        let (out, original) = (folder.text("same.bvh"), read(data(name)));
        let frames = original.frame_count().to_string();
        let (said, _) = run(&[&data(name), "--warp", &frames, "--out", &out, "--overwrite"]).unwrap();
        assert!(said.contains(&format!("warped             from {frames} frames")), "{said}");
        assert_eq!(read(&out), original);
    }
}

#[test]
fn twice_as_many_frames_and_back_are_those_that_there_were() {
    let folder = Folder::new();
    let (twice, back) = (folder.text("twice.bvh"), folder.text("back.bvh"));
    for name in ["dance.bvh", "arm.bvh"] {
        let original = read(data(name));
        let frames = original.frame_count();
        run(&[&data(name), "--warp", &(2 * frames).to_string(), "--out", &twice, "--overwrite"]).unwrap();
        assert_eq!(
            (read(&twice).frame_count(), read(&twice).frame_time()),
            (2 * frames, original.frame_time())
        );
        run(&[&twice, "--warp", &frames.to_string(), "--out", &back, "--overwrite"]).unwrap();
        assert_eq!(read(&back), original);
    }
    let (twice, back) = (folder.text("twice.amc"), folder.text("back.amc"));
    run(&[&data("walk.amc"), "--warp", "960", "--out", &twice]).unwrap();
    run(&[&twice, "--warp", "480", "--out", &back]).unwrap();
    assert_eq!(read_bones(&back), read_bones(data("walk.amc")));
    // Of odd bones the file has more angles than before, and every bone is turned as it was.
    let odd = odd_files(&folder, 7);
    run(&[&odd, "--warp", "14", "--out", &twice, "--overwrite"]).unwrap();
    run(&[&twice, "--warp", "7", "--out", &back, "--overwrite"]).unwrap();
    let (now, then) = (read_bones(&back), read_bones(&odd));
    assert_eq!(now.skeleton(), then.skeleton());
    assert!((0..7).all(|frame| now.posture(frame) == then.posture(frame)));
}

#[test]
fn between_two_frames_a_walk_is_what_the_exercise_blends() {
    let folder = Folder::new();
    let out = folder.text("slow.amc");
    let (said, complaints) = run(&[&data("walk.amc"), "--warp", "1500", "--out", &out]).unwrap();
    assert!(complaints.is_empty() && said.starts_with(&format!("{out}: 1500 frames, 30 bones\n")), "{said}");
    let (walk, slow) = (read_bones(data("walk.amc")), read_bones(&out));
    assert_eq!((slow.skeleton(), slow.columns()), (walk.skeleton(), walk.columns()));
    let joints = acclaim::to_joints(&walk, 1.0).unwrap();
    let old: Vec<Posture> = (0..480).map(|frame| walk.posture(frame)).collect();
    for (frame, then) in (solutions::TIME_WARP.warp)(&old, 1500).iter().enumerate() {
        let what = format!("frame {frame}");
        assert_same(walk.skeleton(), &slow.posture(frame), then, joints.skeleton().extent(), &what);
    }
    // Also as joints.
    let as_joints = folder.text("slow.bvh");
    run(&[&data("walk.amc"), "--warp", "1500", "--out", &as_joints]).unwrap();
    assert_same_in_both_formats(&slow, &read(&as_joints));
}

fn assert_same_in_both_formats(bones: &skeleton::acclaim::Motion, joints: &Motion) {
    assert_eq!(bones.frame_count(), joints.frame_count());
    for frame in 0..joints.frame_count() {
        let places = places(bones.skeleton(), &bones.posture(frame));
        for (joint, transform) in joints.skeleton().joints().iter().zip(pose(joints, frame).transforms()) {
            let Some(bone) = bones.skeleton().find(&joint.name) else { continue };
            let off = places[bone.id.0].start.distance(transform.position);
            assert!(off < 1e-4 * joints.skeleton().extent(), "{} in frame {frame}: {off}", joint.name);
        }
    }
}

#[test]
fn bones_of_every_order_turn_evenly_about_one_axis() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 6);
    let (out, as_joints) = (folder.text("slow odd.amc"), folder.text("slow odd.bvh"));
    let (said, _) = run(&[&odd, "--warp", "24", "--out", &out]).unwrap();
    let angles = "three for every bone that moves: the two angles of two would be off by";
    assert!(said.contains(angles) && said.contains(" degrees in frame 1 (counted from 0)\n"), "{said}");
    let text = fs::read_to_string(&out).unwrap();
    assert!(text.contains(":FORCE-ALL-JOINTS-BE-3DOF\n"), "{text}");
    let (old, new) = (read_bones(&odd), read_bones(&out));
    assert_eq!(new.skeleton(), old.skeleton());
    assert_eq!(new.frame_count(), 24);
    for frame in 0..24 {
        let (before, t) = (frame / 4, (frame % 4) as f32 / 4.0);
        let [from, to] = [before, (before + 1).min(5)].map(|frame| old.posture(frame));
        let now = new.posture(frame);
        for bone in old.skeleton().bones() {
            let [from, to, now] = [&from, &to, &now].map(|posture| turned(bone, posture.angles[bone.id.0]));
            let off = angle_between(from.slerp(to, t), now);
            assert!(off < CLOSE, "{} in frame {frame} is off by {off}", bone.name);
        }
        let root = [&from, &to].map(|posture| posture.translations[0]);
        assert!(now.translations[0].distance(root[0].lerp(root[1], t)) < 1e-4);
        // A bone with one degree of freedom needs no other.
        assert!(now.angles[3][0] == 0.0 && now.angles[3][2] == 0.0, "{:?}", now.angles[3]);
    }
    run(&[&odd, "--warp", "24", "--out", &as_joints]).unwrap();
    assert_same_in_both_formats(&new, &read(&as_joints));
}

#[test]
fn angles_go_on_without_a_jump() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 6);
    let (bones, joints) = (folder.text("slow.amc"), folder.text("slow.bvh"));
    run(&[&odd, "--warp", "600", "--out", &bones]).unwrap();
    run(&[&odd, "--warp", "600", "--out", &joints]).unwrap();
    let (bones, joints) = (read_bones(&bones), read(&joints));
    // Near a gimbal lock angles are fast, but none leaps by half a turn or a whole one.
    for frame in (1..500).filter(|frame| frame % 100 > 1) {
        let both = |frame: usize| [bones.row(frame).unwrap(), joints.row(frame).unwrap()].concat();
        for (before, now) in both(frame - 1).into_iter().zip(both(frame)) {
            assert!((before - now).abs() < 45.0, "from {before} to {now} in frame {frame}");
        }
    }
}

/// A wheel does not turn back all its turns between two frames.
#[test]
fn angles_of_many_turns_go_on_as_they_are() {
    let folder = Folder::new();
    let (file, out) = (folder.text("wheel.bvh"), folder.text("slow wheel.bvh"));
    let rows: String = (0..40).map(|i| format!("{} {} 10\n", 3000 + 170 * i, 5 * (i % 9))).collect();
    let text = format!(
        "HIERARCHY\nROOT r\n{{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{{\nOFFSET 0 5 0\n}}\n}}\n\
         MOTION\nFrames: 40\nFrame Time: 0.04\n{rows}"
    );
    fs::write(&file, text).unwrap();
    run(&[&file, "--warp", "400", "--out", &out]).unwrap();
    let (then, now) = (read(&file), read(&out));
    for frame in 1..390 {
        for column in 0..3 {
            let step = |motion: &Motion, frame: usize| {
                (motion.row(frame + 1).unwrap()[column] - motion.row(frame).unwrap()[column]).abs()
            };
            let (old, new) = (step(&then, frame / 10), step(&now, frame));
            assert!(new < old + 30.0, "{new} behind frame {frame}, and {old} in the original");
        }
    }
    let half = now.row(5).unwrap();
    let there =
        Quat::from_euler(EulerRot::ZXY, half[0].to_radians(), half[1].to_radians(), half[2].to_radians());
    let [from, to] = [0, 1].map(|frame| {
        let [z, x, y] = <[f32; 3]>::try_from(then.row(frame).unwrap()).unwrap().map(f32::to_radians);
        Quat::from_euler(EulerRot::ZXY, z, x, y)
    });
    assert!(angle_between(from.slerp(to, 0.5), there) < CLOSE);
}

#[test]
fn a_run_of_joints_becomes_a_slow_run_of_bones() {
    let folder = Folder::new();
    let (bones, joints) = (folder.text("slow dance.amc"), folder.text("slow dance.bvh"));
    let frames = (3 * read(data("dance.bvh")).frame_count()).to_string();
    run(&[&data("dance.bvh"), "--warp", &frames, "--out", &bones]).unwrap();
    run(&[&data("dance.bvh"), "--warp", &frames, "--out", &joints]).unwrap();
    assert_same_in_both_formats(&read_bones(&bones), &read(&joints));
}

#[test]
fn a_stretch_is_warped_and_the_rest_is_as_it_was() {
    let folder = Folder::new();
    let out = folder.text("stretch.bvh");
    let original = read(data("dance.bvh"));
    let (said, _) = run(&[&data("dance.bvh"), "--between", "40,20", "--warp", "60", "--out", &out]).unwrap();
    let last = original.frame_count() - 1;
    assert!(said.contains(": 20 between 20 and 40 became 60\n"), "{said}");
    let warped = read(&out);
    assert_eq!(warped.frame_count(), original.frame_count() + 40);
    for (old, new) in [(0, 0), (20, 20), (21, 23), (39, 77), (40, 80), (last, last + 40)] {
        assert_eq!(warped.row(new), original.row(old), "{old}");
    }
    assert_ne!(warped.row(21), original.row(21));
}

#[test]
fn one_frame_becomes_many_and_many_become_one() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 1);
    for out in ["many.amc", "many.bvh"] {
        run(&[&odd, "--warp", "5", "--out", &folder.text(out)]).unwrap();
    }
    let (then, now) = (read_bones(&odd), read_bones(folder.path("many.amc")));
    assert_eq!(now.frame_count(), 5);
    assert!((0..5).all(|frame| now.row(frame) == then.row(0)));
    let now = read(folder.path("many.bvh"));
    assert!(now.frame_count() == 5 && (0..5).all(|frame| now.row(frame) == now.row(0)));

    for (file, out) in [("walk.amc", "one.amc"), ("walk.amc", "one.bvh"), ("dance.bvh", "one dance.bvh")] {
        let (said, _) = run(&[&data(file), "--warp", "1", "--out", &folder.text(out)]).unwrap();
        assert!(said.contains(": 1 frame, "), "{said}");
    }
    assert_eq!(read_bones(folder.path("one.amc")).row(0), read_bones(data("walk.amc")).row(0));
    assert_eq!(read(folder.path("one dance.bvh")).row(0), read(data("dance.bvh")).row(0));
}

#[test]
fn rotations_that_channels_cannot_hold_are_told() {
    let folder = Folder::new();
    let (file, out) = (folder.text("two.bvh"), folder.text("slow.bvh"));
    let text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Zrotation Xrotation\nEnd Site\n{\nOFFSET 0 5 0\n}\n}\n\
                MOTION\nFrames: 2\nFrame Time: 0.04\n0 0 0\n1 80 60\n";
    fs::write(&file, text).unwrap();
    let (_, complaints) = run(&[&file, "--warp", "20", "--out", &out]).unwrap();
    assert!(complaints.starts_with("two.bvh: r has 2 rotation channels, which cannot hold"), "{complaints}");
    assert!(complaints.ends_with(", counted from 0)\n"), "{complaints}");
    let motion = read(&out);
    assert!(motion.skeleton().joints()[0].channels.contains(&Channel::Rotation(skeleton::Axis::Z)));
    // Half-way, the nearest that there is.
    let half = Quat::IDENTITY
        .slerp(Quat::from_euler(EulerRot::ZXY, 80f32.to_radians(), 60f32.to_radians(), 0.0), 0.5);
    let row = motion.row(5).unwrap();
    let there = Quat::from_euler(EulerRot::ZXY, row[1].to_radians(), row[2].to_radians(), 0.0);
    assert_eq!(row[0], 0.5);
    assert!(angle_between(half, there) < 15.0 && row[1] > 30.0 && row[2] > 20.0, "{row:?}");
}
