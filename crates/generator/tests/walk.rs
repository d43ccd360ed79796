//! Does `walk.amc` walk like a human, and is `walk.asf` built like real skeletons? Bounds are those of the literature on
//! gait, a little widened.

mod common;

use std::sync::LazyLock;

use common::bones::BonePaths;
use common::{correlation, deviation, differences, highest, lowest, mean, spans};
use glam::DVec3;
use skeleton::Channel;
use skeleton::acclaim::Bone;

/// Made once for all tests.
static WALK: LazyLock<BonePaths> = LazyLock::new(|| BonePaths::new(generator::walking().expect("the walk")));

/// Frames per second.
const RATE: f64 = 120.0;
const SIDES: [&str; 2] = ["l", "r"];
/// How the legs stand apart at rest, on the left.
const SPREAD: f64 = 12.0;

fn sided(side: &str, bone: &str) -> String {
    format!("{side}{bone}")
}

/// What is up for a leg at rest, and what is ahead.
fn up_and_ahead(side: &str) -> [DVec3; 2] {
    let spread = if side == "l" { SPREAD } else { -SPREAD }.to_radians();
    [DVec3::new(-spread.sin(), spread.cos(), 0.0), DVec3::Z]
}

/// For every frame the height of the lowest point of a sole, in cm: heel, ball or tip of the toes.
fn sole_heights(side: &str) -> Vec<f64> {
    let foot = sided(side, "foot");
    // The sole is 6.8 below the ankle, 2 below the ball and 0.8 below the tip of the toes; the heel is 6 behind the ankle.
    let [up, ahead] = up_and_ahead(side);
    let heel = WALK.directions(&foot, -6.8 * up - 6.0 * ahead);
    let (ankle, ball) = (WALK.starts(&foot), WALK.ends(&foot));
    let tip = WALK.ends(&sided(side, "toes"));
    (0..480).map(|f| (ankle[f] + heel[f]).y.min(ball[f].y - 2.0).min(tip[f].y - 0.8)).collect()
}

/// The frames in which a foot is on the ground: (first, one behind the last). Contacts cut off by the ends do not
/// count.
fn contacts(side: &str) -> Vec<(usize, usize)> {
    let on_ground: Vec<bool> = sole_heights(side).iter().map(|height| *height < 0.3).collect();
    spans(&on_ground).into_iter().filter(|span| span.0 > 0 && span.1 < on_ground.len()).collect()
}

fn heights(places: &[DVec3]) -> Vec<f64> {
    places.iter().map(|place| place.y).collect()
}

#[test]
fn the_skeleton_has_30_bones_in_the_usual_tree() {
    let skeleton = WALK.motion.skeleton();
    assert_eq!((skeleton.len(), WALK.motion.frame_count(), WALK.motion.columns().len()), (31, 480, 62));
    let children =
        |name: &str| skeleton.children(WALK.bone(name).id).map(|bone| bone.name.as_str()).collect::<Vec<_>>();
    assert_eq!(children("root"), ["lhipjoint", "rhipjoint", "lowerback"]);
    assert_eq!(children("thorax"), ["lowerneck", "lclavicle", "rclavicle"]);
    assert_eq!(children("rwrist"), ["rhand", "rthumb"]);
    let without_children: Vec<&str> =
        skeleton.bones().iter().filter(|bone| bone.child.is_none()).map(|bone| bone.name.as_str()).collect();
    assert_eq!(without_children, ["ltoes", "rtoes", "head", "lfingers", "lthumb", "rfingers", "rthumb"]);
}

#[test]
fn bones_have_axes_of_their_own_and_some_of_the_dofs() {
    let bones = WALK.motion.skeleton().bones();
    let count = |holds: &dyn Fn(&Bone) -> bool| bones.iter().filter(|bone| holds(bone)).count();
    assert_eq!(count(&|bone| bone.axis.angles != [0.0; 3]), 20);
    let dofs: Vec<usize> = (0..=6).map(|dofs| count(&|bone| bone.dofs.len() == dofs)).collect();
    assert_eq!(dofs, [2, 10, 8, 10, 0, 0, 1], "without, with one, with two…");
    assert!(bones[1..].iter().flat_map(|bone| &bone.dofs).all(|dof| dof.is_limited() && dof.low < dof.high));
}

#[test]
fn the_figure_is_175_cm_tall_and_its_halves_mirror_each_other() {
    let skeleton = WALK.motion.skeleton();
    let ends = skeleton.rest_ends();
    for left in
        skeleton.bones().iter().filter(|bone| bone.name.starts_with('l') && !bone.name.starts_with("lower"))
    {
        let right = WALK.bone(&format!("r{}", &left.name[1..]));
        let (a, b) = (ends[left.id.0], ends[right.id.0]);
        assert!((a.x + b.x).abs() + (a.y - b.y).abs() + (a.z - b.z).abs() < 1e-3, "{}: {a} {b}", left.name);
    }
    // Upright, the sole is as far below the hips as the leg is long.
    let leg =
        ["lfemur", "ltibia"].map(|bone| f64::from(WALK.bone(bone).length)).iter().sum::<f64>() + 6.8 + 5.0;
    let top = f64::from(ends[WALK.bone("head").id.0].y);
    assert!((top + leg - 175.0).abs() < 1.5, "{}", top + leg);
}

#[test]
fn no_bone_is_moved_beyond_its_limits() {
    for bone in &WALK.motion.skeleton().bones()[1..] {
        for dof in &bone.dofs {
            let Channel::Rotation(axis) = dof.channel else { panic!("{} slides", bone.name) };
            let angles = WALK.angles(&bone.name, axis.index());
            let (low, high) = (lowest(&angles), highest(&angles));
            assert!(
                low >= f64::from(dof.low) && high <= f64::from(dof.high),
                "{} {dof}: {low} to {high}",
                bone.name
            );
        }
    }
}

#[test]
fn a_foot_on_the_ground_stays_where_it_is() {
    for side in SIDES {
        let ball = WALK.ends(&sided(side, "foot"));
        let contacts = contacts(side);
        assert!(contacts.len() >= 3, "{side}: {contacts:?}");
        for (first, behind) in contacts {
            let part = |part: f64| first + ((behind - first) as f64 * part) as usize;
            let middle = ball[part(0.5)];
            // Before, the foot comes down on its heel, and the ball comes down with it; behind, only the toes stand.
            let slides = ball[part(0.25)..part(0.95)].iter().map(|place| (*place - middle).length());
            let slide = highest(&slides.collect::<Vec<f64>>());
            assert!(slide < 0.1, "{side} slides by {slide} cm");
        }
        assert!(lowest(&sole_heights(side)) > -0.1, "{side} sinks by {} cm", lowest(&sole_heights(side)));
    }
}

#[test]
fn a_standing_foot_lies_flat() {
    for side in SIDES {
        let [up, ahead] = up_and_ahead(side);
        let foot = sided(side, "foot");
        let (ups, aheads) = (WALK.directions(&foot, up), WALK.directions(&foot, ahead));
        for (first, behind) in contacts(side) {
            // Not only in the direction of the toes, but also across: the ankle has two dofs, and the hip does the rest.
            for up in &ups[first + (behind - first) * 3 / 10..first + (behind - first) / 2] {
                assert!(up.distance(DVec3::Y) < 0.002, "{side}: {up}");
            }
            for (up, ahead) in ups[first..behind].iter().zip(&aheads[first..behind]) {
                let across = up.cross(*ahead);
                assert!(across.y.abs() < 0.002, "{side}: {across}");
            }
        }
    }
}

#[test]
fn one_foot_or_both_are_always_on_the_ground() {
    let heights = SIDES.map(sole_heights);
    let standing: Vec<usize> =
        (0..480).map(|frame| heights.iter().filter(|sole| sole[frame] < 0.3).count()).collect();
    assert_eq!(standing.iter().min(), Some(&1), "nobody flies");
    let both = standing.iter().filter(|&&feet| feet == 2).count() as f64 / 480.0;
    assert!((0.18..0.34).contains(&both), "{both} of the time on both feet");
    for side in SIDES {
        for pair in contacts(side).windows(2) {
            let stride = (pair[1].0 - pair[0].0) as f64;
            let contact = (pair[0].1 - pair[0].0) as f64 / stride;
            assert!((0.58..0.68).contains(&contact), "{contact} of the stride");
            let cadence = 2.0 * 60.0 * RATE / stride;
            assert!((106.0..118.0).contains(&cadence), "{cadence} steps a minute");
        }
    }
}

#[test]
fn it_walks_straight_ahead_at_an_even_pace() {
    let root = WALK.ends("root");
    for frame in (0..480 - 120).step_by(30) {
        let way = (root[frame + 120] - root[frame]) / 100.0;
        assert!((1.15..1.35).contains(&way.z) && way.x.abs() < 0.06, "{way} m in a second");
    }
    let rise = heights(&root);
    for stride in rise.chunks_exact(128) {
        let range = highest(stride) - lowest(stride);
        assert!((2.0..5.0).contains(&range), "{range} cm");
    }
    let sway: Vec<f64> = root.iter().map(|root| root.x).collect();
    assert!((2.5..7.0).contains(&(highest(&sway) - lowest(&sway))));
}

#[test]
fn legs_bend_as_those_of_walkers_do() {
    for side in SIDES {
        let knee = WALK.angles(&sided(side, "tibia"), 0);
        assert!(lowest(&knee) > 3.0 && lowest(&knee) < 12.0, "{side}: {}", lowest(&knee));
        assert!((58.0..72.0).contains(&highest(&knee)), "{side}: {}", highest(&knee));
        for (first, behind) in contacts(side) {
            // It gives way a little as it takes the weight, and is nearly straight when the other foot comes down.
            let part = |part: f64| first + ((behind - first) as f64 * part) as usize;
            assert!((14.0..24.0).contains(&highest(&knee[part(0.1)..part(0.4)])), "{side}");
            assert!(lowest(&knee[part(0.5)..part(0.9)]) < 13.0, "{side}");
        }
        let hip = WALK.angles(&sided(side, "femur"), 0);
        assert!(
            lowest(&hip) > -42.0 && highest(&hip) < 18.0,
            "{side}: {} to {}",
            lowest(&hip),
            highest(&hip)
        );
        let ankle = WALK.angles(&sided(side, "foot"), 0);
        assert!(
            lowest(&ankle) > -24.0 && highest(&ankle) < 28.0,
            "{side}: {} to {}",
            lowest(&ankle),
            highest(&ankle)
        );
    }
}

#[test]
fn a_swinging_foot_passes_close_above_the_ground() {
    for side in SIDES {
        let soles = sole_heights(side);
        let in_the_air: Vec<bool> = soles.iter().map(|height| *height >= 0.3).collect();
        for (first, behind) in spans(&in_the_air).into_iter().filter(|span| span.0 > 0 && span.1 < 480) {
            let middle = &soles[first + (behind - first) / 4..behind - (behind - first) / 4];
            assert!((0.8..8.0).contains(&lowest(middle)), "{side}: {} cm", lowest(middle));
        }
    }
}

#[test]
fn arms_swing_against_the_legs_of_their_side() {
    let ahead = |ends: Vec<DVec3>, of: Vec<DVec3>| -> Vec<f64> {
        ends.iter().zip(of).map(|(end, of)| end.z - of.z).collect()
    };
    for side in SIDES {
        let hand = ahead(WALK.ends(&sided(side, "wrist")), WALK.starts(&sided(side, "humerus")));
        let foot = ahead(WALK.ends(&sided(side, "tibia")), WALK.starts(&sided(side, "femur")));
        assert!(correlation(&hand, &foot) < -0.8, "{side}: {}", correlation(&hand, &foot));
        assert!((20.0..50.0).contains(&(highest(&hand) - lowest(&hand))), "{side}");
        let elbow = WALK.angles(&sided(side, "radius"), 0);
        assert!(lowest(&elbow) > 8.0 && highest(&elbow) < 42.0, "{side}");
        // The arms hang at the sides, and do not pass through the hips.
        let (wrist, root) = (WALK.ends(&sided(side, "wrist")), WALK.ends("root"));
        let aside: Vec<f64> = wrist.iter().zip(root).map(|(wrist, root)| (wrist.x - root.x).abs()).collect();
        assert!(
            lowest(&aside) > 17.0 && highest(&aside) < 38.0,
            "{side}: {} to {}",
            lowest(&aside),
            highest(&aside)
        );
    }
}

#[test]
fn the_trunk_is_upright_and_the_head_keeps_still() {
    let (root, neck) = (WALK.ends("root"), WALK.ends("thorax"));
    let lean = |axis: usize| -> Vec<f64> {
        root.iter()
            .zip(&neck)
            .map(|(root, neck)| (neck[axis] - root[axis]).atan2(neck.y - root.y).to_degrees())
            .collect()
    };
    assert!((0.0..8.0).contains(&mean(&lean(2))), "{}", mean(&lean(2)));
    assert!(highest(&lean(0)) < 5.0 && lowest(&lean(0)) > -5.0);
    let turn =
        |bone: &str| -> Vec<f64> { WALK.directions(bone, DVec3::X).iter().map(|left| left.z).collect() };
    assert!(deviation(&turn("head")) < 0.5 * deviation(&turn("root")));
    assert!(correlation(&turn("thorax"), &turn("root")) < -0.5, "the chest turns against the pelvis");
}

#[test]
fn nothing_jerks() {
    for bone in WALK.motion.skeleton().bones() {
        for dof in &bone.dofs {
            let Channel::Rotation(axis) = dof.channel else { continue };
            let speeds: Vec<f64> =
                differences(&WALK.angles(&bone.name, axis.index())).iter().map(|step| step * RATE).collect();
            let accelerations: Vec<f64> =
                differences(&speeds).iter().map(|step| (step * RATE).abs()).collect();
            let speeds: Vec<f64> = speeds.iter().map(|speed| speed.abs()).collect();
            let leg = ["femur", "tibia", "foot", "toes"].iter().any(|part| bone.name.ends_with(part));
            let (most_speed, most_acceleration) = if leg { (800.0, 35_000.0) } else { (150.0, 1_000.0) };
            assert!(highest(&speeds) < most_speed, "{} {dof}: {} degrees/s", bone.name, highest(&speeds));
            let highest = highest(&accelerations);
            assert!(highest < most_acceleration, "{} {dof}: {highest} degrees/s²", bone.name);
        }
    }
}

#[test]
fn left_and_right_do_the_same_and_no_stride_is_quite_like_another() {
    let [left, right] = SIDES.map(|side| {
        // Three strides.
        let knee = &WALK.angles(&sided(side, "tibia"), 0)[..386];
        [mean(knee), highest(knee), deviation(&sole_heights(side)[..386])]
    });
    for (a, b) in left.iter().zip(right) {
        assert!((a - b).abs() < 0.06 * a.abs().max(b.abs()), "left {left:?}, right {right:?}");
    }
    let peaks: Vec<f64> = WALK.angles("ltibia", 0)[..3 * 128].chunks_exact(128).map(highest).collect();
    assert!(deviation(&peaks) > 0.01, "{peaks:?}");
}
