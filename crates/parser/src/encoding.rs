//! Which bytes stand for which characters.

use std::io::{self, Read};

/// How a text is encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Utf8,
    Utf16 { little_endian: bool },
}

/// Tells the encoding by the first bytes of a text (four, if it has so many), and how many of them are a mark
/// that is no part of the text. UTF-16 without a mark is known by the zero in every second byte of plain words.
pub(crate) fn detect(first: &[u8]) -> (Encoding, usize) {
    const LITTLE: Encoding = Encoding::Utf16 { little_endian: true };
    const BIG: Encoding = Encoding::Utf16 { little_endian: false };
    match *first {
        [0xef, 0xbb, 0xbf, ..] => (Encoding::Utf8, 3),
        // UTF-32, which is not read. Its mark stays, to be seen.
        [0xff, 0xfe, 0, 0] => (Encoding::Utf8, 0),
        [0xff, 0xfe, ..] => (LITTLE, 2),
        [0xfe, 0xff, ..] => (BIG, 2),
        [a, 0, b, 0] if a > 0 && b > 0 => (LITTLE, 0),
        [0, a, 0, b] if a > 0 && b > 0 => (BIG, 0),
        _ => (Encoding::Utf8, 0),
    }
}

/// What a file may be that begins with these bytes, if they are no text that can be shown.
pub(crate) fn not_a_text(word: &[u8]) -> Option<&'static str> {
    match word {
        [0x1f, 0x8b, ..] | [b'P', b'K', 3, 4, ..] => Some(" (compressed? unpack it first)"),
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] | [1..=255, 0, 0, 0, ..] | [0, 0, 0, 1..=255, ..] => {
            Some(" (UTF-32? save it as UTF-8)")
        }
        word if word.iter().any(u8::is_ascii_control) || std::str::from_utf8(word).is_err() => {
            Some(" (not a text?)")
        }
        _ => None,
    }
}

/// Turns UTF-16 into UTF-8 on the way. What is no character becomes the replacement character, U+FFFD.
pub(crate) struct FromUtf16<R> {
    input: R,
    little_endian: bool,
    /// Bytes that are not decoded yet: half a unit, or the first half of a pair of units.
    undecoded: Vec<u8>,
    decoded: String,
    /// How much of `decoded` has been given away.
    given: usize,
}

impl<R: Read> FromUtf16<R> {
    pub fn new(input: R, little_endian: bool) -> Self {
        FromUtf16 { input, little_endian, undecoded: Vec::new(), decoded: String::new(), given: 0 }
    }

    /// Reads and decodes once more, until there is something to give or the input ends.
    fn decode(&mut self) -> io::Result<()> {
        self.given = 0;
        self.decoded.clear();
        while self.decoded.is_empty() {
            let mut chunk = [0; 8192];
            let read = self.input.read(&mut chunk)?;
            self.undecoded.extend_from_slice(&chunk[..read]);
            let from_bytes = if self.little_endian { u16::from_le_bytes } else { u16::from_be_bytes };
            let pairs = self.undecoded.chunks_exact(2);
            let odd = pairs.remainder().to_vec();
            let mut units: Vec<u16> = pairs.map(|pair| from_bytes([pair[0], pair[1]])).collect();
            self.undecoded.clear();
            let at_end = read == 0;
            if let Some(&last) = units.last()
                && (0xd800..0xdc00).contains(&last)
                && !at_end
            {
                units.pop();
                let bytes = if self.little_endian { last.to_le_bytes() } else { last.to_be_bytes() };
                self.undecoded.extend(bytes);
            }
            self.undecoded.extend(&odd);
            let characters = char::decode_utf16(units);
            self.decoded.extend(characters.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)));
            if at_end {
                if !odd.is_empty() {
                    self.decoded.push(char::REPLACEMENT_CHARACTER);
                }
                self.undecoded.clear();
                return Ok(());
            }
        }
        Ok(())
    }
}

impl<R: Read> Read for FromUtf16<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.given == self.decoded.len() {
            self.decode()?;
        }
        let read = (&self.decoded.as_bytes()[self.given..]).read(buffer)?;
        self.given += read;
        Ok(read)
    }
}
