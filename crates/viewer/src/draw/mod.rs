//! From a scene to a picture.

pub mod canvas;
mod colors;
mod lit;
mod panel;
mod plot;
pub mod ruler;
mod strokes;
#[cfg(test)]
mod tests;
pub mod timeline;
mod words;

use glam::Vec3;

use crate::scene::{Scene, Style, Tint};
use canvas::{Canvas, Typeface, Weight};
pub use colors::color_of;
use lit::Bodies;
use panel::Panels;
pub(crate) use panel::fit;
use strokes::Strokes;
use timeline::Bar;
use words::Writer;

/// Draws scenes. Keeps what is slow to make, the letters, and all memory that drawing takes: a scene much like one
/// that was drawn before takes no new memory.
#[derive(Default)]
pub struct Painter {
    typeface: Typeface,
    bodies: Bodies,
    strokes: Strokes,
    panels: Panels,
}

impl Painter {
    /// A painter; takes some milliseconds.
    pub fn new() -> Painter {
        Painter::default()
    }

    /// Draws `scene` over whatever `canvas` shows.
    pub fn draw(&mut self, scene: &Scene, canvas: &mut Canvas) {
        let view = scene.camera.view(canvas.size());
        let scale = usable_scale(scene.text_scale);
        let reach = 4.5 * scene.camera.distance;
        canvas.background(&view, scene.ground, reach);
        if scene.style == Style::Lit {
            self.bodies.draw(scene, &view, reach, canvas);
        }
        self.strokes.draw(scene, &view, scale, canvas);

        let mut writer = Writer { typeface: &mut self.typeface, view: &view, scale };
        for figure in &scene.figures {
            writer.axes(figure, canvas);
        }
        for mark in &scene.marks {
            writer.mark(mark, canvas);
        }
        // From the bottom up: the timeline, the ruler, and panels.
        let size = canvas.size();
        let timeline = scene.timeline.as_ref();
        let bar = timeline.and_then(|timeline| Some((timeline, Bar::new(timeline, size, scale)?)));
        let bottom = bar.map_or(size.1 as i32, |(_, bar)| bar.top as i32);
        if let Some(ruler) = &scene.scale_bar {
            let length = ruler::pixels(ruler.length, &scene.camera, &view);
            let right = Panels::left_of_plot(scene.plot.as_ref(), scale, size);
            ruler::draw(ruler, length, scale, (right, bottom), &mut self.typeface, canvas);
        }
        self.panels.draw((&scene.panels, scene.plot.as_ref()), scale, bottom, &mut self.typeface, canvas);
        if let Some((timeline, bar)) = bar {
            bar.draw(timeline, &scene.keyframes, &mut self.typeface, canvas);
        }
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
}

/// How large texts, lines and margins are, when this was asked for.
fn usable_scale(text_scale: f32) -> f32 {
    if text_scale.is_nan() { 1.0 } else { text_scale.clamp(0.5, 4.0) }
}

const AXES: [(Vec3, Tint); 3] = [(Vec3::X, Tint::X), (Vec3::Y, Tint::Y), (Vec3::Z, Tint::Z)];
