//! Where a motion stands still.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use glam::Vec3;
use inbetween::{InbetweenClip, Scratch};
use skeleton::{Axis, Channel, Clip, Frame, Pose, Representation, Skeleton};

#[test]
fn frames_that_are_the_same_stand_still() {
    for clip in both(&angles(&[30.0, 30.0, 30.0, 40.0, 40.0, 30.0])) {
        assert!(clip.is_still(0, 2) && clip.is_still(1, 2) && clip.is_still(3, 4) && clip.is_still(5, 5));
        // What comes back to where it was has moved.
        assert!(!clip.is_still(2, 3) && !clip.is_still(0, 5) && !clip.is_still(4, 5));
    }
}

#[test]
fn the_last_digit_of_an_angle_is_no_movement() {
    let just_below = 360.0_f32.next_down();
    assert_eq!(just_below, 359.999_97);
    for clip in both(&angles(&[0.0, just_below, 360.0, -1e-6, 0.0, -360.0, 720.0_f32.next_up()])) {
        assert!(clip.is_still(0, 6));
    }
    for clip in both(&angles(&[0.0, 0.001, 0.0])) {
        assert!(!clip.is_still(0, 1) && !clip.is_still(1, 2) && !clip.is_still(0, 2));
    }
}

#[test]
fn all_frames_are_as_the_first_one_and_not_only_as_the_one_before() {
    let slow: Vec<f32> = (0..100).map(|frame| frame as f32 * 0.000_05).collect();
    for clip in both(&angles(&slow)) {
        assert!(clip.is_still(0, 1) && clip.is_still(50, 51));
        assert!(!clip.is_still(0, 20));
        let stretches = (1..100).filter(|frame| !clip.is_still(frame - 1, *frame)).count();
        assert!((8..30).contains(&stretches), "{stretches}");
    }
}

/// At a quarter turn about Y the angles about X and Z turn about the same axis.
#[test]
fn what_stands_still_depends_on_what_is_interpolated() {
    let frame = |angles: [f32; 3]| Frame { angles: angles.to_vec(), local_positions: vec![Vec3::ZERO; 2] };
    let [angles, rotations] = both(&[frame([0.0, 180.0, 0.0]), frame([180.0, 0.0, 180.0])]);
    assert!(!angles.is_still(0, 1));
    assert!(rotations.is_still(0, 1));
}

#[test]
fn a_position_may_be_off_by_a_millionth_of_the_skeleton_or_by_its_last_digits() {
    let still = |from: f32, to: f32| {
        let frame =
            |x| Frame { angles: vec![0.0; 3], local_positions: vec![Vec3::new(x, 0.0, 0.0), Vec3::Y] };
        both(&[frame(from), frame(to)]).map(|clip| clip.is_still(0, 1))
    };
    // The skeleton is 100 long.
    assert_eq!(still(0.0, 0.000_09), [true; 2]);
    assert_eq!(still(0.0, 0.000_11), [false; 2]);
    let far = 1e6_f32;
    assert_eq!(still(far, far.next_up().next_up()), [true; 2]);
    assert_eq!(still(far, far + 1.0), [false; 2]);
    assert_eq!(still(-0.0, 0.0), [true; 2]);
}

#[test]
fn numbers_that_are_none_stand_still_only_when_they_stay_the_same() {
    for odd in [f32::NAN, f32::INFINITY, f32::MAX] {
        for clip in both(&angles(&[odd, odd, 0.0, 90.0])) {
            assert!(clip.is_still(0, 1));
            assert!(!clip.is_still(2, 3));
        }
        let frame = |x| Frame { angles: vec![0.0; 3], local_positions: vec![Vec3::splat(x); 2] };
        for clip in both(&[frame(odd), frame(odd), frame(0.0), frame(1.0)]) {
            assert!(clip.is_still(0, 1));
            assert!(!clip.is_still(1, 2) && !clip.is_still(2, 3));
        }
    }
    let mut endless = Skeleton::new();
    let root = endless.add_joint(None, "root", Vec3::ZERO, [Channel::Position(Axis::X)]).unwrap();
    endless.add_end_site(root, "End Site", Vec3::splat(f32::INFINITY)).unwrap();
    assert_eq!(endless.extent(), f32::INFINITY);
    let frame = |x| Frame { angles: vec![], local_positions: vec![Vec3::new(x, 0.0, 0.0); 2] };
    assert!(!InbetweenClip::new(&endless, &[frame(0.0), frame(1.0)], Representation::Euler).is_still(0, 1));
}

#[test]
fn what_stands_still_is_given_as_it_is() {
    let noisy: Vec<f32> =
        (0..50).map(|frame| if frame % 3 == 0 { 360.0_f32.next_down() } else { 0.0 }).collect();
    for clip in both(&angles(&noisy)) {
        let (mut original, mut pose) = (Pose::default(), Pose::default());
        for frame in 0..50 {
            clip.original(frame, &mut original);
            clip.between(0, 49, frame, &mut pose);
            assert_eq!(original, pose);
            assert_eq!(clip.tips(frame), clip.tips_between(0, 49, frame, &mut Scratch::default()));
            assert_eq!(clip.local(frame), clip.local_between(0, 49, frame));
        }
    }
}

/// One clip for each representation.
fn both(frames: &[Frame]) -> [InbetweenClip; 2] {
    let mut skeleton = Skeleton::new();
    let channels = [Axis::X, Axis::Y, Axis::Z].map(Channel::Rotation).to_vec();
    let root = skeleton.add_joint(None, "root", Vec3::ZERO, channels).unwrap();
    skeleton.add_end_site(root, "End Site", Vec3::new(0.0, 100.0, 0.0)).unwrap();
    Representation::ALL.map(|representation| InbetweenClip::new(&skeleton, frames, representation))
}

/// Frames with this angle about Y.
fn angles(angles: &[f32]) -> Vec<Frame> {
    let frame =
        |angle: &f32| Frame { angles: vec![0.0, *angle, 0.0], local_positions: vec![Vec3::ZERO, Vec3::Y] };
    angles.iter().map(frame).collect()
}
