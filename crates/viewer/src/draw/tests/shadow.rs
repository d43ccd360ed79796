//! Shadows fall where the sun throws them.

use glam::Vec3Swizzles;

use super::super::lit::SUN;
use super::*;

const SIZE: (usize, usize) = (400, 300);

/// The middle of a square of the ground, and how large it is: no line is in the picture.
const MIDDLE: Vec3 = Vec3::new(50.0, 0.0, 50.0);
const CELL: f32 = 100.0;

/// A bone that lies level, this high above the ground, in a scene that is `unit` times as large.
fn lying(height: f32, aside: f32, unit: f32) -> Scene {
    let ends = [-0.4, 0.4].map(|x| (MIDDLE + Vec3::new(x + aside, height, 0.0)) * unit);
    let bone = Bone { from: ends[0], to: ends[1], side: Side::Left, radius: 0.1 * unit, joints: (0, 1) };
    let mut scene =
        Scene { style: Style::Lit, ..scene(vec![Figure { bones: vec![bone], ..figure(vec![]) }]) };
    let target = MIDDLE * unit;
    scene.camera = Camera { target, azimuth: 0.0, elevation: 0.7, distance: 6.0 * unit };
    scene.ground = Ground { height: 0.0, cell: CELL * unit };
    scene.size = 3.0 * unit;
    scene
}

/// How bright the ground is at a place.
fn ground(scene: &Scene, place: Vec3) -> f32 {
    let mut canvas = Canvas::new(SIZE.0, SIZE.1);
    draw(scene, &mut canvas);
    let spot = scene.camera.view(SIZE).project(scene.camera.target + place).unwrap();
    let [red, green, blue] =
        canvas.pixel(spot.x as usize, spot.y as usize).unwrap().channels().map(f32::from);
    red + green + blue
}

/// Where the middle of a bone at this height casts its shadow.
fn under_the_sun(height: f32, aside: f32) -> Vec3 {
    let along = SUN.xz() * (height / SUN.y);
    Vec3::new(aside - along.x, 0.0, -along.y)
}

#[test]
fn the_ground_is_dark_under_a_body_and_light_elsewhere() {
    // In front of the body, where it does not hide the ground, on the side that is turned away from the sun.
    for unit in [1e-15f32, 0.01, 1.0, 250.0, 1e15] {
        let scene = lying(0.6, 0.3, unit);
        let [shadow, far] =
            [under_the_sun(0.6, 0.3), Vec3::new(-1.6, 0.0, 1.0)].map(|place| ground(&scene, place * unit));
        assert!(shadow < 0.85 * far, "{unit}: {shadow} and {far}");
    }
}

#[test]
fn the_shadow_moves_with_the_body_and_away_from_the_sun_when_it_is_lifted() {
    let (low, high) = (lying(0.5, 0.3, 1.0), lying(1.1, 0.3, 1.0));
    let moved = lying(0.5, -1.2, 1.0);
    let [under_low, under_high, under_moved] =
        [under_the_sun(0.5, 0.3), under_the_sun(1.1, 0.3), under_the_sun(0.5, -1.2)];
    assert!(under_high.dot(SUN) < under_low.dot(SUN), "farther away from the sun");
    assert!(ground(&low, under_low) + 40.0 < ground(&high, under_low));
    assert!(ground(&high, under_high) + 20.0 < ground(&low, under_high));
    assert!(ground(&moved, under_moved) + 40.0 < ground(&low, under_moved));
    assert!(ground(&low, under_low) + 40.0 < ground(&moved, under_low));
}

#[test]
fn a_shadow_fades_with_height() {
    let depth = |height| {
        let place = under_the_sun(height, 0.3);
        let lit = Scene { figures: Default::default(), ..lying(height, 0.3, 1.0) };
        ground(&lit, place) - ground(&lying(height, 0.3, 1.0), place)
    };
    let depths = [0.5, 1.5, 3.0].map(depth);
    assert!(depths.is_sorted_by(|a, b| a > b) && depths[2] > 0.0, "{depths:?}");
}

#[test]
fn what_touches_the_ground_darkens_it_all_around() {
    let scene = lying(0.1, 0.3, 1.0);
    // Towards the sun there is no shadow, but less of the sky is seen.
    let [close, far] = [0.16, 1.2].map(|z| ground(&scene, Vec3::new(0.3, 0.0, z)));
    assert!(close + 15.0 < far, "{close} {far}");
}

#[test]
fn nothing_below_the_ground_and_no_goal_casts_a_shadow() {
    let below = lying(-0.6, 0.3, 1.0);
    let mut goal = lying(0.6, 0.3, 1.0);
    goal.figures.items_mut()[0].look = Look::Ghost;
    let empty = Scene { figures: Default::default(), ..below.clone() };
    for (scene, place) in [(below, Vec3::new(0.3, 0.0, -0.2)), (goal, under_the_sun(0.6, 0.3))] {
        assert_eq!(ground(&scene, place), ground(&empty, place));
    }
}

#[test]
fn one_body_shades_another() {
    let bone = |height: f32| {
        let ends = [-0.4, 0.4].map(|x| MIDDLE + Vec3::new(x, height, 0.0));
        Bone { from: ends[0], to: ends[1], side: Side::Middle, radius: 0.12, joints: (0, 1) }
    };
    // The second lies between the first and the sun.
    let mut other = bone(0.6);
    other.from += SUN * 0.7;
    other.to += SUN * 0.7;
    other.joints = (2, 3);
    let bright = |bones: Vec<Bone>| {
        let scene = Scene {
            figures: [Figure { bones, ..figure(vec![]) }].into_iter().collect(),
            ..lying(0.0, 0.0, 1.0)
        };
        ground(&scene, Vec3::new(0.0, 0.6, 0.0) + 0.12 * Vec3::new(0.0, 0.7, 0.7))
    };
    let (lit, shaded) = (bright(vec![bone(0.6)]), bright(vec![bone(0.6), other]));
    assert!(shaded < 0.85 * lit, "{shaded} {lit}");
}

#[test]
fn another_body_keeps_the_light_of_the_sky_away_and_its_shadow_that_of_the_ground() {
    let body = |aside: Vec3, radius: f32| {
        let ends = [-0.4, 0.4].map(|x| MIDDLE + Vec3::new(x, 0.6, 0.0) + aside);
        Bone { from: ends[0], to: ends[1], side: Side::Middle, radius, joints: (0, 1) }
    };
    let bright = |elevation: f32, others: Vec<Bone>, spot: Vec3| {
        let bones = [body(Vec3::ZERO, 0.12)].into_iter().chain(others).collect();
        let mut scene = Scene {
            figures: [Figure { bones, ..figure(vec![]) }].into_iter().collect(),
            ..lying(0.0, 0.0, 1.0)
        };
        scene.camera.elevation = elevation;
        ground(&scene, Vec3::new(0.0, 0.6, 0.0) + spot)
    };
    // Behind it and above, where it is not between the body and the sun: the top gets less of the sky.
    let beside = Bone { joints: (2, 3), ..body(Vec3::new(0.0, 0.16, -0.26), 0.16) };
    let top = Vec3::new(0.0, 0.119, 0.01);
    // What is behind does not stand in the sun.
    const { assert!(SUN.z > 0.0) };
    assert!(bright(0.7, vec![beside], top) + 8.0 < bright(0.7, vec![], top));
    // High above, between the ground below the body and the sun: the underside gets less from the ground.
    let mut above = Bone { joints: (2, 3), ..body(Vec3::ZERO, 0.5) };
    (above.from, above.to) = (above.from + SUN * 2.5, above.to + SUN * 2.5);
    let below = Vec3::new(0.0, -0.119, 0.01);
    assert!(bright(-0.05, vec![above], below) + 4.0 < bright(-0.05, vec![], below));
}
