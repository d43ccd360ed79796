//! Texts at all sizes of pictures and of texts.

use super::*;

const CORNERS: [Corner; 4] = [Corner::TopLeft, Corner::TopRight, Corner::BottomLeft, Corner::BottomRight];

fn with_panels(text_scale: f32) -> Scene {
    with_panels_in(CORNERS, text_scale)
}

fn with_panels_in(corners: [Corner; 4], text_scale: f32) -> Scene {
    let mut scene = Scene { text_scale, ..scene(Vec::new()) };
    for corner in corners {
        let panel = scene.panels.add();
        panel.begin(corner);
        panel.add(Line::Heading, "a heading");
        for index in 0..20 {
            panel.add(Line::Text, format_args!("line {index} says something about what is to be seen"));
        }
    }
    scene.timeline = Some(Timeline { frame: 3, count: 50, range: (0, 49), playing: false });
    scene
}

fn drawn(scene: &Scene, size: (usize, usize)) -> Canvas {
    let mut canvas = Canvas::new(size.0, size.1);
    draw(scene, &mut canvas);
    canvas
}

/// The share of the picture that texts and bars cover.
fn covered(scene: &Scene, size: (usize, usize)) -> f32 {
    let bare = Scene { panels: Default::default(), timeline: None, ..scene.clone() };
    let (with, without) = (drawn(scene, size), drawn(&bare, size));
    let changed = with.pixels().iter().zip(without.pixels()).filter(|(a, b)| a != b).count();
    changed as f32 / with.pixels().len() as f32
}

#[test]
fn no_picture_is_covered_by_its_texts() {
    for size in [(16, 16), (120, 90), (320, 200), (200, 600), (1280, 720)] {
        for text_scale in [0.5, 1.0, 2.0, 4.0] {
            let share = covered(&with_panels(text_scale), size);
            assert!(share < 0.8, "{share} of {size:?} at {text_scale}");
        }
    }
}

#[test]
fn the_upper_left_panel_is_the_last_to_go() {
    for size in [(320, 200), (480, 300), (1280, 720)] {
        let canvas = drawn(&with_panels(1.0), size);
        let dark = |x: usize, y: usize| canvas.pixel(x, y).unwrap().channels()[0] < 0x70;
        assert!(dark(16, 14), "{size:?}");
    }
}

#[test]
fn panels_stand_above_the_timeline() {
    let size = (1280, 720);
    for corners in [CORNERS, [Corner::TopLeft; 4], [Corner::BottomRight; 4]] {
        let scene = with_panels_in(corners, 1.0);
        let bar = Bar::new(&scene.timeline.unwrap(), size, 1.0).unwrap();
        let with = drawn(&scene, size);
        let without = drawn(&Scene { panels: Default::default(), ..scene.clone() }, size);
        for y in bar.top as usize - 4..720 {
            for x in 0..1280 {
                assert_eq!(
                    with.pixel(x, y),
                    without.pixel(x, y),
                    "a panel reaches the timeline at ({x}, {y})"
                );
            }
        }
    }
}

#[test]
fn text_is_as_large_as_it_should_be() {
    let share = |text_scale: f32| {
        let mut scene = scene(Vec::new());
        scene.text_scale = text_scale;
        let panel = scene.panels.add();
        panel.begin(Corner::TopLeft);
        panel.add(Line::Text, "some words");
        covered(&scene, (2400, 1600))
    };
    let plain = share(1.0);
    for (scale, expected) in [(2.0, 4.0), (0.5, 0.25), (4.0, 16.0), (9.0, 16.0), (0.0, 0.25), (f32::NAN, 1.0)]
    {
        let ratio = share(scale) / plain;
        assert!((ratio / expected - 1.0).abs() < 0.15, "{ratio} times the room at {scale}");
    }
}

#[test]
fn lines_and_squares_grow_with_the_texts() {
    let bone = Bone { from: Vec3::ZERO, to: Vec3::X, side: Side::Left, radius: 0.1, joints: (0, 1) };
    let painted = |text_scale: f32| {
        let figure = Figure { bones: vec![bone], ..figure(vec![Vec3::Y]) };
        let canvas = drawn(&Scene { text_scale, ..scene(vec![figure]) }, (640, 480));
        let count = |tint| canvas.pixels().iter().filter(|pixel| **pixel == color_of(tint).0).count();
        (count(Tint::Bone(Side::Left)), count(Tint::Joint))
    };
    let ((thin, small), (wide, large)) = (painted(1.0), painted(3.0));
    assert!(wide > 2 * thin && large > 3 * small, "{thin} {wide} {small} {large}");
}

#[test]
fn trails_have_colours_of_their_own_fade_and_hide_behind_bodies() {
    let mut scene = Scene { style: Style::Lit, ..scene(Vec::new()) };
    (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
    let line = |y: f32| (0..41).map(move |i| Vec3::new(-2.0 + 0.1 * i as f32, y, 0.0));
    for (index, y) in [(0, 0.8), (1, -0.8)] {
        let trail = scene.trails.add();
        trail.index = index;
        trail.points.extend(line(y));
    }
    let size = (640, 480);
    let empty = drawn(&Scene { trails: Default::default(), ..scene.clone() }, size);
    let view = scene.camera.view(size);
    let change = |canvas: &Canvas, place: Vec3| {
        let spot = view.project(place).unwrap();
        let at = |canvas: &Canvas| canvas.pixel(spot.x as usize, spot.y as usize).unwrap().channels();
        let (a, b) = (at(canvas), at(&empty));
        [0, 1, 2].map(|channel| i32::from(b[channel]) - i32::from(a[channel]))
    };
    let strength = |change: [i32; 3]| change.iter().map(|part| part.abs()).sum::<i32>();
    let canvas = drawn(&scene, size);
    let [old, young] = [-1.85, 1.85].map(|x| change(&canvas, Vec3::new(x, 0.8, 0.0)));
    assert!(strength(old) * 3 < strength(young) && strength(old) > 0, "{old:?} {young:?}");
    assert_ne!(young, change(&canvas, Vec3::new(1.85, -0.8, 0.0)));
    let body = Bone {
        from: Vec3::new(1.0, 0.8, 1.0),
        to: Vec3::new(1.6, 0.8, 1.0),
        side: Side::Left,
        radius: 0.3,
        joints: (0, 1),
    };
    *scene.figures.add() = Figure { bones: vec![body], ..figure(vec![]) };
    let with = drawn(&scene, size);
    let without = drawn(&Scene { trails: Default::default(), ..scene.clone() }, size);
    let hidden = view.project(Vec3::new(1.2, 0.8, 0.0)).unwrap();
    let at = |canvas: &Canvas| canvas.pixel(hidden.x as usize, hidden.y as usize);
    assert_eq!(at(&with), at(&without));
}
