//! What an edited motion adds to the picture: flashes, error vectors and the plot.

use skeleton::Representation;

use super::*;
use crate::draw::canvas::Color;
use crate::scene::{Plot, Stroke};

const SIZE: (usize, usize) = (960, 540);

fn drawn(scene: &Scene, size: (usize, usize)) -> Canvas {
    let mut canvas = Canvas::new(size.0, size.1);
    draw(scene, &mut canvas);
    canvas
}

fn places(canvas: &Canvas, wanted: impl Fn(Color) -> bool) -> Vec<(usize, usize)> {
    let pixels = canvas.pixels().iter().enumerate().filter(|(_, pixel)| wanted(Color(**pixel)));
    pixels.map(|(index, _)| (index % canvas.size().0, index / canvas.size().0)).collect()
}

fn vector(from: Vec3, to: Vec3) -> Mark {
    Mark { from: Some(from), to, text: String::new(), text_offset: (0, 0), tint: Tint::Error }
}

fn stroke_of(representation: Representation) -> Stroke {
    match representation {
        Representation::Euler => Stroke::Solid,
        Representation::Quaternion => Stroke::Dashed,
    }
}

/// A rising curve in each representation, from the lower left corner, and the present state at the end of one.
fn plot() -> Plot {
    let mut plot = Plot { upwards: "error".into(), rightwards: "frames".into(), ..Plot::default() };
    for (ticks, label) in [(&mut plot.columns, "100"), (&mut plot.rows, "2.5")] {
        for at in [0.0, 0.5, 1.0] {
            let tick = ticks.add();
            (tick.at, tick.label) = (at, label.into());
        }
    }
    for (representation, height) in [(Representation::Euler, 1.0), (Representation::Quaternion, 0.6)] {
        let curve = plot.curves.add();
        (curve.name, curve.stroke) = (representation.name().into(), stroke_of(representation));
        curve.points.extend((0..=100).map(|i| (i as f32 / 100.0, height * (i as f32 / 100.0).powi(3))));
    }
    plot.mark = Some((1.0, 1.0));
    plot
}

fn with_plot(text_scale: f32) -> Scene {
    Scene { text_scale, plot: Some(plot()), ..scene(Vec::new()) }
}

/// Where the plot is: its place in the picture, or nothing where there is none.
fn extent(text_scale: f32, size: (usize, usize)) -> Option<[usize; 4]> {
    let scene = with_plot(text_scale);
    let (with, without) = (drawn(&scene, size), drawn(&Scene { plot: None, ..scene }, size));
    let pairs = with.pixels().iter().zip(without.pixels()).enumerate();
    let changed: Vec<(usize, usize)> =
        pairs.filter(|(_, (a, b))| a != b).map(|(i, _)| (i % size.0, i / size.0)).collect();
    let columns = || changed.iter().map(|place| place.0);
    let rows = || changed.iter().map(|place| place.1);
    Some([columns().min()?, rows().min()?, columns().max()?, rows().max()?])
}

#[test]
fn a_figure_at_a_keyframe_is_bright_green_in_both_styles() {
    let bone = Bone {
        from: Vec3::new(-1.0, 1.0, 0.0),
        to: Vec3::new(1.0, 1.0, 0.0),
        side: Side::Left,
        radius: 0.2,
        joints: (0, 1),
    };
    for style in [Style::Lit, Style::Lines] {
        let green = |look: Look| {
            let figure = Figure { look, bones: vec![bone], ..figure(vec![]) };
            let canvas = drawn(&Scene { style, ..scene(vec![figure]) }, SIZE);
            let is_green = |color: Color| {
                let [red, green, blue] = color.channels();
                green > 150 && u32::from(green) > 2 * u32::from(red.max(blue))
            };
            places(&canvas, is_green).len()
        };
        assert!(green(Look::Flash) > 400, "{style:?}: {}", green(Look::Flash));
        assert_eq!(green(Look::Solid), 0, "{style:?}");
    }
}

#[test]
fn an_error_vector_is_magenta_from_end_to_end_even_within_a_body() {
    let (from, to) = (Vec3::new(-0.3, 1.0, 0.0), Vec3::new(0.4, 1.2, 0.1));
    let body = Bone { from: -to, to: to * 1.5, side: Side::Right, radius: 0.3, joints: (0, 1) };
    for (style, bones) in [(Style::Lines, vec![]), (Style::Lines, vec![body]), (Style::Lit, vec![body])] {
        let mut scene = Scene { style, ..scene(vec![Figure { bones, ..figure(vec![]) }]) };
        scene.marks.push(vector(from, to));
        let canvas = drawn(&scene, SIZE);
        let magenta = places(&canvas, |color| color == color_of(Tint::Error));
        let view = scene.camera.view(SIZE);
        for share in [0.02, 0.3, 0.7, 0.98] {
            let spot = view.project(from.lerp(to, share)).unwrap();
            let near = |(x, y): &(usize, usize)| (*x as f32 - spot.x).hypot(*y as f32 - spot.y) < 2.0;
            assert!(magenta.iter().any(near), "{style:?} at {share}");
        }
    }
}

#[test]
fn a_plot_lies_inside_of_every_picture_that_has_room_for_it() {
    for text_scale in [0.5, 1.0, 2.0] {
        let mut shown = 0;
        for size in [(60, 40), (320, 200), (480, 320), (640, 360), (960, 540), (1280, 720), (2560, 1440)] {
            let Some([left, top, right, bottom]) = extent(text_scale, size) else { continue };
            shown += 1;
            assert!(left > 0 && top > 0 && right + 1 < size.0 && bottom + 1 < size.1, "{size:?}");
        }
        assert!((2..7).contains(&shown), "{shown} at {text_scale}");
    }
    let [left, top, right, bottom] = extent(1.0, SIZE).unwrap();
    let [far_left, far_top, far_right, far_bottom] = extent(2.0, (1920, 1080)).unwrap();
    assert_eq!(far_right - far_left + 1, 2 * (right - left + 1));
    assert_eq!(far_bottom - far_top + 1, 2 * (bottom - top + 1));
}

#[test]
fn curves_rise_to_the_right_one_is_solid_and_the_other_dashed() {
    let canvas = drawn(&with_plot(1.0), SIZE);
    for (representation, solid) in [(Representation::Euler, true), (Representation::Quaternion, false)] {
        let color = colors::curve(stroke_of(representation)).channels();
        let close = |pixel: Color| pixel.channels().iter().zip(color).all(|(a, b)| a.abs_diff(b) < 40);
        let mut curve = places(&canvas, close);
        // Its name stands to the right of it, and at first both lie upon each other.
        let end = places(&canvas, |pixel| pixel == Color::WHITE).iter().map(|place| place.0).min().unwrap();
        curve.retain(|place| (end - 110..end).contains(&place.0));
        curve.sort();
        assert!(curve.len() > 40, "{representation}: {}", curve.len());
        assert!(curve.windows(2).all(|pair| pair[1].1 <= pair[0].1 + 4), "{representation} falls");
        let widest = curve.windows(2).map(|pair| pair[1].0 - pair[0].0).max().unwrap();
        assert_eq!(widest < 3, solid, "{representation}: a gap of {widest} pixels");
    }
}

/// A small plot, as that of a warp.
fn small() -> Scene {
    let mut plot = Plot { small: true, posts: vec![0.25], ..plot() };
    plot.curves.items_mut()[1].stroke = Stroke::Faint;
    Scene { plot: Some(plot), ..scene(Vec::new()) }
}

#[test]
fn a_small_plot_fits_into_half_a_window_and_its_posts_are_green() {
    let size = (640, 720);
    let with = drawn(&small(), size);
    let without = drawn(&Scene { plot: None, ..small() }, size);
    let changed = with.pixels().iter().zip(without.pixels()).enumerate().filter(|(_, (a, b))| a != b);
    let columns: Vec<usize> = changed.map(|(index, _)| index % size.0).collect();
    let (left, right) = (columns.iter().min().unwrap(), columns.iter().max().unwrap());
    assert!(right - left < 250 && *left > 380 && *right < 639, "{left} to {right}");
    let foot = places(&with, |color| color == color_of(Tint::Keyframe));
    assert!((4..40).contains(&foot.len()), "{}", foot.len());
    let line = |color: Color| {
        let [red, green, blue] = color.channels();
        u32::from(green) > u32::from(red.max(blue)) + 40
    };
    let upwards = places(&with, line).iter().map(|place| place.1).collect::<Vec<_>>();
    assert!(upwards.iter().max().unwrap() - upwards.iter().min().unwrap() > 80);
}

#[test]
fn what_others_are_compared_with_is_thinner_than_they_are_and_dashed() {
    let ink = |stroke: Stroke| {
        let mut scene = small();
        let plot = scene.plot.as_mut().unwrap();
        // The other one lies flat below.
        plot.curves.items_mut()[0].points = vec![(0.0, 0.0), (1.0, 0.0)];
        plot.curves.items_mut()[1].stroke = stroke;
        plot.mark = None;
        let canvas = drawn(&scene, (640, 720));
        let color = colors::curve(stroke).channels();
        let close = |pixel: Color| pixel.channels().iter().zip(color).all(|(a, b)| a.abs_diff(b) < 40);
        // Curves, without names above and numbers on the left and below.
        let curve = places(&canvas, close)
            .into_iter()
            .filter(|(x, y)| (440..620).contains(x) && (550..615).contains(y));
        curve.count()
    };
    let [solid, dashed, faint] = [Stroke::Solid, Stroke::Dashed, Stroke::Faint].map(ink);
    assert!(faint > 5 && 4 * faint < 3 * dashed && 4 * dashed < 3 * solid, "{solid}, {dashed}, {faint}");
}

#[test]
fn without_curves_the_plot_says_why() {
    let scene = |note: &str| {
        let plot = Plot { curves: Default::default(), note: note.into(), ..plot() };
        Scene { plot: Some(plot), ..scene(Vec::new()) }
    };
    assert!(drawn(&scene("not yet"), SIZE).pixels() != drawn(&scene(""), SIZE).pixels());
}

proptest! {
    #[test]
    fn no_numbers_make_it_panic(
        raw in prop::array::uniform8(prop_oneof![3 => -0.2f32..1.2, 1 => any::<f32>()]),
        size in (1usize..700, 1usize..500), keyframe in any::<usize>(), words in ".{0,60}",
    ) {
        let mut scene = with_plot(raw[0]);
        scene.keyframes = vec![0, 3, keyframe];
        scene.timeline = Some(Timeline { frame: 3, count: 9, range: (0, 8), playing: false });
        scene.marks.push(vector(Vec3::new(raw[1], raw[2], 0.0), Vec3::new(raw[3], raw[4], raw[5])));
        let plot = scene.plot.as_mut().unwrap();
        plot.mark = Some((raw[1], raw[2]));
        plot.curves.items_mut()[1].points = vec![(raw[3], raw[4]), (raw[5], raw[6]), (raw[7], raw[0])];
        plot.rows.items_mut()[1].at = raw[7];
        plot.columns.items_mut()[1].at = raw[6];
        plot.columns.items_mut()[2].label = words.clone();
        plot.rows.items_mut()[2].label = words;
        drawn(&scene, size);
    }
}
