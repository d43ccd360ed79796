//! From the bytes of a file to the text that is compiled.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use crate::printable::{is_direction, is_invisible};
use crate::{Rejection, Source, Wanted, magic};

/// The text of a source file, with the lines numbered as in the student's editor. `remarks` are those made so far.
pub(crate) fn normalise(
    bytes: &[u8],
    mut remarks: Vec<String>,
    wanted: &Wanted,
) -> Result<Source, Rejection> {
    let sha256 = sha256(bytes);
    let reject = |code, found: String| {
        let rejection = Rejection::new(code, found, wanted);
        Rejection { sha256: Some(sha256.clone()), ..rejection }
    };
    if let Some(format) = magic::format(bytes) {
        return Err(reject("not_source", format!("The file has the name of a Rust file, but is {format}.")));
    }
    let text = decode(bytes, &mut remarks);
    if let Some(at) = text.find('\0') {
        let line = line_of(&text, at);
        let found = format!(
            "Line {line} of the file holds a zero byte, which no text does. Perhaps the editor saved it in an unusual encoding: choose UTF-8."
        );
        return Err(reject("binary", found));
    }
    if text.trim().is_empty() {
        return Err(reject("empty", "The file is empty.".into()));
    }
    let text = end_lines_with_newline(text, &mut remarks);
    remark_invisible(&text, &mut remarks);
    Ok(Source { text, sha256, remarks })
}

/// The SHA-256 of `bytes`, in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}"); // Writing to a string does not fail.
        hex
    })
}

fn decode(bytes: &[u8], remarks: &mut Vec<String>) -> String {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => decode_bytes(rest, remarks),
        [0xff, 0xfe, rest @ ..] => decode_utf16(rest, u16::from_le_bytes, remarks),
        [0xfe, 0xff, rest @ ..] => decode_utf16(rest, u16::from_be_bytes, remarks),
        bytes => decode_bytes(bytes, remarks),
    }
}

/// UTF-8 where it is that, else Latin-1, in which every byte is a letter: the text is mostly comments, and better read with a
/// wrong letter than not at all.
fn decode_bytes(bytes: &[u8], remarks: &mut Vec<String>) -> String {
    match str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(error) => {
            let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
            let before = bytes.get(..error.valid_up_to()).unwrap_or_default();
            let line = line_of(&text, before.iter().map(|byte| char::from(*byte).len_utf8()).sum());
            remarks.push(format!(
                "Line {line} is not in UTF-8: the file was read as Latin-1. Letters outside of English may look wrong."
            ));
            text
        }
    }
}

fn decode_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16, remarks: &mut Vec<String>) -> String {
    let (pairs, odd) = bytes.as_chunks::<2>();
    let mut text: String = char::decode_utf16(pairs.iter().map(|pair| unit(*pair)))
        .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect();
    if !odd.is_empty() {
        text.push(char::REPLACEMENT_CHARACTER);
    }
    remarks.push("The file was in UTF-16: it was read as such.".into());
    if let Some(at) = text.find(char::REPLACEMENT_CHARACTER) {
        let line = line_of(&text, at);
        remarks.push(format!("Line {line} holds a damaged letter: it was read as �."));
    }
    text
}

/// CRLF and CR end lines too, in editors and here.
fn end_lines_with_newline(text: String, remarks: &mut Vec<String>) -> String {
    if !text.contains('\r') {
        return text;
    }
    let text = text.replace("\r\n", "\n");
    if text.contains('\r') {
        remarks
            .push("The file ends lines in the way of old Macs (CR): they were read as ends of lines.".into());
    }
    text.replace('\r', "\n")
}

/// Invisible characters stay: taking them out could make wrong code right. The compiler refuses most of them.
fn remark_invisible(text: &str, remarks: &mut Vec<String>) {
    let found = text.char_indices().find(|(_, c)| is_invisible(*c) && !matches!(c, '\n' | '\t'));
    let Some((at, c)) = found else { return };
    let (line, code) = (line_of(text, at), u32::from(c));
    let what = if is_direction(c) {
        "changes the writing direction, so that code can look other than it is"
    } else {
        "cannot be seen"
    };
    remarks.push(format!("Line {line} holds a character that {what} (U+{code:04X}). It was left in; the compiler may refuse it."));
}

/// The line, from 1, in which the byte `at` lies. CR and CRLF end lines too.
fn line_of(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let before = bytes.get(..at).unwrap_or(bytes);
    let ends = before.iter().enumerate().filter(|(i, byte)| match byte {
        b'\n' => true,
        b'\r' => bytes.get(i + 1) != Some(&b'\n'),
        _ => false,
    });
    1 + ends.count()
}
