//! Text on top of the picture.

use std::collections::HashMap;
use std::ops::Range;

use fontdue::{Font, FontSettings};

use super::{Canvas, Color};

/// Regular or bold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Weight {
    /// Regular.
    Regular,
    /// Bold.
    Bold,
}

/// The letters of all text, DejaVu Sans, with those that have been drawn kept ready.
pub struct Typeface {
    regular: Option<Font>,
    bold: Option<Font>,
    letters: HashMap<(char, Weight, u32), Letter>,
}

/// One drawn letter.
#[derive(Default)]
struct Letter {
    /// In pixels. The top is counted from the baseline, downwards.
    left: i32,
    top: i32,
    width: usize,
    /// The share of each pixel that the letter covers, 255 for all of it, row by row.
    coverage: Vec<u8>,
    /// How far the next letter is away, in pixels.
    advance: f32,
}

/// Keeps the memory for drawn letters small when a text in some other script is very long.
const MOST_LETTERS: usize = 4096;

impl Default for Typeface {
    fn default() -> Self {
        Typeface::new()
    }
}

impl Typeface {
    /// Reads the letters. Takes some milliseconds: make one and keep it.
    pub fn new() -> Typeface {
        // The fonts are part of the program: that they can be read is tested below. If they could not, the viewer
        // would still show its figures, without text.
        let read = |bytes: &[u8]| Font::from_bytes(bytes, FontSettings::default()).ok();
        Typeface {
            regular: read(dejavu::sans::regular()),
            bold: read(dejavu::sans::bold()),
            letters: HashMap::new(),
        }
    }

    /// A typeface that writes nothing, for tests: reading the fonts takes longest.
    #[cfg(test)]
    pub(crate) fn without_letters() -> Typeface {
        Typeface { regular: None, bold: None, letters: HashMap::new() }
    }

    /// How long `text` is, in pixels, with letters of `size` pixels.
    pub fn width(&mut self, text: &str, size: u32, weight: Weight) -> f32 {
        text.chars().map(|char| self.letter(char, size, weight).advance).sum()
    }

    /// Breaks `text` between words into lines of at most `width` pixels and adds where in `text` each of them is to
    /// `lines`. A word that is longer is broken anywhere.
    pub fn wrap(&mut self, text: &str, size: u32, weight: Weight, width: f32, lines: &mut Vec<Range<usize>>) {
        let mut next = 0;
        for paragraph in text.split_inclusive('\n') {
            let (mut start, mut end, mut room) = (next, next, width);
            next += paragraph.len();
            for word in paragraph.trim_end_matches(['\n', '\r']).split_inclusive(' ') {
                if end > start && self.width(word.trim_end(), size, weight) > room {
                    lines.push(start..end);
                    (start, room) = (end, width);
                }
                end += word.len();
                while let Some(length) = self.fitting(&text[start..end], size, weight, width) {
                    lines.push(start..start + length);
                    (start, room) = (start + length, width);
                }
                let last = if room == width { &text[start..end] } else { word };
                room -= self.width(last, size, weight);
            }
            lines.push(start..end);
        }
    }

    /// How much of `line`, in bytes, fits into `width` pixels: at least one letter. `None` when all of it fits.
    fn fitting(&mut self, line: &str, size: u32, weight: Weight, width: f32) -> Option<usize> {
        let mut end = 0.0;
        for (at, char) in line.trim_end().char_indices() {
            end += self.letter(char, size, weight).advance;
            if end > width && at > 0 {
                return Some(at);
            }
        }
        None
    }

    fn letter(&mut self, char: char, size: u32, weight: Weight) -> &Letter {
        if self.letters.len() > MOST_LETTERS {
            self.letters.clear();
        }
        let font = match weight {
            Weight::Regular => &self.regular,
            Weight::Bold => &self.bold,
        };
        self.letters.entry((char, weight, size)).or_insert_with(|| {
            // Control characters have no shape.
            let Some(font) = font.as_ref().filter(|_| !char.is_control()) else {
                return Letter::default();
            };
            let (metrics, coverage) = font.rasterize(char, size as f32);
            Letter {
                left: metrics.xmin,
                top: -(metrics.ymin + metrics.height as i32),
                width: metrics.width,
                coverage,
                advance: metrics.advance_width,
            }
        })
    }
}

impl Canvas {
    /// Writes one line of text over everything and gives its width in pixels. `left` and `baseline` say where it
    /// starts, in pixels; letters that are partly outside of the picture are cut at its border.
    pub fn text(
        &mut self,
        typeface: &mut Typeface,
        text: &str,
        (left, baseline): (i32, i32),
        size: u32,
        weight: Weight,
        color: Color,
    ) -> f32 {
        let mut along = 0.0f32;
        for char in text.chars() {
            let letter = typeface.letter(char, size, weight);
            let x = left.saturating_add(along.round() as i32).saturating_add(letter.left);
            let y = baseline.saturating_add(letter.top);
            if letter.width > 0 {
                for (row, coverage) in letter.coverage.chunks_exact(letter.width).enumerate() {
                    self.letter_row(coverage, (x, y.saturating_add(row as i32)), color);
                }
            }
            along += letter.advance;
        }
        along
    }

    fn letter_row(&mut self, coverage: &[u8], (left, y): (i32, i32), color: Color) {
        let Some(y) = usize::try_from(y).ok().filter(|y| *y < self.height) else { return };
        let row = &mut self.pixels[y * self.width..][..self.width];
        for (x, &coverage) in (left..i32::MAX).zip(coverage) {
            if let Some(pixel) = usize::try_from(x).ok().and_then(|x| row.get_mut(x)) {
                *pixel = Color(*pixel).mix(color, f32::from(coverage) / 255.0).0;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fonts_can_be_read_and_have_the_letters_of_many_languages() {
        let typeface = Typeface::new();
        for font in [typeface.regular.unwrap(), typeface.bold.unwrap()] {
            for char in "Aa0°±×→·–…äßéçñøłšřőğİΑωЖяא".chars() {
                assert!(font.has_glyph(char), "{char}");
            }
        }
    }

    #[test]
    fn text_is_cut_at_every_border() {
        let mut typeface = Typeface::new();
        let mut canvas = Canvas::new(30, 20);
        let far = [i32::MIN, -1000, -5, 0, 15, 25, 1000, i32::MAX];
        for left in far {
            for baseline in far {
                canvas.text(&mut typeface, "Wq|\u{7}\n世", (left, baseline), 18, Weight::Bold, Color::WHITE);
            }
        }
        assert!(canvas.pixels().iter().any(|pixel| *pixel != 0));
    }

    #[test]
    fn a_text_is_as_wide_as_it_is_measured_to_be() {
        let (mut typeface, mut canvas) = (Typeface::new(), Canvas::new(100, 20));
        let text = "a\tb\u{7}ß世";
        let width = typeface.width(text, 15, Weight::Bold);
        assert_eq!(canvas.text(&mut typeface, text, (0, 15), 15, Weight::Bold, Color::WHITE), width);
        assert_eq!(typeface.width("\t\u{7}", 15, Weight::Regular), 0.0);
    }

    #[test]
    fn a_letter_stands_on_its_baseline() {
        let mut canvas = Canvas::new(30, 30);
        canvas.text(&mut Typeface::new(), "H", (5, 20), 16, Weight::Regular, Color::WHITE);
        let rows = (0..30)
            .filter(|y| (0..30).any(|x| canvas.pixel(x, *y) != Some(Color::BLACK)))
            .collect::<Vec<_>>();
        assert_eq!(rows.last(), Some(&19));
        assert!((11..=12).contains(&rows.len()), "{rows:?}");
    }

    #[test]
    fn lines_break_between_words_and_long_words_break_anywhere() {
        let mut typeface = Typeface::new();
        let text = "one two three\nfour abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz";
        let mut wrap = |text: &'static str, width: f32| {
            let mut lines = Vec::new();
            typeface.wrap(text, 15, Weight::Regular, width, &mut lines);
            lines.into_iter().map(|line| &text[line]).collect::<Vec<_>>()
        };
        let lines = wrap(text, 100.0);
        assert_eq!(wrap("wide", 0.0), ["w", "i", "d", "e"]);
        assert_eq!(wrap("", 15.0), Vec::<&str>::new());
        assert_eq!(wrap("a\n\nb\r\n", 100.0), ["a", "", "b"]);
        assert_eq!(lines[..3], ["one two ", "three", "four "]);
        for line in &lines {
            assert!(typeface.width(line.trim_end(), 15, Weight::Regular) <= 100.0, "{line}");
        }
        assert_eq!(lines.concat().replace(' ', ""), text.replace([' ', '\n'], ""));
    }
}
