//! From the bytes of a file to its text.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use submissions::{MAX_SOURCE, Source};
use support::{CODE, code, hand_in, rejected};

#[track_caller]
fn read(bytes: &[u8]) -> Source {
    support::source(hand_in("fk.rs", bytes))
}

fn utf16(text: &str, to_bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(to_bytes).collect()
}

#[test]
fn plain_text_stays_as_it_is() {
    for text in [CODE, "no newline at the end", "// Größe 角度 🦀\n", "\n\n\tcode\n\n"] {
        let source = read(text.as_bytes());
        assert_eq!(source.text, text);
        assert!(source.remarks.is_empty(), "{:?}", source.remarks);
    }
}

#[test]
fn the_hash_is_that_of_the_bytes_handed_in() {
    // printf 'abc' | sha256sum
    assert_eq!(read(b"abc").sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    assert_ne!(read(b"a\r\n").sha256, read(b"a\n").sha256);
    let rejection = rejected(hand_in("fk.rs", b"\0"));
    assert_eq!(rejection.sha256.unwrap(), "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d");
}

#[test]
fn a_byte_order_mark_is_taken_away() {
    let source = read("\u{feff}fn a() {}\n".as_bytes());
    assert_eq!((source.text.as_str(), source.remarks.len()), ("fn a() {}\n", 0));
}

#[test]
fn all_ends_of_lines_are_one() {
    assert_eq!(read(b"a\r\nb\r\n").text, "a\nb\n");
    assert!(read(b"a\r\nb\r\n").remarks.is_empty());
    let source = read(b"a\rb\r\rc");
    assert_eq!(source.text, "a\nb\n\nc");
    assert!(source.remarks[0].contains("old Macs"));
    assert_eq!(read(b"a\r\r\nb\nc\r").text, "a\n\nb\nc\n");
}

#[test]
fn utf_16_is_read() {
    for bytes in [utf16("// 角度 🦀\r\nx", u16::to_le_bytes), utf16("// 角度 🦀\r\nx", u16::to_be_bytes)]
    {
        let source = read(&bytes);
        assert_eq!(source.text, "// 角度 🦀\nx");
        assert_eq!(source.remarks, ["The file was in UTF-16: it was read as such."]);
    }
    let mut odd = utf16("a\nb", u16::to_le_bytes);
    odd.push(b'x');
    let source = read(&odd);
    assert_eq!(source.text, "a\nb\u{fffd}");
    assert!(source.remarks[1].contains("Line 2"), "{:?}", source.remarks);
}

#[test]
fn latin_1_is_read_with_a_remark_that_names_the_line() {
    let source = read(b"// ok\r\n// Gr\xf6\xdfe\nfn a() {}\n");
    assert_eq!(source.text, "// ok\n// Größe\nfn a() {}\n");
    assert!(source.remarks[0].starts_with("Line 2 is not in UTF-8"), "{:?}", source.remarks);
    let late = [b"// \xc3\xb6\n".repeat(3), b"\xf6\n".to_vec()].concat();
    assert!(read(&late).remarks[0].starts_with("Line 4 "));
}

#[test]
fn bytes_that_no_text_holds_are_refused() {
    let rejection = rejected(hand_in("fk.rs", b"a\nb\0c"));
    assert_eq!(rejection.code, "binary");
    assert!(rejection.why.contains("Line 2"), "{rejection:?}");
    let without_mark: Vec<u8> = "fn a() {}".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(rejected(hand_in("fk.rs", &without_mark)).why.contains("choose UTF-8"));
    assert_eq!(code(hand_in("fk.rs", b"\xff\xfe\0\0a\0\0\0")), "binary", "UTF-32");
}

#[test]
fn nothing_is_refused() {
    for bytes in [&b""[..], b"\xef\xbb\xbf", b" \r\n\t\n", b"\xff\xfe"] {
        assert_eq!(code(hand_in("fk.rs", bytes)), "empty");
    }
}

#[test]
fn what_is_something_else_is_named() {
    let formats: [(&[u8], &str); 5] = [
        (b"PK\x03\x04....", "a zip archive"),
        (b"%PDF-1.4\n", "a PDF"),
        (b"{\\rtf1\\ansi", "rich text"),
        (b"\x7fELF\x02\x01", "a compiled program"),
        (b"<!DOCTYPE html><html>", "a web page"),
    ];
    for (bytes, format) in formats {
        let rejection = rejected(hand_in("fk.rs", bytes));
        assert_eq!(rejection.code, "not_source");
        assert!(rejection.why.contains(format), "{rejection:?}");
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let longest = vec![b'/'; MAX_SOURCE as usize];
    assert_eq!(read(&longest).text.len(), longest.len());
    assert_eq!(code(hand_in("fk.rs", &[&longest[..], b"/"].concat())), "too_large");
}

#[test]
fn invisible_characters_stay_and_are_told() {
    let text = "let a = 1;\nlet access = \"user\u{202e} \u{2066}// admin\u{2069}\";\n";
    let source = read(text.as_bytes());
    assert_eq!(source.text, text);
    assert_eq!(source.remarks.len(), 1);
    assert!(
        source.remarks[0].starts_with("Line 2 holds") && source.remarks[0].contains("U+202E"),
        "{source:?}"
    );
    for c in
        ['\u{200b}', '\u{2060}', '\u{feff}', '\u{1b}', '\u{7}', '\u{85}', '\u{2028}', '\u{c}', '\u{e0041}']
    {
        let source = read(format!("a\n\nb{c}c").as_bytes());
        assert!(source.remarks[0].starts_with("Line 3 holds a character that cannot be seen"), "{source:?}");
    }
}

#[test]
fn lines_keep_their_numbers() {
    let text = "1\r\n2\r3\n\r4\r\r\n6";
    let lines: Vec<String> = read(text.as_bytes()).text.lines().map(str::to_owned).collect();
    assert_eq!(lines, ["1", "2", "3", "", "4", "", "6"]);
}
