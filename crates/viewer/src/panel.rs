//! Blocks of text in the corners of the picture.

use crate::canvas::{Canvas, Color, Typeface, Weight};
use crate::draw::color_of;
use crate::scene::{Corner, Line, Panel};

/// Sizes in pixels.
const TEXT_SIZE: u32 = 14;
const LINE_HEIGHT: i32 = 20;
const PADDING: i32 = 10;
const MARGIN: i32 = 12;
const SWATCH: i32 = 24;
const WIDEST: i32 = 560;

const BACKDROP: Color = Color(0x1D_24_2E);
const BACKDROP_OPACITY: f32 = 0.82;
const PLAIN: Color = Color(0xE6_EA_EE);
const QUIET: Color = Color(0xB9_C2_CC);
const RIGHT: Color = Color(0x7F_D4_FF);
const WARNING: Color = Color(0xFF_C2_4B);

/// Lays the panels over the picture. Where they do not fit they are cut at its border.
pub fn draw(panels: &[Panel], typeface: &mut Typeface, canvas: &mut Canvas) {
    let (width, height) = (canvas.size().0 as i32, canvas.size().1 as i32);
    let mut tops = [MARGIN; 2];
    let mut bottoms = [height - MARGIN; 2];
    for panel in panels.iter().filter(|panel| panel.lines().next().is_some()) {
        let layout = Layout::new(panel, typeface, (width - 2 * MARGIN).min(WIDEST));
        let (left, upper) = match panel.corner {
            Corner::TopLeft => (MARGIN, tops[0]),
            Corner::TopRight => (width - MARGIN - layout.width, tops[1]),
            Corner::BottomLeft => (MARGIN, bottoms[0] - layout.height),
            Corner::BottomRight => (width - MARGIN - layout.width, bottoms[1] - layout.height),
        };
        match panel.corner {
            Corner::TopLeft => tops[0] += layout.height + MARGIN,
            Corner::TopRight => tops[1] += layout.height + MARGIN,
            Corner::BottomLeft => bottoms[0] -= layout.height + MARGIN,
            Corner::BottomRight => bottoms[1] -= layout.height + MARGIN,
        }
        layout.draw((left, upper), typeface, canvas);
    }
}

/// A panel broken into rows that fit.
struct Layout {
    rows: Vec<Row>,
    width: i32,
    height: i32,
    /// Where the text of a key starts.
    column: i32,
}

struct Row {
    /// What stands before the text, on the first row of a line.
    lead: Lead,
    text: String,
    indent: i32,
    weight: Weight,
    color: Color,
}

enum Lead {
    Nothing,
    Key(&'static str),
    Swatch(Color),
}

impl Layout {
    fn new(panel: &Panel, typeface: &mut Typeface, widest: i32) -> Layout {
        let keys = panel.lines().filter_map(|(line, _)| match line {
            Line::Key(key) => Some(typeface.width(key, TEXT_SIZE, Weight::Bold) as i32),
            _ => None,
        });
        let column = keys.max().unwrap_or(0) + 16;
        let mut layout = Layout { rows: Vec::new(), width: 0, height: 0, column };
        for (line, text) in panel.lines() {
            layout.add(line, text, typeface, widest - 2 * PADDING);
        }
        layout.width += 2 * PADDING;
        layout.height = layout.rows.len() as i32 * LINE_HEIGHT + 2 * PADDING - 4;
        layout
    }

    fn add(&mut self, line: Line, text: &str, typeface: &mut Typeface, room: i32) {
        let (mut lead, indent, weight, color) = match line {
            Line::Heading => (Lead::Nothing, 0, Weight::Bold, Color::WHITE),
            Line::Text => (Lead::Nothing, 0, Weight::Regular, PLAIN),
            Line::Quiet => (Lead::Nothing, 0, Weight::Regular, QUIET),
            Line::Right => (Lead::Nothing, 0, Weight::Regular, RIGHT),
            Line::Trouble => (Lead::Nothing, 0, Weight::Regular, WARNING),
            Line::Key(key) => (Lead::Key(key), self.column, Weight::Regular, QUIET),
            Line::Legend(tint) => (Lead::Swatch(color_of(tint)), SWATCH, Weight::Regular, QUIET),
        };
        for text in typeface.wrap(text, TEXT_SIZE, weight, (room - indent) as f32) {
            let end = indent + typeface.width(text.trim_end(), TEXT_SIZE, weight).ceil() as i32;
            self.width = self.width.max(end);
            let lead = std::mem::replace(&mut lead, Lead::Nothing);
            self.rows.push(Row { lead, text, indent, weight, color });
        }
    }

    fn draw(&self, (left, top): (i32, i32), typeface: &mut Typeface, canvas: &mut Canvas) {
        canvas.rectangle((left, top), (self.width, self.height), BACKDROP, BACKDROP_OPACITY);
        let mut baseline = top + PADDING + TEXT_SIZE as i32 - 2;
        for row in &self.rows {
            let start = left + PADDING;
            match row.lead {
                Lead::Nothing => {}
                Lead::Key(key) => {
                    canvas.text(typeface, key, (start, baseline), TEXT_SIZE, Weight::Bold, Color::WHITE);
                }
                Lead::Swatch(color) => {
                    // On a light ground, as in the scene: some of these colours are dark.
                    canvas.rectangle((start, baseline - 11), (16, 13), Color(0xD6_D9_DB), 1.0);
                    canvas.rectangle((start + 2, baseline - 9), (12, 9), color, 1.0);
                }
            }
            let place = (start + row.indent, baseline);
            canvas.text(typeface, &row.text, place, TEXT_SIZE, row.weight, row.color);
            baseline += LINE_HEIGHT;
        }
    }
}
