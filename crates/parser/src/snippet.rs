//! The part of a source line that a message shows.

use std::fmt;

/// How many bytes of the line are shown on each side of the place in question.
pub(crate) const CONTEXT: usize = 60;

/// A source line, or the part of it around one place, with a mark under that place.
///
/// Shown in two lines without a number in front. Characters that would upset a terminal are replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Snippet {
    text: String,
    /// How many characters stand in front of the mark.
    mark: usize,
}

impl Snippet {
    /// `before` and `after` are what stands on the two sides of the place, at most [`CONTEXT`] bytes each; more of
    /// the line has been left out where `cut_before` or `cut_after` says so.
    pub(crate) fn new(before: &[u8], after: &[u8], cut_before: bool, cut_after: bool) -> Self {
        let half = before.iter().take_while(|&&byte| cut_before && is_continuation(byte)).count();
        let mut text = if cut_before { String::from("…") } else { String::new() };
        push_printable(&mut text, &before[half..]);
        let mark = text.chars().count();
        push_printable(&mut text, if cut_after { without_half_character(after) } else { after });
        let mut text = text.trim_end().to_owned();
        if cut_after {
            text.push('…');
        }
        Snippet { text, mark }
    }

    /// Whether there is nothing to show: the line is empty.
    pub(crate) fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The text of the line, every character one column wide for a reader who counts characters.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Snippet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "  | {}\n  | {:mark$}^", self.text, "", mark = self.mark)
    }
}

/// `text` as it may be shown in a terminal, on one line, whoever wrote it: a tab becomes a blank, and a replacement
/// character (U+FFFD) stands for each control character (also a line break, and what begins a colour), each that
/// changes the direction of the text around it, and each that takes no room. All else stays as it is.
///
/// Meant for names and paths, which come from elsewhere.
pub fn printable(text: &str) -> String {
    text.chars().map(printable_character).collect()
}

/// As [`printable`], and not longer than a line.
pub(crate) fn printable_start(text: &[u8]) -> String {
    const LONGEST: usize = 40;
    let mut shown = String::new();
    let whole = text.len() <= LONGEST;
    push_printable(&mut shown, if whole { text } else { without_half_character(&text[..LONGEST]) });
    if !whole {
        shown.push('…');
    }
    shown
}

fn push_printable(shown: &mut String, text: &[u8]) {
    shown.extend(String::from_utf8_lossy(text).chars().map(printable_character));
}

fn printable_character(c: char) -> char {
    match c {
        '\t' => ' ',
        c if c.is_control() || is_invisible(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

/// Whether a character changes the direction of the text around it, or takes no room.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

fn without_half_character(text: &[u8]) -> &[u8] {
    match std::str::from_utf8(text) {
        Err(error) if error.error_len().is_none() => &text[..error.valid_up_to()],
        _ => text,
    }
}

fn is_continuation(byte: u8) -> bool {
    byte & 0xc0 == 0x80
}
