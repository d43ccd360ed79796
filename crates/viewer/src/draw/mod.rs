//! From a scene to a picture.

mod lit;

use glam::Vec3;

use crate::camera::{Spot, View};
use crate::canvas::{Canvas, Color, Pen, Typeface, Weight};
use crate::panel;
use crate::scene::{Figure, Look, Mark, Off, Scene, Side, Style, Tint};
use lit::Bodies;

/// Draws scenes. Keeps what is slow to make: the letters.
#[derive(Default)]
pub struct Painter {
    typeface: Typeface,
    bodies: Bodies,
}

impl Painter {
    /// A painter; takes some milliseconds.
    pub fn new() -> Painter {
        Painter::default()
    }

    /// Draws `scene` over whatever `canvas` shows.
    pub fn draw(&mut self, scene: &Scene, canvas: &mut Canvas) {
        let view = scene.camera.view(canvas.size());
        let reach = 4.5 * scene.camera.distance;
        canvas.background(&view, scene.ground, reach);
        if scene.style == Style::Lit {
            self.bodies.draw(scene, &view, reach, canvas);
        }

        let mut strokes = Strokes { view, list: Vec::new() };
        for figure in &scene.figures {
            strokes.figure(figure, scene.axis_length);
        }
        for mark in &scene.marks {
            strokes.arrow(mark, scene.axis_length);
        }
        strokes.draw(canvas);

        for figure in &scene.figures {
            self.letters(figure, scene.axis_length, &view, canvas);
        }
        for mark in &scene.marks {
            self.mark_text(mark, &view, canvas);
        }
        panel::draw(&scene.panels, &mut self.typeface, canvas);
    }

    /// Writes one line of dark text on the picture itself; `left` and `baseline` in pixels.
    pub fn caption(
        &mut self,
        text: &str,
        place: (i32, i32),
        size: u32,
        weight: Weight,
        canvas: &mut Canvas,
    ) -> f32 {
        canvas.text(&mut self.typeface, text, place, size, weight, color_of(Tint::Ink))
    }

    fn letters(&mut self, figure: &Figure, axis_length: f32, view: &View, canvas: &mut Canvas) {
        for axes in figure.axes.iter().filter(|axes| axes.lettered) {
            for (unit, tint) in AXES {
                let tip = axes.origin + axes.rotation * unit * axis_length * (LETTERED + 0.35);
                let letter = match tint {
                    Tint::X => "X",
                    Tint::Y => "Y",
                    _ => "Z",
                };
                if let Some(spot) = view.project(tip) {
                    let place = ((spot.x as i32).saturating_sub(5), (spot.y as i32).saturating_add(5));
                    self.haloed(letter, place, Weight::Bold, color_of(tint), canvas);
                }
            }
        }
    }

    fn mark_text(&mut self, mark: &Mark, view: &View, canvas: &mut Canvas) {
        let Some(spot) = view.project(mark.to) else { return };
        let (right, down) = mark.text_offset;
        let width = self.typeface.width(&mark.text, TEXT_SIZE, Weight::Bold) as i32;
        let start = match right.signum() {
            -1 => right - width,
            0 => -width / 2,
            _ => right,
        };
        if down.abs() > 20 && !mark.text.is_empty() {
            let toward = Spot {
                x: spot.x + 0.9 * right as f32,
                y: spot.y + 0.65 * down as f32,
                nearness: spot.nearness,
            };
            canvas.line(spot, toward, Pen { width: 1.0, color: color_of(mark.tint), opacity: 0.6 });
        }
        let left = (spot.x as i32).saturating_add(start);
        let baseline = (spot.y as i32).saturating_add(down.saturating_add(5));
        self.haloed(&mark.text, (left, baseline), Weight::Bold, color_of(mark.tint), canvas);
    }

    /// Text with a light edge, so that it can be read on anything. Nothing, where it would be outside of the picture.
    fn haloed(&mut self, text: &str, (x, y): (i32, i32), weight: Weight, color: Color, canvas: &mut Canvas) {
        let (width, height) = (canvas.size().0 as i32, canvas.size().1 as i32);
        let (room, tall) = (self.typeface.width(text, TEXT_SIZE, weight) as i32 + 2, TEXT_SIZE as i32 + 2);
        if !(-room..=width).contains(&x) || !(-tall..=height + tall).contains(&y) {
            return;
        }
        for (right, down) in [(-1, -1), (1, -1), (-1, 1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0)] {
            let place = (x.saturating_add(right), y.saturating_add(down));
            canvas.text(&mut self.typeface, text, place, TEXT_SIZE, weight, PAPER);
        }
        canvas.text(&mut self.typeface, text, (x, y), TEXT_SIZE, weight, color);
    }
}

/// The height of letters in the world, in pixels.
const TEXT_SIZE: u32 = 15;

const PAPER: Color = Color(0xF4_F6_F7);
const SQUARE_BORDER: Color = Color(0x3B_0F_63);

/// The colours, chosen so that they stay apart for colour-blind eyes, in their lightness if not in their hue.
pub fn color_of(tint: Tint) -> Color {
    match tint {
        Tint::Joint => Color(0x8A_2B_D8),
        Tint::Bone(Side::Left) => Color(0xD9_7A_18),
        Tint::Bone(Side::Right) => Color(0x2F_7F_D0),
        Tint::Bone(Side::Middle) => Color(0x39_43_50),
        Tint::Off(Off::Right) => Color(0x8A_2B_D8),
        Tint::Off(Off::Little) => Color(0xFF_E4_5C),
        Tint::Off(Off::Some) => Color(0xE0_44_2E),
        Tint::Off(Off::Much) => Color(0x3A_0A_0A),
        Tint::Ghost => Color(0x0E_8F_83),
        Tint::X => Color(0xC8_1E_1E),
        Tint::Y => Color(0x2F_B3_44),
        Tint::Z => Color(0x22_3F_D6),
        Tint::Ink => Color(0x22_2A_35),
    }
}

/// How much longer axes with letters are than others.
const LETTERED: f32 = 1.6;

const AXES: [(Vec3, Tint); 3] = [(Vec3::X, Tint::X), (Vec3::Y, Tint::Y), (Vec3::Z, Tint::Z)];

/// Lines and squares, collected so that they can be drawn from far to near: the soft edge of a near one must lie
/// upon the far one, which the depth alone does not bring about.
struct Strokes {
    view: View,
    list: Vec<Stroke>,
}

#[derive(PartialEq)]
enum Stroke {
    Line(Spot, Spot, Pen),
    Square(Spot, f32),
}

impl Stroke {
    fn nearness(&self) -> f32 {
        match self {
            Stroke::Line(from, to, _) => 0.5 * (from.nearness + to.nearness),
            Stroke::Square(centre, _) => centre.nearness,
        }
    }
}

/// What shares a place is told apart by moving it a little: squares lie before axes, axes before bones, bones before
/// the ghost.
const SQUARES_FORWARD: f32 = 1.02;
const AXES_FORWARD: f32 = 1.01;
const GHOST_BACK: f32 = 0.995;

impl Strokes {
    fn figure(&mut self, figure: &Figure, axis_length: f32) {
        let (width, opacity, forward) = match figure.look {
            Look::Solid => (3.5, 1.0, 1.0),
            Look::Dimmed => (3.5, 0.4, 1.0),
            Look::Ghost => (3.0, 0.55, GHOST_BACK),
            Look::Echo(strength) => (2.5, 0.55 * strength, GHOST_BACK),
        };
        for bone in &figure.bones {
            let tint = match figure.look {
                Look::Ghost => Tint::Ghost,
                Look::Solid | Look::Dimmed | Look::Echo(_) => Tint::Bone(bone.side),
            };
            self.line(bone.from, bone.to, Pen { width, color: color_of(tint), opacity }, forward);
        }
        for axes in &figure.axes {
            let length = if axes.lettered { LETTERED * axis_length } else { axis_length };
            for (unit, tint) in AXES {
                let pen = Pen { width: 2.0, color: color_of(tint), opacity: 1.0 };
                self.line(axes.origin, axes.origin + axes.rotation * unit * length, pen, AXES_FORWARD);
            }
        }
        if figure.look == Look::Solid {
            // About as large as a joint of a body, but never a dot and never a blot.
            let squares = figure.joints.iter().filter_map(|joint| self.view.project(joint.place));
            self.list.extend(squares.map(|mut spot| {
                let side = (0.3 * axis_length * spot.nearness * self.view.focal).clamp(5.0, 9.0);
                spot.nearness *= SQUARES_FORWARD;
                Stroke::Square(spot, side)
            }));
        }
    }

    fn arrow(&mut self, mark: &Mark, axis_length: f32) {
        let Some(from) = mark.from else { return };
        let pen = Pen { width: 2.5, color: color_of(mark.tint), opacity: 1.0 };
        self.line(from, mark.to, pen, AXES_FORWARD);
        // The head lies in the plane of the picture.
        let along = (mark.to - from).normalize_or_zero();
        let across = along.cross(self.view.forward).normalize_or_zero();
        let head = (0.5 * axis_length).min(0.3 * from.distance(mark.to));
        for side in [0.5, -0.5] {
            self.line(mark.to, mark.to - (along - across * side) * head, pen, AXES_FORWARD);
        }
    }

    fn line(&mut self, from: Vec3, to: Vec3, pen: Pen, forward: f32) {
        if let Some((mut from, mut to)) = self.view.project_line(from, to) {
            from.nearness *= forward;
            to.nearness *= forward;
            self.list.push(Stroke::Line(from, to, pen));
        }
    }

    fn draw(mut self, canvas: &mut Canvas) {
        self.list.sort_by(|a, b| a.nearness().total_cmp(&b.nearness()));
        // Joints may share a place: one stroke looks like many upon each other, but for its soft edge.
        self.list.dedup();
        for stroke in self.list {
            match stroke {
                Stroke::Line(from, to, pen) => canvas.line(from, to, pen),
                Stroke::Square(centre, side) => {
                    canvas.square(centre, side, color_of(Tint::Joint), SQUARE_BORDER)
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{LazyLock, Mutex};

    use glam::Quat;
    use proptest::prelude::*;

    use super::*;
    use crate::camera::Camera;
    use crate::canvas::Ground;
    use crate::scene::{Axes, Bone, Corner, Dot, Line};

    /// Draws with one painter for all tests: reading the fonts takes longest.
    fn draw(scene: &Scene, canvas: &mut Canvas) {
        static PAINTER: LazyLock<Mutex<Painter>> = LazyLock::new(Mutex::default);
        PAINTER.lock().unwrap().draw(scene, canvas);
    }

    fn scene(figures: Vec<Figure>) -> Scene {
        Scene {
            camera: Camera { target: Vec3::ZERO, azimuth: 0.3, elevation: 0.2, distance: 10.0 },
            ground: Ground { height: 0.0, cell: 1.0 },
            style: Style::Lines,
            size: 3.0,
            figures: figures.into_iter().collect(),
            axis_length: 0.5,
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
        fn no_numbers_make_it_panic(raw in any::<[f32; 13]>(), size in (1usize..60, 1usize..60)) {
            let [a, b] = [Vec3::new(raw[0], raw[1], raw[2]), Vec3::new(raw[3], raw[4], raw[5])];
            let rotation = Quat::from_xyzw(raw[6], raw[7], raw[8], raw[9]);
            let mut scene = scene(vec![Figure {
                look: Look::Solid,
                bones: vec![
                    Bone { from: a, to: b, side: Side::Left, radius: raw[10], joints: (0, 1) },
                    Bone { from: b, to: Vec3::ZERO, side: Side::Middle, radius: 0.2, joints: (1, 2) },
                ],
                joints: vec![a.into(), b.into()],
                axes: vec![Axes { origin: a, rotation, lettered: true }],
            }]);
            scene.axis_length = raw[10];
            scene.marks.push(Mark { from: Some(a), to: b, text: "x".into(), text_offset: (-3, 2), tint: Tint::Ink });
            let panel = scene.panels.add();
            panel.begin(Corner::BottomRight);
            panel.add(Line::Heading, "long ".repeat(20));
            panel.add(Line::Key("k"), "word ".repeat(9));
            let mut canvas = Canvas::new(size.0, size.1);
            draw(&scene, &mut canvas);
            scene.camera.distance = raw[11];
            scene.camera.target.y = raw[12];
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
        let axes = Axes { origin: bone.to, rotation: Quat::from_rotation_x(0.4), lettered: false };
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
                let axes = vec![Axes { origin, rotation: Quat::IDENTITY, lettered: true }];
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
}
