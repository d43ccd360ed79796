//! What the painter promises of any scene.

mod editing;
mod look;
mod panels;
mod shadow;

use std::sync::{LazyLock, Mutex, PoisonError};

use glam::Quat;
use proptest::prelude::*;

use super::*;
use crate::camera::Camera;
use crate::draw::canvas::Ground;
use crate::scene::{Axes, Bone, Corner, Dot, Line, ScaleBar, Timeline};
use crate::scene::{Figure, Look, Mark, Side, Tint};

/// Draws with one painter for all tests: reading the fonts takes longest.
fn draw(scene: &Scene, canvas: &mut Canvas) {
    static PAINTER: LazyLock<Mutex<Painter>> = LazyLock::new(Mutex::default);
    // A failed test must not make all others fail.
    PAINTER.lock().unwrap_or_else(PoisonError::into_inner).draw(scene, canvas);
}

fn scene(figures: Vec<Figure>) -> Scene {
    Scene {
        camera: Camera { target: Vec3::ZERO, azimuth: 0.3, elevation: 0.2, distance: 10.0 },
        ground: Ground { height: 0.0, cell: 1.0 },
        style: Style::Lines,
        size: 3.0,
        figures: figures.into_iter().collect(),
        text_scale: 1.0,
        ..Scene::default()
    }
}

fn figure(joints: Vec<Vec3>) -> Figure {
    Figure { joints: joints.into_iter().map(Dot::from).collect(), ..Figure::default() }
}

proptest! {
    #[test]
    fn a_joint_is_a_purple_square_at_its_projection(
        joint in (-1.5f32..1.5, -1.5f32..1.5, -1.5f32..1.5).prop_map(Vec3::from),
        azimuth in 0.0f32..6.0,
        elevation in -1.4f32..1.4,
    ) {
        let mut scene = scene(vec![figure(vec![joint])]);
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        let mut canvas = Canvas::new(320, 240);
        draw(&scene, &mut canvas);
        let spot = scene.camera.view(canvas.size()).project(joint).unwrap();
        let mut purple = Vec::new();
        for y in 0..240 {
            for x in 0..320 {
                if canvas.pixel(x, y) == Some(color_of(Tint::Joint)) {
                    purple.push((x as f32 + 0.5, y as f32 + 0.5));
                }
            }
        }
        let count = purple.len() as f32;
        let x = purple.iter().map(|p| p.0).sum::<f32>() / count;
        let y = purple.iter().map(|p| p.1).sum::<f32>() / count;
        prop_assert!(count >= 4.0 && (x - spot.x).abs() <= 0.75 && (y - spot.y).abs() <= 0.75, "{x} {y} {spot:?}");
    }

    #[test]
    fn no_numbers_make_it_panic(
        raw in prop::array::uniform16(prop_oneof![3 => -3.0f32..3.0, 1 => any::<f32>()]), size in (1usize..60, 1usize..60), lit in any::<bool>(), odd in any::<bool>(),
    ) {
        let [a, b] = [Vec3::new(raw[0], raw[1], raw[2]), Vec3::new(raw[3], raw[4], raw[5])];
        let rotation = Quat::from_xyzw(raw[6], raw[7], raw[8], raw[9]);
        let mut scene = scene(vec![Figure {
            look: Look::Solid,
            bones: vec![
                Bone { from: a, to: b, side: Side::Left, radius: raw[10], joints: (0, 1) },
                Bone { from: b, to: Vec3::ZERO, side: Side::Middle, radius: 0.2, joints: (1, 2) },
                Bone { from: Vec3::ONE, to: Vec3::ONE, side: Side::Right, radius: raw[13], joints: (9, 9) },
            ],
            joints: vec![a.into(), b.into()],
            axes: vec![Axes { origin: a, rotation, length: raw[10], lettered: true }],
        }]);
        let ghost = Figure { look: Look::Echo(raw[12]), ..scene.figures[0].clone() };
        *scene.figures.add() = ghost;
        scene.style = if lit { Style::Lit } else { Style::Lines };
        scene.size = raw[10];
        scene.text_scale = raw[14];
        scene.marks.push(Mark { from: Some(a), to: b, text: "x".into(), text_offset: (-3, 2), tint: Tint::Ink });
        scene.trails.add().points.extend([a, b, Vec3::ZERO, Vec3::X, a]);
        scene.timeline = Some(Timeline { frame: 7, count: 5, range: (9, 1), playing: lit });
        scene.scale_bar = Some(ScaleBar { length: raw[13], label: "long".into() });
        let panel = scene.panels.add();
        panel.begin(Corner::BottomRight);
        panel.add(Line::Heading, "long ".repeat(20));
        panel.add(Line::Key("k"), "word ".repeat(9));
        let mut canvas = Canvas::new(size.0, size.1);
        draw(&scene, &mut canvas);
        scene.camera.distance = raw[11];
        scene.camera.target.y = raw[12];
        if odd {
            (scene.size, scene.ground.height) = (raw[14], raw[15]);
        }
        draw(&scene, &mut canvas);
    }
}

#[test]
fn joints_that_share_a_place_look_like_one() {
    let bone = Bone {
        from: Vec3::ZERO,
        to: Vec3::new(1.0, 1.2, 0.3),
        side: Side::Left,
        radius: 0.1,
        joints: (0, 1),
    };
    let axes = Axes { origin: bone.to, rotation: Quat::from_rotation_x(0.4), length: 0.5, lettered: false };
    let drawn = |count: usize| {
        let (bones, axes) = (vec![bone; count], vec![axes; count]);
        let mut canvas = Canvas::new(120, 90);
        draw(&scene(vec![Figure { bones, axes, ..figure(vec![bone.to; count]) }]), &mut canvas);
        canvas
    };
    assert!(drawn(1).pixels() == drawn(20).pixels());
}

#[test]
fn letters_far_outside_of_the_picture_are_left_out() {
    let level = |mut scene: Scene| {
        (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
        scene
    };
    let mut empty = Canvas::new(64, 48);
    draw(&level(scene(Vec::new())), &mut empty);
    for far in [1e6f32, 1e12, 1e30, -1e6, -1e12, -1e30] {
        for aside in [Vec3::X, Vec3::Y] {
            let mut scene = level(scene(Vec::new()));
            let view = scene.camera.view((64, 48));
            // In front of the camera, and farther aside than whole pixels can be counted.
            let origin = aside * far;
            assert!(view.project(origin).is_some());
            let axes = vec![Axes { origin, rotation: Quat::IDENTITY, length: 0.5, lettered: true }];
            *scene.figures.add() = Figure { axes, ..figure(Vec::new()) };
            let mark = Mark {
                from: None,
                to: origin,
                text: "far".into(),
                text_offset: (i32::MAX, i32::MAX),
                tint: Tint::Ink,
            };
            scene.marks.push(mark);
            let mut canvas = Canvas::new(64, 48);
            draw(&scene, &mut canvas);
            assert!(canvas.pixels() == empty.pixels(), "{far} {aside}");
        }
    }
}

#[test]
fn a_near_bone_hides_a_far_one_and_the_ghost_never_hides_the_figure() {
    let bone = |z: f32, side| {
        let (from, to) = (Vec3::new(-1.0, 0.0, z), Vec3::new(1.0, 0.0, z));
        Bone { from, to, side, radius: 0.1, joints: (0, 1) }
    };
    let solid = Figure { bones: vec![bone(1.0, Side::Left), bone(-1.0, Side::Right)], ..figure(vec![]) };
    let ghost = Figure { look: Look::Ghost, bones: vec![bone(1.0, Side::Left)], ..figure(vec![]) };
    for figures in [vec![solid.clone(), ghost.clone()], vec![ghost, solid]] {
        let mut scene = scene(figures);
        (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
        let mut canvas = Canvas::new(321, 241);
        draw(&scene, &mut canvas);
        assert_eq!(canvas.pixel(160, 120), Some(color_of(Tint::Bone(Side::Left))));
    }
}
