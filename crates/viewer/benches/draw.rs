//! How long pictures take to draw, next to the lines of the first of them drawn by tiny-skia, in the same run.
//!
//! `cargo bench -p viewer --bench draw` prints the medians of interleaved rounds in milliseconds, and how many times
//! tiny-skia's time each takes: the median of the ratios in each round. It fails when that is more than it should be.
//!
//! Our pictures hold everything: sky and ground, figure, goal, axes, squares, trails, panels, timeline and ruler, all
//! tested against depth. tiny-skia draws the grid's lines that can be seen, bones, goal, axes and trails as anti-aliased
//! strokes over a plain background: one path and one call for all lines of a colour and a width, into a pixmap that is
//! kept, with its `simd` feature on. It draws no text, no squares and no ground that fades, and knows no depth.
#![allow(clippy::unwrap_used)]

#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use glam::Vec3;
use tiny_skia::{Paint, Path, PathBuilder, Pixmap, Stroke, Transform};
use viewer::camera::View;
use viewer::draw::canvas::{Canvas, Color};
use viewer::draw::{Painter, color_of};
use viewer::scene::{Look, Scene, Style, Tint};

const ROUNDS: usize = 61;
const FRAME: usize = 300;
const SIZE: (usize, usize) = (1280, 720);
const LARGE: (usize, usize) = (1920, 1080);

/// A picture that is measured, and how many times tiny-skia's time it may take.
struct Case {
    title: &'static str,
    scene: Scene,
    canvas: Canvas,
    aim: f64,
    times: Vec<f64>,
}

fn main() -> ExitCode {
    // `cargo test --benches` only wants to know whether this runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { ROUNDS } else { 1 };
    let stage = support::stage();
    let case = |title, style, size: (usize, usize), closer: f32, aim| {
        let mut scene = support::everything(&stage, FRAME, style, size);
        scene.camera.distance *= closer;
        Case { title, scene, canvas: Canvas::new(size.0, size.1), aim, times: Vec::new() }
    };
    let mut cases = [
        case("lines, 1280 x 720", Style::Lines, SIZE, 1.0, 0.6),
        case("lit, 1280 x 720", Style::Lit, SIZE, 1.0, 1.8),
        case("lit, close up, 1280 x 720", Style::Lit, SIZE, 0.25, 3.0),
        case("lit, 1920 x 1080", Style::Lit, LARGE, 1.0, 3.0),
    ];
    let mut painter = Painter::new();
    let mut pixmap = Pixmap::new(SIZE.0 as u32, SIZE.1 as u32).unwrap();
    let mut theirs = Vec::new();
    for round in 0..rounds + 2 {
        let time = milliseconds(|| draw_lines(&cases[0].scene, &mut pixmap));
        let keep = |times: &mut Vec<f64>, time| {
            if round >= 2 || rounds == 1 {
                times.push(time)
            }
        };
        keep(&mut theirs, time);
        for case in &mut cases {
            let time = milliseconds(|| painter.draw(&case.scene, &mut case.canvas));
            keep(&mut case.times, time);
        }
    }
    save(&cases, &pixmap);

    println!("{:<28} {:>7.2} ms", "tiny-skia, lines alone", median(theirs.clone()));
    let mut slow = false;
    for case in &cases {
        let ratio = median(case.times.iter().zip(&theirs).map(|(ours, theirs)| ours / theirs).collect());
        let ours = median(case.times.clone());
        println!("{:<28} {ours:>7.2} ms {ratio:>6.2}× (at most {})", case.title, case.aim);
        if rounds > 1 && ratio > case.aim {
            println!("  TOO SLOW: it should take at most {} times tiny-skia's time", case.aim);
            slow = true;
        }
    }
    if slow { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

fn milliseconds(draw: impl FnOnce()) -> f64 {
    let start = Instant::now();
    draw();
    start.elapsed().as_secs_f64() * 1e3
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Writes the pictures into the folder that `DRAW_BENCH_PICTURES` names, to be looked at.
fn save(cases: &[Case], pixmap: &Pixmap) {
    let Some(folder) = std::env::var_os("DRAW_BENCH_PICTURES").map(std::path::PathBuf::from) else { return };
    for (index, case) in cases.iter().enumerate() {
        viewer::output::picture::save(&case.canvas, &folder.join(format!("ours-{index}.png"))).unwrap();
    }
    let mut canvas = Canvas::new(SIZE.0, SIZE.1);
    for (index, pixel) in pixmap.pixels().iter().enumerate() {
        let color = Color(u32::from_be_bytes([0, pixel.red(), pixel.green(), pixel.blue()]));
        let place = ((index % SIZE.0) as i32, (index / SIZE.0) as i32);
        canvas.rectangle(place, (1, 1), color, 1.0);
    }
    viewer::output::picture::save(&canvas, &folder.join("theirs.png")).unwrap();
}

/// The lines of `scene` by tiny-skia.
fn draw_lines(scene: &Scene, pixmap: &mut Pixmap) {
    let view = scene.camera.view((pixmap.width() as usize, pixmap.height() as usize));
    pixmap.fill(paint_color(Color(0xD6_D9_DB), 1.0));
    draw_grid(scene, &view, pixmap);
    for figure in &scene.figures {
        let ghost = figure.look == Look::Ghost;
        let mut sides = [viewer::scene::Side::Left, viewer::scene::Side::Right, viewer::scene::Side::Middle]
            .map(|side| (side, PathBuilder::new()));
        for bone in &figure.bones {
            let (_, path) = sides.iter_mut().find(|(side, _)| *side == bone.side).unwrap();
            add(path, &view, bone.from, bone.to);
        }
        for (side, path) in sides {
            let tint = if ghost { Tint::Ghost } else { Tint::Bone(side) };
            stroke(path, color_of(tint), 3.5, if ghost { 0.55 } else { 1.0 }, pixmap);
        }
        for (unit, tint) in [(Vec3::X, Tint::X), (Vec3::Y, Tint::Y), (Vec3::Z, Tint::Z)] {
            let mut path = PathBuilder::new();
            for axes in &figure.axes {
                add(&mut path, &view, axes.origin, axes.origin + axes.rotation * unit * axes.length);
            }
            stroke(path, color_of(tint), 2.0, 1.0, pixmap);
        }
    }
    for trail in &scene.trails {
        let mut path = PathBuilder::new();
        for (index, point) in trail.points.iter().enumerate() {
            let Some(spot) = view.project(*point) else { continue };
            if index == 0 { path.move_to(spot.x, spot.y) } else { path.line_to(spot.x, spot.y) }
        }
        stroke(path, Color(0xC0_30_5A), 1.6, 0.6, pixmap);
    }
    black_box(pixmap);
}

/// The lines of the ground within the distance at which nine tenths of them have faded.
fn draw_grid(scene: &Scene, view: &View, pixmap: &mut Pixmap) {
    let (cell, height) = (scene.ground.cell, scene.ground.height);
    let reach = 1.5 * 4.5 * scene.camera.distance;
    let count = (reach / cell) as i32;
    let middle = (scene.camera.target / cell).round();
    let mut paths = [PathBuilder::new(), PathBuilder::new()];
    for step in -count..=count {
        let half = (reach * reach - (step as f32 * cell).powi(2)).max(0.0).sqrt();
        let (x, z) = ((middle.x + step as f32) * cell, (middle.z + step as f32) * cell);
        let (across, along) = (middle.x * cell, middle.z * cell);
        let strong = |number: f32| usize::from((number + step as f32).rem_euclid(5.0) == 0.0);
        let path = &mut paths[strong(middle.x)];
        add(path, view, Vec3::new(x, height, along - half), Vec3::new(x, height, along + half));
        let path = &mut paths[strong(middle.z)];
        add(path, view, Vec3::new(across - half, height, z), Vec3::new(across + half, height, z));
    }
    let [weak, strong] = paths;
    stroke(weak, Color(0xAE_B5_BE), 1.0, 1.0, pixmap);
    stroke(strong, Color(0x84_8D_99), 2.0, 1.0, pixmap);
}

fn add(path: &mut PathBuilder, view: &View, from: Vec3, to: Vec3) {
    if let Some((from, to)) = view.project_line(from, to) {
        path.move_to(from.x, from.y);
        path.line_to(to.x, to.y);
    }
}

fn stroke(path: PathBuilder, color: Color, width: f32, opacity: f32, pixmap: &mut Pixmap) {
    let Some(path): Option<Path> = path.finish() else { return };
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(paint_color(color, opacity));
    let stroke = Stroke { width, ..Stroke::default() };
    pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
}

fn paint_color(color: Color, opacity: f32) -> tiny_skia::Color {
    let [red, green, blue] = color.channels();
    tiny_skia::Color::from_rgba8(red, green, blue, (opacity * 255.0) as u8)
}
