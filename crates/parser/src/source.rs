//! Text that arrives piece by piece, taken word by word, with the place of every word.

use std::io::{self, Read};

use crate::Snippet;
use crate::snippet::CONTEXT;

/// The longest word or name, in bytes, that is looked at as a whole. Longer ones come back cut, one byte longer
/// than this, so that whoever asked can tell.
pub(crate) const LONGEST_WORD: usize = 4096;

/// How much is asked of the input at once: enough to make the calls rare, and little enough to stay in the cache.
const CHUNK: usize = 64 * 1024;

/// A place in a text, both counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub line: u64,
    /// In characters.
    pub column: u64,
}

/// Blanks stand between words. A line break is one of them.
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c)
}

/// What stands between the words of a format, besides blanks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Syntax {
    /// Each of these bytes is a word of its own.
    pub marks: &'static [u8],
    /// At the beginning of a word, this byte begins a comment: all up to the end of the line is left out.
    pub comment: Option<u8>,
}

/// A text that is read in chunks.
pub(crate) struct Source<'r> {
    input: &'r mut dyn Read,
    syntax: Syntax,
    /// Whether brackets and commas are blank: see [`Source::as_list`].
    is_list: bool,
    buffer: Vec<u8>,
    /// What has been read and not been taken: `buffer[start..end]`. In front of it stands a little of what has been
    /// taken of the current line, for messages.
    start: usize,
    end: usize,
    exhausted: bool,
    /// Why the input could not be read on. The text then seems to end.
    failure: Option<io::Error>,
    lines: Lines,
}

/// How far the lines have been counted.
#[derive(Debug)]
pub(crate) struct Lines {
    /// The number of the current line, from 1.
    pub line: u64,
    /// Where in the buffer the current line starts, or what is left of it.
    start: usize,
    /// The characters of the current line that the buffer holds no more.
    dropped: u64,
    /// The last byte taken was a carriage return, and the byte behind it was not there yet.
    after_return: bool,
    /// The first line that ended with a carriage return alone.
    lone_return: Option<u64>,
}

/// Text that ends behind a whole word, to be taken from the front by someone in a hurry: the numbers of a motion.
pub(crate) struct WholeWords<'a> {
    /// The text starts at `text[*at]`. What stands in front of that has been taken before.
    pub text: &'a [u8],
    /// To be moved forward over all that is taken.
    pub at: &'a mut usize,
    /// To be told of every line break.
    pub lines: &'a mut Lines,
}

impl<'r> Source<'r> {
    pub fn new(input: &'r mut dyn Read, syntax: Syntax) -> Self {
        let lines = Lines { line: 1, start: 0, dropped: 0, after_return: false, lone_return: None };
        Source {
            input,
            syntax,
            is_list: false,
            buffer: vec![0; CHUNK],
            start: 0,
            end: 0,
            exhausted: false,
            failure: None,
            lines,
        }
    }

    /// The next word, without taking it: all that stands in front of the next blank or mark. A mark is a word of its
    /// own. Empty at the end of the text.
    pub fn peek(&mut self) -> &[u8] {
        self.peek_between(self.syntax.marks)
    }

    /// As [`Source::peek`], with other marks.
    pub fn peek_between(&mut self, marks: &[u8]) -> &[u8] {
        self.skip_blanks();
        let brackets: &[u8] = if self.is_list { b"()" } else { b"" };
        let ends_word = |byte| is_blank(byte) || marks.contains(&byte) || brackets.contains(&byte);
        let mut length = match self.length_until(ends_word) {
            0 => 1.min(self.end - self.start),
            length => length,
        };
        if self.is_list {
            length = first_item(&self.buffer[self.start..self.start + length]);
        }
        &self.buffer[self.start..self.start + length]
    }

    /// Does `read`, and with `is_list` brackets and commas are as good as blanks there. A comma in front of a digit is none: it
    /// may be meant as a decimal point.
    pub fn as_list<R>(&mut self, is_list: bool, read: impl FnOnce(&mut Self) -> R) -> R {
        let before = std::mem::replace(&mut self.is_list, is_list);
        let result = read(self);
        self.is_list = before;
        result
    }

    /// The rest of the current line, without taking it, and without the blanks in front of it.
    pub fn peek_line(&mut self) -> &[u8] {
        self.skip_blanks_in_line();
        let length = self.length_until(is_line_break);
        &self.buffer[self.start..self.start + length]
    }

    /// Whether there is no other word in the current line.
    pub fn line_ends(&mut self) -> bool {
        self.skip_blanks_in_line();
        self.next().is_none_or(is_line_break) || self.skip_comment()
    }

    /// Takes the rest of the current line.
    pub fn take_line(&mut self) {
        self.skip(|byte| !is_line_break(byte));
    }

    /// Takes `bytes` bytes of what was just looked at.
    pub fn take(&mut self, bytes: usize) {
        self.start = self.end.min(self.start + bytes);
    }

    /// What has been read and ends behind a whole word; empty only at the end of the text. A word too long to be
    /// read whole comes without its end.
    pub fn whole_words(&mut self) -> WholeWords<'_> {
        let end = loop {
            let text = &self.buffer[self.start..self.end];
            let whole = text.iter().rposition(|&byte| is_blank(byte)).map_or(0, |last| last + 1);
            if self.exhausted || text.len() - whole > LONGEST_WORD {
                break self.end;
            }
            if whole > 0 {
                break self.start + whole;
            }
            self.fill();
        };
        WholeWords { text: &self.buffer[..end], at: &mut self.start, lines: &mut self.lines }
    }

    /// Whether the next word is `word`, in upper or lower case.
    pub fn is_word(&mut self, word: &str) -> bool {
        self.peek().eq_ignore_ascii_case(word.as_bytes())
    }

    /// Takes the next word if it is `word`, in upper or lower case. Gives whether it was.
    pub fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        if found {
            self.take(word.len());
        }
        found
    }

    /// Where the next byte stands.
    pub fn place(&self) -> Place {
        self.lines.place(&self.buffer, self.start)
    }

    /// The first line that ended with a carriage return alone, if one has.
    pub fn lone_return(&self) -> Option<u64> {
        self.lines.lone_return
    }

    /// Why the text ended before its end, if it did. Asked twice, it tells once.
    pub fn take_failure(&mut self) -> Option<io::Error> {
        self.failure.take()
    }

    /// The current line around the next byte.
    pub fn snippet(&mut self) -> Snippet {
        while self.end - self.start <= CONTEXT && self.fill() {}
        let from = self.lines.start.max(self.start.saturating_sub(CONTEXT));
        let after = &self.buffer[self.start..self.end];
        let length = after.iter().position(|&byte| is_line_break(byte)).unwrap_or(after.len());
        let to = self.start + length.min(CONTEXT);
        let cut_before = from > self.lines.start || self.lines.dropped > 0;
        Snippet::new(
            &self.buffer[from..self.start],
            &self.buffer[self.start..to],
            cut_before,
            length > CONTEXT,
        )
    }

    fn skip_blanks_in_line(&mut self) {
        let is_list = self.is_list;
        self.skip(|byte| is_blank(byte) && !is_line_break(byte) || is_list && b"(),".contains(&byte));
    }

    fn skip_blanks(&mut self) {
        loop {
            self.skip_blanks_in_line();
            if self.next().is_some_and(is_line_break) {
                self.start = self.lines.take_break(&self.buffer[..self.end], self.start);
            } else if !self.skip_comment() {
                return;
            }
        }
    }

    /// Takes a comment, up to the end of its line. Gives whether there was one.
    fn skip_comment(&mut self) -> bool {
        let found = self.next().is_some() && self.next() == self.syntax.comment;
        if found {
            self.take_line();
        }
        found
    }

    /// The next byte, if it has been read; it has been after a [`Source::skip`] unless the text ends.
    fn next(&self) -> Option<u8> {
        self.buffer[self.start..self.end].first().copied()
    }

    /// Takes all bytes up to the first that is not `wanted`.
    fn skip(&mut self, wanted: impl Fn(u8) -> bool) {
        loop {
            let text = &self.buffer[self.start..self.end];
            let length = text.iter().position(|&byte| !wanted(byte));
            self.start += length.unwrap_or(text.len());
            if length.is_some() || !self.fill() {
                return;
            }
        }
    }

    /// How many bytes stand in front of the first that is an `end`; never more than one above [`LONGEST_WORD`].
    fn length_until(&mut self, end: impl Fn(u8) -> bool) -> usize {
        let mut length = 0;
        loop {
            let text = &self.buffer[self.start + length..self.end];
            let more = text.iter().take(LONGEST_WORD + 1).position(|&byte| end(byte));
            length += more.unwrap_or(text.len());
            if length > LONGEST_WORD {
                return LONGEST_WORD + 1;
            }
            if more.is_some() || !self.fill() {
                return length;
            }
        }
    }

    /// Reads once more. Gives false at the end of the text.
    fn fill(&mut self) -> bool {
        if self.exhausted {
            return false;
        }
        let keep = self.lines.start.max(self.start.saturating_sub(CONTEXT));
        self.lines.dropped += characters(&self.buffer[self.lines.start..keep]);
        self.lines.start = 0;
        self.buffer.copy_within(keep..self.end, 0);
        self.start -= keep;
        self.end -= keep;
        match read_some(self.input, &mut self.buffer[self.end..]) {
            Ok(read) => {
                self.exhausted = read == 0;
                self.end += read;
            }
            Err(failure) => {
                self.exhausted = true;
                self.failure = Some(failure);
            }
        }
        if self.lines.after_return {
            self.start = self.lines.take_feed(&self.buffer[..self.end], self.start);
        }
        !self.exhausted
    }
}

impl Lines {
    /// Takes the line break at `text[at]`: a line feed, a carriage return, or both. Gives the index behind it.
    pub fn take_break(&mut self, text: &[u8], at: usize) -> usize {
        self.line += 1;
        self.dropped = 0;
        self.start = at + 1;
        self.after_return = text[at] == b'\r';
        if self.after_return && self.start < text.len() {
            self.take_feed(text, self.start)
        } else {
            self.start
        }
    }

    /// Where `text[at]` stands; it must be in the current line.
    pub fn place(&self, text: &[u8], at: usize) -> Place {
        Place { line: self.line, column: self.dropped + characters(&text[self.start..at]) + 1 }
    }

    /// Takes the line feed at `text[at]`, if there is one, as part of the carriage return before.
    fn take_feed(&mut self, text: &[u8], at: usize) -> usize {
        self.after_return = false;
        if text.get(at) == Some(&b'\n') {
            self.start = at + 1;
        } else {
            self.lone_return.get_or_insert(self.line - 1);
        }
        self.start
    }
}

fn read_some(input: &mut dyn Read, buffer: &mut [u8]) -> io::Result<usize> {
    loop {
        match input.read(buffer) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            result => return result,
        }
    }
}

/// How long the first of the words is that have commas between them.
fn first_item(word: &[u8]) -> usize {
    let ends = |at: &usize| word[*at] == b',' && !word.get(at + 1).is_some_and(u8::is_ascii_digit);
    (0..word.len()).find(ends).unwrap_or(word.len())
}

fn is_line_break(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// How many characters of UTF-8 begin in `text`.
fn characters(text: &[u8]) -> u64 {
    text.iter().filter(|&&byte| byte & 0xc0 != 0x80).count() as u64
}
