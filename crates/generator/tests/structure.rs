//! What each motion is for: its joints, orders, channels and frames.

mod common;

use std::collections::HashSet;

use common::{Paths, differences, highest, lowest};
use glam::DVec3;
use skeleton::{Axis, Channel, Motion, RotationOrder};

fn joints(motion: &Motion) -> usize {
    motion.skeleton().joints().iter().filter(|joint| !joint.is_end_site).count()
}

fn orders(motion: &Motion) -> HashSet<RotationOrder> {
    let orders = motion.skeleton().joints().iter().map(|joint| joint.rotation_order);
    orders.filter(|order| *order != RotationOrder::None).collect()
}

/// The names of the joints with position channels.
fn moving(motion: &Motion) -> Vec<&str> {
    let moves = |channel: &Channel| matches!(channel, Channel::Position(_));
    let joints = motion.skeleton().joints().iter();
    joints.filter(|joint| joint.channels.iter().any(moves)).map(|joint| joint.name.as_str()).collect()
}

#[test]
fn the_run_has_1377_frames_of_a_humanoid_in_one_order() {
    let motion = generator::running().expect("the run");
    assert_eq!(motion.frame_count(), 1377);
    assert_eq!(motion.frame_time(), 0.008333);
    assert!((25..=31).contains(&joints(&motion)), "{}", joints(&motion));
    assert_eq!(orders(&motion), HashSet::from([RotationOrder::Xyz]));
    assert_eq!(moving(&motion), ["Hips"]);
    let root = &motion.skeleton().joints()[0];
    let positions = Axis::ALL.map(Channel::Position);
    let rotations = Axis::ALL.map(Channel::Rotation);
    assert_eq!(root.channels, [positions, rotations].concat());
}

#[test]
fn the_humanoid_is_175_cm_tall_and_its_halves_mirror_each_other() {
    let motion = generator::running().expect("the run");
    let (skeleton, places) = (motion.skeleton(), motion.skeleton().rest_positions());
    let place =
        |name: &str| places[skeleton.joints().iter().position(|joint| joint.name == name).expect(name)];
    for joint in skeleton.joints().iter().filter(|joint| joint.name.starts_with("Left")) {
        let (left, right) = (place(&joint.name), place(&joint.name.replace("Left", "Right")));
        assert_eq!([left.x, left.y, left.z], [-right.x, right.y, right.z], "{}", joint.name);
    }
    let sole = place("LeftFoot").y - 6.8;
    let top = places.iter().map(|place| place.y).fold(0.0, f32::max);
    assert!((top - sole - 175.0).abs() < 1.5, "{}", top - sole);
}

#[test]
fn the_dance_mixes_all_orders() {
    let motion = generator::dance().expect("the dance");
    assert_eq!(motion.frame_count(), 141);
    assert_eq!(orders(&motion).len(), 6);
    assert!((25..=31).contains(&joints(&motion)));
}

#[test]
fn the_dance_turns_on_past_full_turns_and_one_arm_is_stored_wrapped() {
    let dance = Paths::new(generator::dance().expect("the dance"));
    let yaw = dance.channel("Hips", Channel::Rotation(Axis::Y));
    assert!(highest(&yaw) > 700.0);
    assert!(differences(&yaw).iter().all(|step| step.abs() < 40.0));
    let left = dance.channel("LeftArm", Channel::Rotation(Axis::X));
    assert!(lowest(&left) < -360.0);
    assert!(differences(&left).iter().all(|step| step.abs() < 40.0));
    let right = dance.channel("RightArm", Channel::Rotation(Axis::Z));
    assert!(right.iter().all(|angle| angle.abs() <= 180.0));
    assert!(differences(&right).iter().any(|step| step.abs() > 300.0), "no jump where it passes 180 degrees");
    // All other joints go on smoothly.
    for joint in dance.motion.skeleton().joints().iter().filter(|joint| joint.name != "RightArm") {
        for channel in &joint.channels {
            let steps = differences(&dance.channel(&joint.name, *channel));
            assert!(steps.iter().all(|step| step.abs() < 45.0), "{} {channel}", joint.name);
        }
    }
}

#[test]
fn the_dancer_turns_on_one_spot_and_never_sinks() {
    let dance = Paths::new(generator::dance().expect("the dance"));
    for side in ["Left", "Right"] {
        let lowest = lowest(&dance.sole_heights(side));
        assert!(lowest > -1.0, "{side}: {lowest} cm");
    }
    // The pirouette: from the rise to the landing.
    let ball = dance.path("RightToeBase");
    assert!(ball[24..70].iter().all(|place| place.distance(ball[24]) < 0.1));
    // No knee bends the wrong way.
    for side in ["LeftLeg", "RightLeg"] {
        assert!(lowest(&dance.channel(side, Channel::Rotation(Axis::X))) > 0.0, "{side}");
    }
}

#[test]
fn the_arm_uses_all_orders_and_has_joints_that_slide() {
    let motion = generator::arm().expect("the arm");
    assert_eq!(orders(&motion).len(), 6);
    assert_eq!(moving(&motion), ["Pedestal", "Slide", "LeftFinger", "RightFinger"]);
    let slide = &motion.skeleton().joints()[1];
    assert_eq!(slide.channels, [Channel::Position(Axis::Z)]);
    assert_eq!(slide.rotation_order, RotationOrder::None);
    assert!(slide.offset.z != 0.0, "replacing and adding must differ");
}

#[test]
fn the_arm_reaches_what_it_picks_and_where_it_places() {
    let arm = Paths::new(generator::arm().expect("the arm"));
    let tips = ["LeftFinger", "RightFinger"].map(|finger| arm.path_of(finger, DVec3::new(0.0, 8.0, 0.0)));
    let middle: Vec<DVec3> = tips[0].iter().zip(&tips[1]).map(|(a, b)| (*a + *b) / 2.0).collect();
    let gap: Vec<f64> = tips[0].iter().zip(&tips[1]).map(|(a, b)| a.distance(*b)).collect();
    // Frames of 1/60 s: the gripper closes at 1.9 s and opens at 4.9 s. In between it holds the part.
    let held = gap[150];
    assert!(highest(&gap[70..95]) > held + 2.0, "it opens before it takes");
    assert!(gap[120..284].iter().all(|gap| (gap - held).abs() < 0.2), "it holds on");
    assert!(highest(&gap[305..315]) > held + 2.0, "it lets go");
    assert!((middle[110].y - 6.0).abs() < 0.1, "{}", middle[110].y);
    assert!(middle[290].distance(middle[110]) > 90.0, "the part travels");
    assert!(middle.iter().all(|place| place.y > 5.0), "above the table");
    let screw = arm.channel("Gripper", Channel::Rotation(Axis::Y));
    assert!(highest(&screw) > 540.0);
}
