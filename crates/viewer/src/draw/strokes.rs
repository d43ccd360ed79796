//! Lines and squares: bones without a body, the goal, trails, joints, axes and arrows.

use glam::{Vec2, Vec3};

use super::AXES;
use super::colors::{self, PALE, PAPER, color_of};
use super::lit::cover;
use crate::camera::{Spot, View};
use crate::draw::canvas::{Canvas, Color, Pen};
use crate::scene::{Axes, Figure, Look, Mark, Off, Scene, Style, Tint, Trail};

/// Lines and squares, collected so that they can be drawn from far to near: the soft edge of a near one must lie
/// upon the far one, which the depth alone does not bring about. The memory is kept from picture to picture.
#[derive(Default)]
pub(super) struct Strokes {
    list: Vec<Stroke>,
    /// How near each stroke is, and where it is in the list.
    order: Vec<(f32, usize)>,
    /// How far bodies reach in front of each joint of a figure, in world units.
    covers: Vec<f32>,
}

#[derive(Clone, Copy, PartialEq)]
enum Stroke {
    Line(Spot, Spot, Pen),
    /// A piece of a longer line, without round ends: where pieces meet, none lies upon the other.
    Piece(Spot, Spot, Pen),
    Square {
        centre: Spot,
        side: f32,
        fill: Color,
        border: Color,
    },
}

impl Stroke {
    fn nearness(&self) -> f32 {
        match self {
            Stroke::Line(from, to, _) | Stroke::Piece(from, to, _) => 0.5 * (from.nearness + to.nearness),
            Stroke::Square { centre, .. } => centre.nearness,
        }
    }
}

/// What shares a place is told apart by moving it a little: squares lie before axes, axes before bones, bones before
/// the ghost.
const SQUARES_FORWARD: f32 = 1.02;
const FRAMES_FORWARD: f32 = 1.015;
const AXES_FORWARD: f32 = 1.01;
const GHOST_BACK: f32 = 0.995;
const ERRORS_FORWARD: f32 = 1.15;

impl Strokes {
    /// Draws all lines and squares of `scene`; `scale` is how large they are.
    pub fn draw(&mut self, scene: &Scene, view: &View, scale: f32, canvas: &mut Canvas) {
        self.list.clear();
        // As many as the scene has when all of it is seen: how many there are changes from picture to picture.
        let pieces = scene.trails.iter().map(|trail| trail.points.len());
        let parts =
            |figure: &Figure| 2 * figure.bones.len() + 3 * figure.axes.len() + 2 * figure.joints.len();
        let most = pieces.chain(scene.figures.iter().map(parts)).sum::<usize>() + 6 * scene.marks.len();
        self.list.reserve(most);
        self.order.clear();
        self.order.reserve(most);
        let mut pencil = Pencil { view, scale, size: scene.size, list: &mut self.list };
        for trail in &scene.trails {
            pencil.trail(trail);
        }
        for figure in &scene.figures {
            self.covers.clear();
            let is_body = scene.style == Style::Lit && figure.look.is_solid();
            if is_body {
                cover(figure, view, &mut self.covers);
            } else {
                pencil.bones(figure, scene.style);
            }
            pencil.all_axes(figure, &self.covers);
            if figure.look.is_solid() {
                pencil.squares(figure, &self.covers);
            }
        }
        for mark in &scene.marks {
            pencil.arrow(mark);
        }
        self.draw_list(canvas);
    }

    fn draw_list(&mut self, canvas: &mut Canvas) {
        self.order.extend(self.list.iter().enumerate().map(|(index, stroke)| (stroke.nearness(), index)));
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut before = None;
        for &(_, index) in &self.order {
            let stroke = self.list[index];
            // Joints may share a place: one stroke looks like many upon each other, but for its soft edge.
            if before == Some(stroke) {
                continue;
            }
            match stroke {
                Stroke::Line(from, to, pen) => canvas.line(from, to, pen),
                Stroke::Piece(from, to, pen) => canvas.piece(from, to, pen),
                Stroke::Square { centre, side, fill, border } => canvas.square(centre, side, fill, border),
            }
            before = Some(stroke);
        }
    }
}

/// Adds to the list.
struct Pencil<'a> {
    view: &'a View,
    scale: f32,
    /// How large a figure is.
    size: f32,
    list: &'a mut Vec<Stroke>,
}

impl Pencil<'_> {
    fn bones(&mut self, figure: &Figure, style: Style) {
        let (width, opacity, forward) = match figure.look {
            Look::Solid | Look::Flash => (3.5, 1.0, 1.0),
            Look::Dimmed => (3.5, 0.4, 1.0),
            Look::Ghost => (3.0, 0.55, GHOST_BACK),
            Look::Echo(strength) => (2.5, 0.55 * strength, GHOST_BACK),
        };
        for bone in &figure.bones {
            let tint = match figure.look {
                Look::Ghost => Tint::Ghost,
                Look::Flash => Tint::Keyframe,
                Look::Solid | Look::Dimmed | Look::Echo(_) => Tint::Bone(bone.side),
            };
            let color = color_of(tint);
            let pen = Pen { width: width * self.scale, color, opacity };
            let middle = self.view.project(bone.from.midpoint(bone.to));
            match (style, middle) {
                (Style::Lit, Some(middle)) => {
                    // A tube that is thinner than the body would be, so that it is inside of one in the same pose.
                    let body = 2.0 * bone.radius * middle.nearness * self.view.focal;
                    let width = (0.55 * body).clamp(1.5, 7.0 * self.scale);
                    self.line(bone.from, bone.to, Pen { width, opacity: 0.85 * opacity, ..pen }, forward);
                    let light = Pen { width: 0.35 * width, color: color.mix(Color::WHITE, 0.55), ..pen };
                    if width > 2.5 {
                        self.line(bone.from, bone.to, light, forward * 1.0005);
                    }
                }
                _ => self.line(bone.from, bone.to, pen, forward),
            }
        }
    }

    /// The path of an End Site, fainter the longer ago it was there.
    fn trail(&mut self, trail: &Trail) {
        let color = colors::trail(trail);
        let count = trail.points.len();
        let mut start = 0;
        for end in 1..count {
            let Some((from, to)) = self.view.project_line(trail.points[start], trail.points[end]) else {
                start = end;
                continue;
            };
            // Steps of less than some pixels are taken together.
            let apart = Vec2::new(to.x - from.x, to.y - from.y).length();
            if apart < 3.0 * self.scale && end + 1 < count {
                continue;
            }
            let age = 1.0 - end as f32 / (count - 1) as f32;
            let opacity = 0.08 + 0.82 * (1.0 - age) * (1.0 - 0.4 * age);
            self.list.push(Stroke::Piece(from, to, Pen { width: 1.6 * self.scale, color, opacity }));
            start = end;
        }
    }

    fn all_axes(&mut self, figure: &Figure, covers: &[f32]) {
        // Axes stand in the order of their joints.
        let mut joints = figure.joints.iter().zip(covers);
        for axes in figure.axes.iter().filter(|axes| axes.origin.is_finite()) {
            let joint = joints.by_ref().find(|(joint, _)| joint.place == axes.origin);
            self.axes(axes, figure.look, joint.map_or(0.0, |(_, cover)| *cover));
        }
    }

    fn axes(&mut self, axes: &Axes, look: Look, cover: f32) {
        for (unit, tint) in AXES {
            let color = if look == Look::Dimmed { color_of(tint).mix(PALE, 0.5) } else { color_of(tint) };
            let pen = Pen { width: 2.0 * self.scale, color, opacity: 1.0 };
            let tip = axes.origin + axes.rotation * unit * axes.length;
            if let Some((from, to)) = self.view.project_line(axes.origin, tip) {
                let [from, to] = [from, to].map(|spot| towards(spot, cover, AXES_FORWARD));
                self.list.push(Stroke::Line(from, to, pen));
            }
        }
    }

    fn squares(&mut self, figure: &Figure, covers: &[f32]) {
        for (index, joint) in figure.joints.iter().enumerate() {
            let Some(spot) = self.view.project(joint.place) else { continue };
            // About as large as a joint of a body, but never a dot and never a blot.
            let room = 0.0135 * self.size * spot.nearness * self.view.focal;
            let (mut fill, mut border, larger) = colors::square_of(joint.off);
            if figure.look == Look::Dimmed && joint.off == Off::Right {
                (fill, border) = (fill.mix(PALE, 0.5), border.mix(PALE, 0.5));
            }
            let side = room.clamp(5.0 * self.scale, 9.0 * self.scale) * larger;
            let cover = covers.get(index).copied().unwrap_or(0.0);
            let square = |side, fill, border, forward| Stroke::Square {
                centre: towards(spot, cover, forward),
                side,
                fill,
                border,
            };
            if joint.selected {
                let frame = side + 8.0 * self.scale;
                self.list.push(square(frame, Color::WHITE, color_of(Tint::Ink), FRAMES_FORWARD));
            }
            self.list.push(square(side, fill, border, SQUARES_FORWARD));
        }
    }

    fn arrow(&mut self, mark: &Mark) {
        let Some(from) = mark.from else { return };
        let pen = Pen { width: 2.5 * self.scale, color: color_of(mark.tint), opacity: 1.0 };
        if mark.tint == Tint::Error {
            // Short ones lie within the body: they are drawn before it, with an edge that sets them off.
            let Some((a, b)) = self.view.project_line(from, mark.to) else { return };
            let long = Vec2::new(b.x - a.x, b.y - a.y).length();
            let width = (0.4 * long).clamp(1.5 * self.scale, 3.0 * self.scale);
            let edge = Pen { width: width + 2.5 * self.scale, color: PAPER, ..pen };
            self.shaft_and_head(from, mark.to, edge, ERRORS_FORWARD * 0.999);
            self.shaft_and_head(from, mark.to, Pen { width, ..pen }, ERRORS_FORWARD);
            return;
        }
        self.shaft_and_head(from, mark.to, pen, AXES_FORWARD);
    }

    fn shaft_and_head(&mut self, from: Vec3, to: Vec3, pen: Pen, forward: f32) {
        self.line(from, to, pen, forward);
        // The head lies in the plane of the picture.
        let along = (to - from).normalize_or_zero();
        let across = along.cross(self.view.forward).normalize_or_zero();
        let head = (0.0225 * self.size).min(0.3 * from.distance(to));
        for side in [0.5, -0.5] {
            self.line(to, to - (along - across * side) * head, pen, forward);
        }
    }

    fn line(&mut self, from: Vec3, to: Vec3, pen: Pen, forward: f32) {
        if let Some((mut from, mut to)) = self.view.project_line(from, to) {
            from.nearness *= forward;
            to.nearness *= forward;
            self.list.push(Stroke::Line(from, to, pen));
        }
    }
}

/// The same spot, nearer by `cover` in world units, and then `forward` times as near.
fn towards(spot: Spot, cover: f32, forward: f32) -> Spot {
    // Never more than most of the way to the camera.
    let left = (1.0 - cover * spot.nearness).max(0.1);
    Spot { nearness: spot.nearness / left * forward, ..spot }
}
