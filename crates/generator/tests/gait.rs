//! Does `running.bvh` run like a human? Bounds are those of the literature on gait, a little widened.

mod common;

use std::sync::LazyLock;

use common::{Paths, correlation, deviation, differences, highest, lowest, mean, spans};
use glam::DVec3;
use skeleton::{Axis, Channel};

const SIDES: [&str; 2] = ["Left", "Right"];

/// Made once for all tests.
static RUN: LazyLock<Paths> = LazyLock::new(|| Paths::new(generator::running().expect("the run")));

/// The frames in which a foot is on the ground: (first, one behind the last). Contacts cut off by the ends do not
/// count.
fn contacts(run: &Paths, side: &str) -> Vec<(usize, usize)> {
    let on_ground: Vec<bool> = run.sole_heights(side).iter().map(|height| *height < 0.3).collect();
    let whole = |span: &(usize, usize)| span.0 > 0 && span.1 < on_ground.len();
    spans(&on_ground).into_iter().filter(whole).collect()
}

/// The unit vectors in which the body travels: along the way of the hips over a fifth of a second before and after.
fn forward(run: &Paths) -> Vec<DVec3> {
    let hips = run.path("Hips");
    let last = hips.len() - 1;
    let ahead = |frame: usize| {
        (hips[(frame + 24).min(last)] - hips[frame.saturating_sub(24)]) * DVec3::new(1.0, 0.0, 1.0)
    };
    run.frames().map(|frame| ahead(frame).normalize()).collect()
}

/// How far one joint is in front of another, in cm.
fn ahead(run: &Paths, joint: &str, of: &str) -> Vec<f64> {
    let (joint, of) = (run.path(joint), run.path(of));
    forward(run).iter().enumerate().map(|(frame, forward)| (joint[frame] - of[frame]).dot(*forward)).collect()
}

/// The bend of a hinge in degrees: 0 is straight.
fn bend(run: &Paths, joints: [&str; 3]) -> Vec<f64> {
    let [a, b, c] = joints.map(|joint| run.path(joint));
    run.frames().map(|f| (b[f] - a[f]).angle_between(c[f] - b[f]).to_degrees()).collect()
}

#[test]
fn a_foot_on_the_ground_stays_where_it_is() {
    let run = &*RUN;
    for side in SIDES {
        let ball = run.path(&format!("{side}ToeBase"));
        let contacts = contacts(run, side);
        assert!(contacts.len() >= 14, "{side}: {contacts:?}");
        for (first, behind) in contacts {
            let slide = ball[first..behind].iter().map(|place| {
                let way = *place - ball[(first + behind) / 2];
                way.x.hypot(way.z)
            });
            let slide = highest(&slide.collect::<Vec<f64>>());
            assert!(slide < 1.5, "{side} slides by {slide} cm in the frames {first} to {behind}");
        }
    }
}

#[test]
fn no_foot_sinks_into_the_ground() {
    let run = &*RUN;
    for side in SIDES {
        let lowest = lowest(&run.sole_heights(side));
        assert!(lowest > -0.5, "{side}: {lowest} cm");
    }
}

#[test]
fn every_stride_has_two_flights_and_a_foot_stands_for_about_a_third_of_it() {
    let run = &*RUN;
    let [left, right] = SIDES.map(|side| contacts(run, side));
    let mut steps: Vec<(usize, usize)> = left.iter().chain(&right).copied().collect();
    steps.sort_unstable();
    for pair in steps.windows(2) {
        let flight = pair[1].0 as f64 - pair[0].1 as f64;
        assert!(flight * run.frame_time() > 0.04, "no flight between {:?} and {:?}", pair[0], pair[1]);
    }
    for foot in [&left, &right] {
        for pair in foot.windows(2) {
            let stride = (pair[1].0 - pair[0].0) as f64;
            let contact = (pair[0].1 - pair[0].0) as f64 / stride;
            assert!((0.27..0.42).contains(&contact), "{contact} of the stride from frame {}", pair[0].0);
        }
    }
    // The feet take turns.
    assert!((left.len() as i64 - right.len() as i64).abs() <= 1);
}

#[test]
fn speed_and_cadence_are_those_of_a_run() {
    let run = &*RUN;
    let hips = run.path("Hips");
    let second = (1.0 / run.frame_time()) as usize;
    for frame in (0..hips.len() - second).step_by(60) {
        let speed = hips[frame].distance(hips[frame + second]) / 100.0;
        assert!((2.5..3.8).contains(&speed), "{speed} m/s at frame {frame}");
    }
    let last = hips.len() - 1;
    assert!(
        hips[last].distance(hips[last - second]) > 1.15 * hips[0].distance(hips[second]),
        "it gets faster"
    );
    let steps = contacts(run, "Left");
    let strides = (steps[steps.len() - 1].0 - steps[0].0) as f64 / (steps.len() - 1) as f64;
    let cadence = 120.0 / (strides * run.frame_time());
    assert!((162.0..180.0).contains(&cadence), "{cadence} steps a minute");
}

#[test]
fn it_turns_by_more_than_half_a_turn_and_the_heading_is_never_wrapped() {
    let heading = RUN.channel("Hips", Channel::Rotation(Axis::Y));
    assert!(highest(&heading) > 200.0);
    assert!(differences(&heading).iter().all(|step| step.abs() < 2.0));
}

#[test]
fn the_body_rises_and_falls_by_about_eight_centimetres() {
    let run = &*RUN;
    let height: Vec<f64> = run.path("Hips").iter().map(|hips| hips.y).collect();
    for window in height.chunks(90) {
        if window.len() == 90 {
            let range = highest(window) - lowest(window);
            assert!((5.0..11.0).contains(&range), "{range} cm");
        }
    }
}

#[test]
fn arms_swing_against_the_legs_of_their_side() {
    let run = &*RUN;
    for side in SIDES {
        let hand = ahead(run, &format!("{side}Hand"), &format!("{side}Arm"));
        let foot = ahead(run, &format!("{side}Foot"), &format!("{side}UpLeg"));
        let correlation = correlation(&hand, &foot);
        assert!(correlation < -0.5, "{side}: {correlation}");
        assert!(highest(&hand) - lowest(&hand) > 20.0, "{side} hand hardly moves");
    }
    let hands = SIDES.map(|side| ahead(run, &format!("{side}Hand"), &format!("{side}Arm")));
    assert!(correlation(&hands[0], &hands[1]) < -0.7);
}

#[test]
fn left_and_right_do_the_same() {
    let run = &*RUN;
    let [left, right] = SIDES.map(|side| {
        let knee =
            bend(run, ["UpLeg", "Leg", "Foot"].map(|j| format!("{side}{j}")).each_ref().map(String::as_str));
        let contacts: Vec<f64> =
            contacts(run, side).iter().map(|(first, behind)| (behind - first) as f64).collect();
        [mean(&knee), highest(&knee), mean(&contacts), mean(&run.sole_heights(side))]
    });
    for (a, b) in left.iter().zip(right) {
        assert!((a - b).abs() < 0.06 * a.abs().max(b.abs()), "left {left:?}, right {right:?}");
    }
}

#[test]
fn no_stride_is_quite_like_another() {
    let steps = contacts(&RUN, "Left");
    let strides: Vec<f64> = steps.windows(2).map(|pair| (pair[1].0 - pair[0].0) as f64).collect();
    assert!(deviation(&strides) > 0.3, "{strides:?}");
}

#[test]
fn knees_and_elbows_bend_as_far_as_they_can_and_never_back() {
    let run = &*RUN;
    for side in SIDES {
        let knee = run.channel(&format!("{side}Leg"), Channel::Rotation(Axis::X));
        assert!(lowest(&knee) > 3.0, "{side} knee: {}", lowest(&knee));
        assert!((95.0..125.0).contains(&highest(&knee)), "{side} knee: {}", highest(&knee));
        let elbow = bend(
            run,
            ["Arm", "ForeArm", "Hand"].map(|j| format!("{side}{j}")).each_ref().map(String::as_str),
        );
        assert!(lowest(&elbow) > 70.0 && highest(&elbow) < 130.0, "{side} elbow");
        let thigh = run.channel(&format!("{side}UpLeg"), Channel::Rotation(Axis::X));
        assert!(lowest(&thigh) > -65.0 && highest(&thigh) < 45.0, "{side} hip");
        let ankle = run.channel(&format!("{side}Foot"), Channel::Rotation(Axis::X));
        assert!(lowest(&ankle) > -38.0 && highest(&ankle) < 50.0, "{side} ankle");
    }
}

#[test]
fn the_trunk_leans_forward_and_the_head_keeps_still() {
    let run = &*RUN;
    let lean: Vec<f64> = ahead(run, "Neck", "Hips")
        .iter()
        .zip(run.path("Hips"))
        .zip(run.path("Neck"))
        .map(|((ahead, hips), neck)| ahead.atan2(neck.y - hips.y).to_degrees())
        .collect();
    assert!((5.0..11.0).contains(&mean(&lean)), "{}", mean(&lean));
    assert!(lowest(&lean) > 2.0 && highest(&lean) < 14.0);
    // How far the chest and the head turn away from the way: the chest follows the arms, the head does not.
    let away = |joint: &str| -> Vec<f64> {
        run.direction(joint, DVec3::X)
            .iter()
            .zip(forward(run))
            .map(|(left, forward)| left.dot(forward))
            .collect()
    };
    assert!(deviation(&away("Head")) < 0.4 * deviation(&away("Spine2")));
}

#[test]
fn nothing_jerks() {
    let run = &*RUN;
    for joint in run.motion.skeleton().joints() {
        for channel in joint.channels.iter().filter(|channel| matches!(channel, Channel::Rotation(_))) {
            let speed: Vec<f64> = differences(&run.channel(&joint.name, *channel))
                .iter()
                .map(|d| d / run.frame_time())
                .collect();
            let acceleration: Vec<f64> =
                differences(&speed).iter().map(|d| (d / run.frame_time()).abs()).collect();
            let speed = highest(&speed.iter().map(|s| s.abs()).collect::<Vec<f64>>());
            // The knee of a runner turns at up to 1000 degrees a second, and a striking foot stops within
            // milliseconds.
            let leg = ["UpLeg", "Leg", "Foot", "ToeBase"].iter().any(|part| joint.name.ends_with(part));
            let (most_speed, most_acceleration) = if leg { (1300.0, 60_000.0) } else { (400.0, 6_000.0) };
            assert!(speed < most_speed, "{} {channel}: {speed} degrees/s", joint.name);
            let acceleration = highest(&acceleration);
            assert!(acceleration < most_acceleration, "{} {channel}: {acceleration} degrees/s²", joint.name);
        }
    }
}
