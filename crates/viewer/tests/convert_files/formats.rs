//! From one format to the other.

use super::*;

/// Sees to it that the joints of `motion` are where the bones of `bones` are, in all frames.
fn assert_same(bones: &skeleton::acclaim::Motion, motion: &Motion) {
    assert_eq!(motion.frame_count(), bones.frame_count());
    let extent = motion.skeleton().extent();
    for frame in 0..motion.frame_count() {
        let places = places(bones.skeleton(), &bones.posture(frame));
        let pose = pose(motion, frame);
        for (joint, transform) in motion.skeleton().joints().iter().zip(pose.transforms()) {
            let place = match joint.parent {
                Some(parent) if joint.is_end_site => {
                    let bone = &motion.skeleton().joints()[parent.0].name;
                    places[bones.skeleton().find(bone).unwrap().id.0].end
                }
                _ => places[bones.skeleton().find(&joint.name).unwrap().id.0].start,
            };
            let off = place.distance(transform.position);
            assert!(off < 1e-4 * extent, "{} in frame {frame} is off by {off}", joint.name);
        }
    }
}

#[test]
fn from_acclaim_to_bvh_every_joint_is_where_its_bone_starts() {
    let folder = Folder::new();
    let out = folder.text("walk as joints.bvh");
    let (said, complaints) = run(&[&data("walk.asf"), &data("walk.amc"), "--out", &out]).unwrap();
    assert!(complaints.is_empty() && said.starts_with(&format!("{out}: 480 frames, 31 joints\n")), "{said}");
    assert_same(&read_bones(data("walk.amc")), &read(&out));
    assert!((read(&out).frame_time() - 1.0 / 120.0).abs() < 1e-9);

    let odd = odd_files(&folder, 12);
    run(&[&odd, "--out", &out, "--overwrite", "--rate", "25"]).unwrap();
    assert_same(&read_bones(&odd), &read(&out));
    assert_eq!(read(&out).frame_time(), 0.04);
}

#[test]
fn from_bvh_to_acclaim_and_back_nothing_moves() {
    let folder = Folder::new();
    for name in ["running.bvh", "dance.bvh"] {
        let original = read(data(name));
        let (amc, back) = (folder.text("as bones.amc"), folder.text("and back.bvh"));
        let (said, complaints) = run(&[&data(name), "--out", &amc, "--overwrite"]).unwrap();
        assert!(
            complaints.is_empty()
                && said.contains(&format!("skeleton           {}", folder.text("as bones.asf")))
        );
        // What gives the frame time back is told last.
        let rate = said.rsplit("--rate ").next().unwrap().split(' ').next().unwrap();
        assert_same(
            &read_bones(&amc),
            &read({
                run(&[&amc, "--out", &back, "--overwrite", "--rate", rate]).unwrap();
                &back
            }),
        );
        let again = read(&back);
        assert_eq!(again.frame_count(), original.frame_count());
        assert_eq!(again.frame_time(), original.frame_time(), "{rate}");
        assert_every_joint_is_there(&original, &again);
    }
}

/// Sees to it that every joint and every End Site of `original` is one of `again`, and in the same places.
fn assert_every_joint_is_there(original: &Motion, again: &Motion) {
    let extent = original.skeleton().extent();
    let tips = |motion: &Motion, pose: &Pose| -> Vec<Vec3> {
        let joints = motion.skeleton().joints().iter().zip(pose.transforms());
        joints.filter(|(joint, _)| joint.is_end_site).map(|(_, transform)| transform.position).collect()
    };
    for frame in 0..original.frame_count() {
        let (then, now) = (pose(original, frame), pose(again, frame));
        for (joint, transform) in original.skeleton().joints().iter().zip(then.transforms()) {
            if joint.is_end_site {
                let nearest = tips(again, &now).into_iter().map(|tip| tip.distance(transform.position));
                assert!(nearest.fold(f32::INFINITY, f32::min) < 1e-4 * extent, "frame {frame}");
                continue;
            }
            let name = if joint.is_root() { "root" } else { &joint.name };
            let other = again.skeleton().joints().iter().position(|other| other.name == name).unwrap();
            let off = now.transforms()[other].position.distance(transform.position);
            assert!(off < 1e-4 * extent, "{} in frame {frame} is off by {off}", joint.name);
        }
    }
}

#[test]
fn a_skeleton_is_written_alone_from_every_format() {
    let folder = Folder::new();
    let out = folder.text("bones.asf");
    for (file, bones) in [("walk.asf", 30), ("walk.amc", 30), ("running.bvh", 37)] {
        let (said, _) = run(&[&data(file), "--out", &out, "--overwrite"]).unwrap();
        assert!(said.starts_with(&format!("{out}: {bones} bones\n")), "{said}");
        let skeleton = acclaim::read_skeleton_file(&out).unwrap().skeleton;
        assert_eq!(skeleton.len(), bones + 1);
    }
    assert_eq!(folder.names(), ["bones.asf"]);
    let walk = acclaim::read_skeleton_file(data("walk.asf")).unwrap().skeleton;
    run(&[&data("walk.asf"), "--out", &out, "--overwrite"]).unwrap();
    assert_eq!(acclaim::read_skeleton_file(&out).unwrap().skeleton, walk);
    // And its rest pose as joints.
    let rest = folder.text("rest.bvh");
    let (said, _) = run(&[&data("walk.asf"), "--out", &rest]).unwrap();
    assert!(said.starts_with(&format!("{rest}: 0 frames, 31 joints\n")), "{said}");
}

#[test]
fn an_acclaim_motion_written_again_holds_the_same() {
    let folder = Folder::new();
    let out = folder.text("again.AMC");
    run(&[&data("walk.amc"), "--out", &out]).unwrap();
    assert_eq!(read_bones(&out), read_bones(data("walk.amc")));
    assert_eq!(folder.names(), ["again.AMC", "again.asf"]);
}

#[test]
fn a_motion_is_reduced_where_keyframes_are_spoken_of_and_not_elsewhere() {
    let folder = Folder::new();
    let (joints, bones) = (folder.text("keys.bvh"), folder.text("keys.amc"));
    let walk = data("walk.amc");
    let (said, _) = run(&[&walk, "--out", &joints, "--keyframes", "6"]).unwrap();
    assert!(said.contains("480 frames, 6 keyframes"), "{said}");
    let (said, _) = run(&[&walk, "--out", &bones, "--method", "even"]).unwrap();
    assert!(said.contains("480 frames, 20 keyframes") && said.contains("--rate 120"), "{said}");
    assert_eq!(read_bones(&bones).frame_count(), 480);
    let (said, _) = run(&[&data("dance.bvh"), "--out", &joints, "--overwrite"]).unwrap();
    assert!(said.contains("20 keyframes"), "{said}");
    let (said, _) = run(&[&data("dance.bvh"), "--out", &bones, "--overwrite"]).unwrap();
    assert!(!said.contains("keyframes"), "{said}");

    // What is between keyframes is the same in both formats.
    let wanted = ["--keyframes", "6", "--overwrite"];
    run(&[&[&*data("dance.bvh"), "--out", &joints], &wanted[..]].concat()).unwrap();
    run(&[&[&*data("dance.bvh"), "--out", &bones], &wanted[..]].concat()).unwrap();
    let back = folder.text("back.bvh");
    run(&[&bones, "--out", &back]).unwrap();
    assert_every_joint_is_there(&read(&joints), &read(&back));
}

#[test]
fn a_file_whose_offsets_are_all_zero_says_with_its_channels_how_large_it_is() {
    let folder = Folder::new();
    let (file, out) = (folder.text("no offsets.bvh"), folder.text("moved.amc"));
    let channels = "OFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition";
    let write = |second: f32| {
        let text = format!(
            "HIERARCHY\nROOT r\n{{\n{channels}\nJOINT j\n{{\n{channels}\n}}\n}}\n\
             MOTION\nFrames: 2\nFrame Time: 0.5\n0 0 0 10 20 30\n0 0 0 {second} 20 30\n"
        );
        fs::write(&file, text).unwrap();
    };
    // A rounding error is no motion.
    write(10.000_01);
    run(&[&file, "--out", &out]).unwrap();
    let bones = read_bones(&out);
    let places = places(bones.skeleton(), &bones.posture(1));
    assert!(places.iter().any(|place| place.end.distance(Vec3::new(10.0, 20.0, 30.0)) < 1e-3));
    write(10.1);
    assert!(run(&[&file, "--out", &out, "--overwrite"]).unwrap_err().contains("in frame 2"));
}

#[test]
fn position_channels_that_are_added_are_added_in_bones_too() {
    let folder = Folder::new();
    let (file, out) = (folder.text("moved.bvh"), folder.text("moved.amc"));
    let text = "HIERARCHY\nROOT r\n{\nOFFSET 1 2 3\nCHANNELS 3 Xposition Yposition Zrotation\nEnd Site\n{\nOFFSET 0 5 0\n}\n}\n\
                MOTION\nFrames: 1\nFrame Time: 0.5\n10 20 30\n";
    fs::write(&file, text).unwrap();
    for (positions, root) in [("replace", Vec3::new(10.0, 20.0, 3.0)), ("add", Vec3::new(11.0, 22.0, 3.0))] {
        run(&[&file, "--out", &out, "--overwrite", "--positions", positions]).unwrap();
        assert_eq!(read_bones(&out).posture(0).translations[0], root, "{positions}");
    }
    let (said, _) = run(&[&file, "--out", &out, "--overwrite"]).unwrap();
    assert!(said.contains("1 frame, 1 bone\n") && said.contains("--rate 2 when"), "{said}");
}
