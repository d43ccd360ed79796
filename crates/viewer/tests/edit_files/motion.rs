//! The motions that are written.

use inbetween::InbetweenClip;
use reduction::Errors;
use skeleton::{Clip, Pose, PositionChannels, Representation, pose_frame};

use super::*;

#[test]
fn the_file_holds_every_frame_keeps_the_keyframes_and_poses_as_the_interpolation_does() {
    let folder = Folder::new();
    for name in ["dance.bvh", "arm.bvh"] {
        for (mode, representation) in ["euler", "quaternion"].into_iter().zip(Representation::ALL) {
            let out = folder.text(&format!("{mode} {name}"));
            let (said, complaints) =
                run(&[&data(name), "--out", &out, "--mode", mode, "--keyframes", "15"]).unwrap();
            assert_eq!(complaints, "");
            let (original, written) = (read(data(name)), read(&out));
            assert_eq!(written.skeleton(), original.skeleton());
            let of = |motion: &Motion| (motion.frame_count(), motion.frame_time());
            assert_eq!(of(&written), of(&original));

            let keyframes = keyframes(&said);
            assert_eq!(keyframes.len(), 15);
            let errors = Errors::new(original.skeleton(), &frames(&original), representation);
            assert_eq!(keyframes, reduction::greedy(&errors, 15));
            let error = errors.of_keyframes(&keyframes);
            assert!((number(&said, "accumulated error") - error).abs() < 1e-3 * error, "{said}");
            let places = (original.frame_count() * errors.clip().tips(0).len()) as f64;
            assert!((number(&said, "RMS distance") - (error / places).sqrt()).abs() < 1e-3, "{said}");
            assert_poses(&original, &written, errors.clip(), &keyframes);
        }
    }
}

fn assert_poses(original: &Motion, written: &Motion, clip: &InbetweenClip, keyframes: &[usize]) {
    let (mut found, mut expected) = (Pose::default(), Pose::default());
    for gap in keyframes.windows(2) {
        assert_eq!(written.row(gap[0]), original.row(gap[0]));
        assert_eq!(written.row(gap[1]), original.row(gap[1]));
        for frame in gap[0]..gap[1] {
            pose_frame(written.skeleton(), &written.frame(frame), &solutions::FK, &mut found);
            clip.between(gap[0], gap[1], frame, &mut expected);
            for (found, expected) in found.transforms().iter().zip(expected.transforms()) {
                let off = found.position.distance(expected.position);
                assert!(off < 1e-4 * original.skeleton().extent(), "frame {frame} is off by {off}");
            }
        }
    }
}

#[test]
fn better_methods_leave_smaller_errors() {
    let folder = Folder::new();
    let out = folder.text("keys.bvh");
    let mut errors = Vec::new();
    for (method, name) in [
        ("optimum", "optimum"),
        ("moves", "greedy, then moved"),
        ("greedy", "greedy"),
        ("even", "evenly spaced"),
    ] {
        let wanted = ["--out", &out, "--method", method, "--keyframes", "12", "--overwrite"];
        let (said, _) = run(&[&[&*data("dance.bvh")], &wanted[..]].concat()).unwrap();
        assert_eq!(fact(&said, "chosen"), name);
        assert_eq!(keyframes(&said).len(), 12);
        errors.push(number(&said, "accumulated error"));
    }
    assert!(errors.is_sorted(), "{errors:?}");
    let (said, _) = run(&[&data("dance.bvh"), "--out", &out, "--overwrite"]).unwrap();
    assert_eq!(
        (fact(&said, "chosen"), fact(&said, "interpolated"), keyframes(&said).len()),
        ("greedy", "quaternions", 20)
    );
}

#[test]
fn position_channels_can_be_added_to_the_offsets() {
    let folder = Folder::new();
    let (file, out) = (folder.text("arm.bvh"), folder.text("out.bvh"));
    fs::write(&file, arm(9)).unwrap();
    let mut errors = Vec::new();
    for positions in ["replace", "add"] {
        let (said, _) = run(&[
            &file,
            "--out",
            &out,
            "--mode",
            "euler",
            "--keyframes",
            "4",
            "--overwrite",
            "--positions",
            positions,
        ])
        .unwrap();
        let positions = match positions {
            "add" => PositionChannels::Add,
            _ => PositionChannels::Replace,
        };
        let motion = read(&file);
        let frame = |index| {
            let mut frame = Frame::default();
            motion.read_frame(index, positions, &mut frame);
            frame
        };
        let frames: Vec<Frame> = (0..9).map(frame).collect();
        let expected = Errors::new(motion.skeleton(), &frames, Representation::Euler);
        let error = number(&said, "accumulated error");
        let expected = expected.of_keyframes(&keyframes(&said));
        assert!((error - expected).abs() < 1e-3 * expected, "{said}");
        errors.push(error);
    }
    assert!(errors[0] != errors[1], "{errors:?}");
}

#[test]
fn rotations_that_channels_cannot_hold_are_told() {
    let folder = Folder::new();
    let (file, out) = (folder.text("arm.bvh"), folder.text("out.bvh"));
    fs::write(&file, arm(9).replace("3 Zrotation Xrotation Yrotation", "3 Yposition Xrotation Zrotation"))
        .unwrap();
    let (_, complaints) = run(&[&file, "--out", &out, "--keyframes", "2"]).unwrap();
    assert!(complaints.starts_with("arm.bvh: r has 2 rotation channels"), "{complaints}");
    assert!(complaints.contains("degrees (frame ") && complaints.lines().count() == 1, "{complaints}");
    let (_, complaints) =
        run(&[&file, "--out", &out, "--keyframes", "2", "--mode", "euler", "--overwrite"]).unwrap();
    assert_eq!(complaints, "");
}
