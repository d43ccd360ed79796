//! Shadows fall where the sun throws them.

use glam::Vec3Swizzles;

use super::super::lit::SUN;
use super::*;

const SIZE: (usize, usize) = (400, 300);

/// A bone that lies level, this high above the ground, in a scene that is `unit` times as large.
fn lying(height: f32, aside: f32, unit: f32) -> Scene {
    let ends = [-0.4, 0.4].map(|x| Vec3::new(x + aside, height, 0.0) * unit);
    let bone = Bone { from: ends[0], to: ends[1], side: Side::Left, radius: 0.1 * unit, joints: (0, 1) };
    let mut scene =
        Scene { style: Style::Lit, ..scene(vec![Figure { bones: vec![bone], ..figure(vec![]) }]) };
    scene.camera = Camera { target: Vec3::ZERO, azimuth: 0.0, elevation: 0.7, distance: 6.0 * unit };
    // Squares so large that no line is in the picture.
    scene.ground = Ground { height: 0.0, cell: 1e6 * unit };
    scene.ground.height = 0.0;
    scene.camera.target.x = 0.0;
    scene.size = 3.0 * unit;
    scene
}

/// How bright the ground is at a place.
fn ground(scene: &Scene, place: Vec3) -> f32 {
    let mut canvas = Canvas::new(SIZE.0, SIZE.1);
    draw(scene, &mut canvas);
    // Beside the lines through the origin.
    let spot = scene.camera.view(SIZE).project(place).unwrap();
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
        let ends = [-0.4, 0.4].map(|x| Vec3::new(x, height, 0.0));
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
