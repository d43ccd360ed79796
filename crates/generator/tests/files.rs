//! The files in `data/`: the same bytes every time, readable, and with the right positions beside them.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use skeleton::{Pose, PositionChannels, pose_frame};

fn files() -> HashMap<String, Vec<u8>> {
    let files = generator::data_files().expect("the files");
    files.into_iter().map(|file| (file.name, file.contents)).collect()
}

fn data(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_files_in_data_are_those_that_the_generator_makes() {
    let files = files();
    assert_eq!(files.len(), 9);
    for (name, contents) in files {
        assert!(data(&name) == contents, "data/{name} differs: run `cargo motions`");
    }
}

#[test]
fn the_command_writes_the_same_bytes_into_any_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("new folder");
    let run = Command::new(env!("CARGO_BIN_EXE_motions")).arg("--out").arg(&out).output().expect("it starts");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    for (name, contents) in files() {
        assert!(std::fs::read(out.join(&name)).expect(&name) == contents, "{name}");
    }
}

#[test]
fn the_command_says_where_it_cannot_write() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("a file");
    std::fs::write(&out, "in the way").expect("a file");
    let run = Command::new(env!("CARGO_BIN_EXE_motions")).arg("--out").arg(&out).output().expect("it starts");
    assert!(!run.status.success());
    let message = String::from_utf8_lossy(&run.stderr);
    assert!(message.contains("error: ") && message.contains("a file"), "{message}");
    assert_eq!(std::fs::read(&out).expect("still there"), b"in the way");
}

#[test]
fn every_motion_is_read_back_as_it_was() {
    for (name, motion) in [
        ("running.bvh", generator::running()),
        ("dance.bvh", generator::dance()),
        ("arm.bvh", generator::arm()),
    ] {
        let reading = parser::bvh::read(&data(name)[..]).expect(name);
        assert!(reading.warnings.is_empty(), "{name}: {:?}", reading.warnings);
        assert!(reading.motion == motion.expect(name), "{name}");
    }
}

#[test]
fn the_walk_is_read_back_as_it_was() {
    let walk = generator::walking().expect("the walk");
    let skeleton = parser::acclaim::read_skeleton(&data("walk.asf")[..]).expect("walk.asf");
    assert_eq!((&skeleton.skeleton, &skeleton.warnings[..]), (walk.skeleton(), &[][..]));
    let motion = parser::acclaim::read_motion(&data("walk.amc")[..], &skeleton.skeleton).expect("walk.amc");
    assert_eq!((motion.motion == walk, &motion.warnings[..]), (true, &[][..]));
}

/// The positions of the walk as joints come from quaternions in single precision, which share no code with the matrices.
#[test]
fn the_expected_positions_of_the_walk_are_those_of_the_reference_solution() {
    let walk = generator::walking().expect("the walk");
    let joints = parser::acclaim::to_joints(&walk, 1.0 / 120.0).expect("joints");
    let expected: Value = serde_json::from_slice(&data("walk.amc.expected.json")).expect("JSON");
    assert_eq!((&expected["asf"], &expected["amc"]), (&Value::from("walk.asf"), &Value::from("walk.amc")));
    assert_eq!(expected["frames_total"], walk.frame_count());
    let bones: Vec<&str> = walk.skeleton().bones().iter().map(|bone| bone.name.as_str()).collect();
    assert_eq!(expected["bones"], Value::from(bones));
    let frames = expected["frames"].as_array().expect("frames");
    let indices: Vec<u64> = frames.iter().map(|frame| frame["frame"].as_u64().expect("an index")).collect();
    assert_eq!(indices, [0, 240, 479]);
    let mut pose = Pose::default();
    for known in frames {
        let index = known["frame"].as_u64().expect("an index") as usize;
        assert_eq!(known["frame_number_in_file"], index + 1);
        pose_frame(joints.skeleton(), &joints.frame(index), &solutions::FK, &mut pose);
        for bone in walk.skeleton().bones() {
            let named = |joint: &&skeleton::Joint| joint.name == bone.name && !joint.is_end_site;
            let joint = joints.skeleton().joints().iter().find(named).expect("a joint");
            let hung = joints.skeleton().joints().iter().find(|hung| hung.parent == Some(joint.id));
            for (key, joint) in [("start", Some(joint)), ("end", hung)] {
                let known = glam::Vec3::from_array(numbers(&known[key][bone.id.0]));
                let found = pose[joint.expect("a joint").id].position;
                assert!(found.distance(known) < 1e-5 * walk.skeleton().extent(), "{} {key}", bone.name);
            }
        }
    }
}

/// The expected positions come from matrices in double precision; the reference solution uses quaternions in single
/// precision. They share no code and must agree.
#[test]
fn the_expected_positions_are_those_of_the_reference_solution() {
    for name in ["running.bvh", "dance.bvh", "arm.bvh"] {
        let motion = parser::bvh::read(&data(name)[..]).expect(name).motion;
        let expected: Value = serde_json::from_slice(&data(&format!("{name}.expected.json"))).expect(name);
        let tolerance = 1e-5 * motion.skeleton().extent();
        let mut frame = skeleton::Frame::default();
        let mut pose = Pose::default();
        let frames = expected["frames"].as_array().expect("frames");
        assert_eq!(frames.len(), 3);
        for known in frames {
            let index = known["frame"].as_u64().expect("an index") as usize;
            for (key, channels) in
                [("positions", PositionChannels::Replace), ("positions_add", PositionChannels::Add)]
            {
                let Some(positions) = known.get(key).and_then(Value::as_array) else {
                    assert_eq!(key, "positions_add", "{name}");
                    continue;
                };
                motion.read_frame(index, channels, &mut frame);
                pose_frame(motion.skeleton(), &frame, &solutions::FK, &mut pose);
                assert_eq!(positions.len(), pose.len());
                let quaternions = known["global_quat_wxyz"].as_array().expect("quaternions");
                for ((transform, position), quaternion) in
                    pose.transforms().iter().zip(positions).zip(quaternions)
                {
                    let [x, y, z] = numbers(position);
                    let distance = transform.position.distance(glam::Vec3::new(x, y, z));
                    assert!(distance <= tolerance, "{name}, frame {index}, {key}: {distance}");
                    let [w, x, y, z] = numbers(quaternion);
                    let angle = transform.rotation.angle_between(glam::Quat::from_xyzw(x, y, z, w));
                    assert!(angle < 0.002, "{name}, frame {index}: {angle}");
                }
            }
        }
    }
}

fn numbers<const N: usize>(list: &Value) -> [f32; N] {
    let list = list.as_array().expect("a list");
    assert_eq!(list.len(), N);
    std::array::from_fn(|n| list[n].as_f64().expect("a number") as f32)
}

#[test]
fn the_expected_files_describe_their_motion() {
    for (name, added) in [("running.bvh", false), ("dance.bvh", false), ("arm.bvh", true)] {
        let expected: Value = serde_json::from_slice(&data(&format!("{name}.expected.json"))).expect(name);
        let text = String::from_utf8(data(name)).expect("text");
        let motion = parser::bvh::read(text.as_bytes()).expect(name).motion;
        assert_eq!(expected["file"], name);
        for key in ["frames_declared", "frames_used"] {
            assert_eq!(expected[key], motion.frame_count());
        }
        assert_eq!(expected["channels_per_frame"], motion.skeleton().channel_count());
        let frame_time = expected["frame_time"].as_str().expect("text");
        assert!(!frame_time.is_empty() && text.contains(&format!("\nFrame Time: {frame_time}\n")));
        let frames: Vec<&Value> = expected["frames"].as_array().expect("frames").iter().collect();
        let indices: Vec<usize> =
            frames.iter().map(|f| f["frame"].as_u64().expect("an index") as usize).collect();
        assert_eq!(indices, [0, motion.frame_count() / 2, motion.frame_count() - 1]);
        assert!(frames.iter().all(|frame| frame.get("positions_add").is_some() == added), "{name}");
        let nodes = expected["nodes"].as_array().expect("nodes");
        assert_eq!(nodes.len(), motion.skeleton().len());
        for (node, joint) in nodes.iter().zip(motion.skeleton().joints()) {
            assert_eq!(node["index"], joint.id.0);
            assert_eq!(node["parent"], joint.parent.map_or(-1, |parent| parent.0 as i64));
            assert_eq!(node["kind"] == "end", joint.is_end_site);
            assert_eq!(node["kind"] == "root", joint.is_root());
            assert_eq!(node["name"], if joint.is_end_site { "" } else { &joint.name });
        }
    }
}
