//! The archive that a student hands in.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use submissions::{MAX_SOURCE, PackError, write_zip};
use support::{CODE, hand_in, source, wanted};

fn pack(number: &str, name: &str) -> Result<String, String> {
    write_zip(number, name, CODE.as_bytes(), &wanted())
        .map(|packed| packed.file_name)
        .map_err(|error| error.to_string())
}

#[test]
fn the_file_name_follows_the_scheme() {
    for (name, expected) in [
        ("Terry Fox", "300000001_TerryFox.zip"),
        ("terry fox", "300000001_TerryFox.zip"),
        ("  TerryFox ", "300000001_TerryFox.zip"),
        ("Zoë O'Neil-King", "300000001_ZoëONeil-King.zip"),
        ("王小明", "300000001_王小明.zip"),
        ("a/b\\c:d*e?f\"g<h>i|j", "300000001_Abcdefghij.zip"),
        ("../../x", "300000001_X.zip"),
        ("\u{202e}evil\u{1b}\n", "300000001_Evil.zip"),
    ] {
        assert_eq!(pack("300000001", name).unwrap(), expected);
    }
}

#[test]
fn what_is_wrong_with_number_or_name_is_said_gently() {
    for number in ["", "1234", "1234567890123", "30000000l", "３００００００００", "-30000000"] {
        let message = pack(number, "Terry Fox").unwrap_err();
        assert!(message.contains("5 to 12 digits"), "{message}");
    }
    for name in ["", "   ", "///", "123"] {
        assert!(pack("300000001", name).unwrap_err().contains("give your name"), "{name:?}");
    }
    let message = pack("300000001", &"x".repeat(99)).unwrap_err();
    assert!(message.contains("99 letters") && message.contains("at most 50"), "{message}");
}

#[test]
fn what_would_be_rejected_is_not_packed() {
    for (bytes, code) in
        [(vec![], "empty"), (b"a\0b".to_vec(), "binary"), (vec![b'x'; MAX_SOURCE as usize + 1], "too_large")]
    {
        match write_zip("300000001", "Terry Fox", &bytes, &wanted()) {
            Err(PackError::Source(rejection)) => assert_eq!(rejection.code, code),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn the_bytes_of_the_file_are_kept() {
    let packed = write_zip("300000001", "Terry Fox", b"\xff\xfea\0\r\0\n\0", &wanted()).unwrap();
    assert_eq!(packed.remarks.len(), 1);
    let source = source(hand_in(&packed.file_name, &packed.bytes));
    assert_eq!((source.text.as_str(), source.remarks), ("a\n", packed.remarks));
}

/// `unzip -t` and Python's zipfile accept it too; here, that no time and no name of this machine is in it.
#[test]
fn the_same_file_gives_the_same_bytes() {
    let packed = write_zip("300000001", "Terry Fox", CODE.as_bytes(), &wanted()).unwrap();
    let local_time = u16::from_le_bytes([packed.bytes[10], packed.bytes[11]]);
    let local_date = u16::from_le_bytes([packed.bytes[12], packed.bytes[13]]);
    assert_eq!((local_time, local_date), (0, 1 << 5 | 1), "1980-01-01 00:00");
    assert_eq!(
        packed.bytes,
        write_zip(" 300000001 ", "terry fox", CODE.as_bytes(), &wanted()).unwrap().bytes
    );
}
