//! One pose as a small drawing: the student's over the reference's, seen from the same place at the same size.

use std::fmt::Write;

use maud::{Markup, html};

use crate::Picture;

/// From where, and how large, all poses are drawn.
pub(super) struct View {
    center: [f64; 2],
    scale: f64,
    /// The reference's lines, if there is one.
    reference: Option<String>,
}

/// A drawing is this wide and high.
const WIDTH: f64 = 72.0;
const HEIGHT: f64 = 96.0;
const VIEW_BOX: &str = "0 0 72 96";
/// So much of it is left free around the reference.
const MARGIN: f64 = 12.0;
/// Nothing is drawn farther out than this many times the drawing.
const FAR: f64 = 20.0;

impl View {
    pub fn of(reference: Option<&Picture>) -> View {
        let mut view = View { center: [0.0; 2], scale: 1.0, reference: None };
        if let Some(picture) = reference {
            view.fit(picture);
            view.reference = Some(view.lines(picture).path);
        }
        view
    }

    /// A figure fills the drawing but for its margin.
    fn fit(&mut self, picture: &Picture) {
        let seen = picture.points.iter().filter_map(seen);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in seen {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let size = [high[0] - low[0], high[1] - low[1]];
        if size[0].is_finite() && size[1].is_finite() {
            self.center = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
            let room = [WIDTH - 2.0 * MARGIN, HEIGHT - 2.0 * MARGIN];
            let scale = (room[0] / size[0]).min(room[1] / size[1]);
            self.scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        }
    }

    /// Where a point is in the drawing; nothing when it is no number or far outside.
    fn place(&self, point: &[f32; 3]) -> Option<[f64; 2]> {
        let [x, y] = seen(point)?;
        let x = WIDTH / 2.0 + (x - self.center[0]) * self.scale;
        let y = HEIGHT / 2.0 - (y - self.center[1]) * self.scale;
        (x.abs() < FAR * WIDTH && y.abs() < FAR * HEIGHT).then_some([x, y])
    }

    fn lines(&self, picture: &Picture) -> Lines {
        let places: Vec<_> = picture.points.iter().map(|point| self.place(point)).collect();
        let mut lines = Lines { path: String::new(), undrawn: 0 };
        lines.undrawn = places.iter().filter(|place| place.is_none()).count();
        for (from, to) in &picture.bones {
            let end = |index: &u16| places.get(usize::from(*index)).copied().flatten();
            if let (Some(from), Some(to)) = (end(from), end(to)) {
                let [[a, b], [c, d]] = [from, to].map(|place| place.map(rounded));
                // Writing to a String does not fail.
                let _ = write!(lines.path, "M{a} {b}L{c} {d}");
            }
        }
        lines
    }

    /// The reference's pose, once, for all drawings to use.
    pub fn shared(&self) -> Markup {
        html! {
            @if let Some(path) = &self.reference {
                svg.shared width="0" height="0" aria-hidden="true" {
                    defs { path #goal d=(path) {} }
                }
            }
        }
    }

    /// The student's pose over the reference's.
    pub fn small(&self, picture: &Picture) -> Markup {
        let drawing = self.drawing(picture);
        html! {
            svg.pose viewBox=(VIEW_BOX) width="45" height="60" role="img" aria-label=(drawing.words) {
                title { (drawing.words) }
                @if self.reference.is_some() { use.goal href="#goal" {} }
                (drawing.lines)
            }
        }
    }

    /// The reference's pose and the student's, larger.
    pub fn side_by_side(&self, picture: &Picture) -> Markup {
        let drawing = self.drawing(picture);
        html! {
            div.poses {
                @if self.reference.is_some() {
                    figure {
                        svg.pose viewBox=(VIEW_BOX) width="144" height="192" aria-hidden="true" { use.own href="#goal" {} }
                        figcaption { "the reference" }
                    }
                }
                figure {
                    svg.pose viewBox=(VIEW_BOX) width="144" height="192" aria-hidden="true" { (drawing.lines) }
                    figcaption { (drawing.words) }
                }
            }
        }
    }

    fn drawing(&self, picture: &Picture) -> Drawing {
        let mut own = View { center: [0.0; 2], scale: 1.0, reference: None };
        let view = if self.reference.is_some() {
            self
        } else {
            own.fit(picture);
            &own
        };
        let Lines { path, undrawn } = view.lines(picture);
        let joints = picture.points.len();
        if self.reference.as_ref() == Some(&path) && undrawn == 0 {
            let lines = html! { use.own href="#goal" {} };
            return Drawing { lines, words: "like the reference".to_owned() };
        }
        let lines = html! {
            @if !path.is_empty() { path.own d=(path) {} }
            @if undrawn > 0 { text x="5" y="16" { (undrawn) "?" } }
        };
        let words = match (undrawn, path.is_empty()) {
            (0, _) => "the student's".to_owned(),
            (_, true) => "the student's, which cannot be drawn".to_owned(),
            (_, false) => format!("the student's, of which {undrawn} of {joints} joints cannot be drawn"),
        };
        Drawing { lines, words }
    }
}

/// The student's part of a picture, and what is to be said of it.
struct Drawing {
    lines: Markup,
    words: String,
}

struct Lines {
    path: String,
    undrawn: usize,
}

/// A point as it is seen: from the front, a little from the side and from above, so that depth shows. Nothing when it is no number.
fn seen(point: &[f32; 3]) -> Option<[f64; 2]> {
    let [x, y, z] = point.map(f64::from);
    // A sixth of a half turn to the side, a twelfth down.
    let (side, depth) = (x * 0.866 + z * 0.5, z * 0.866 - x * 0.5);
    let up = y * 0.966 - depth * 0.259;
    (side.is_finite() && up.is_finite()).then_some([side, up])
}

/// A tenth of a pixel is enough. What rounds to zero has no sign.
fn rounded(value: f64) -> f64 {
    (value * 10.0).round() / 10.0 + 0.0
}
