//! Blocks of text on top of the picture.

use std::fmt::{self, Write};

use super::Tint;

/// A block of text in a corner of the picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Where it is.
    pub corner: Corner,
    text: String,
    /// What each line is, and where it ends in `text`.
    lines: Vec<(Line, usize)>,
}

impl Panel {
    /// Takes all lines out and puts the panel into a corner.
    pub fn begin(&mut self, corner: Corner) {
        self.corner = corner;
        self.text.clear();
        self.lines.clear();
    }

    /// Adds a line.
    pub fn add(&mut self, line: Line, text: impl fmt::Display) {
        // A string takes whatever is written to it.
        let _ = write!(self.text, "{text}");
        self.lines.push((line, self.text.len()));
    }

    /// The lines, from the top.
    pub fn lines(&self) -> impl Iterator<Item = (Line, &str)> {
        let starts = [0].into_iter().chain(self.lines.iter().map(|(_, end)| *end));
        starts.zip(&self.lines).map(|(start, (line, end))| (*line, &self.text[start..*end]))
    }
}

/// A corner of the picture. Two panels in one corner stand below each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Corner {
    /// Above, on the left.
    #[default]
    TopLeft,
    /// Above, on the right.
    TopRight,
    /// Below, on the left.
    BottomLeft,
    /// Below, on the right.
    BottomRight,
}

/// What a line of a panel is. Long ones are broken where the picture ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Bold.
    Heading,
    /// Plain.
    Text,
    /// Less important.
    Quiet,
    /// Something is right.
    Right,
    /// Something is wrong.
    Trouble,
    /// A key, or a name, and what belongs to it.
    Key(&'static str),
    /// A colour and what it stands for.
    Legend(Tint),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_gives_its_lines_back() {
        let mut panel = Panel::default();
        for round in 0..2 {
            panel.begin(Corner::BottomLeft);
            panel.add(Line::Heading, format_args!("round {round}"));
            panel.add(Line::Text, "");
            panel.add(Line::Key("h"), "help");
            let lines: Vec<_> = panel.lines().map(|(line, text)| (line, text.to_owned())).collect();
            let first = format!("round {round}");
            assert_eq!(
                lines,
                [(Line::Heading, first), (Line::Text, String::new()), (Line::Key("h"), "help".into())]
            );
        }
    }
}
