//! What cannot be read, and the whole message for it.

mod common;

use common::{GOOD, with};
use parser::Problem;
use parser::bvh::{self, ErrorKind, FileError};

/// Under the title of each case its message, blank lines between.
const EXPECTED: &str = include_str!("refused.txt");

#[test]
fn every_error_says_where_what_and_what_to_do() {
    let mut messages = Vec::new();
    for (title, text) in cases() {
        match bvh::read(text.as_bytes()) {
            Ok(reading) => panic!("{title}: was read, with {:?}", reading.warnings),
            Err(error) => messages.push(format!("# {title}\n{error}\n")),
        }
    }
    let messages = messages.join("\n");
    let expected = EXPECTED.replace("\r\n", "\n");
    // Line by line, so that the first difference is what is shown.
    for (line, (message, expected)) in messages.lines().zip(expected.lines()).enumerate() {
        assert_eq!(message, expected, "refused.txt, line {}", line + 1);
    }
    assert_eq!(messages, expected);
}

#[test]
fn a_file_error_begins_with_path_line_and_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("my walk.bvh");
    std::fs::write(&path, with("5", "five")).expect("a file");
    let message = bvh::read_file(&path).expect_err("five is not a number").to_string();
    let expected = format!("{}:15:3: found `five`, expected a number\n  | 4 five 6\n", path.display());
    assert!(message.starts_with(&expected), "{message}");
}

#[test]
fn a_missing_file_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("none.bvh");
    let message = bvh::read_file(&path).expect_err("there is no such file").to_string();
    assert!(message.starts_with(&format!("{}: cannot be opened: ", path.display())), "{message}");
}

#[test]
fn what_is_no_text_is_guessed_and_not_shown() {
    let utf32: [fn(u32) -> [u8; 4]; 2] = [u32::to_le_bytes, u32::to_be_bytes];
    let utf32 = utf32.into_iter().flat_map(|bytes| {
        ["", "\u{feff}"].map(|mark| {
            let text = format!("{mark}{GOOD}");
            ("UTF-32? save it as UTF-8", text.chars().flat_map(|c| bytes(u32::from(c))).collect())
        })
    });
    let packed = [b"\x1f\x8b\x08\x08walk".to_vec(), b"PK\x03\x04\x14\0".to_vec()];
    let packed = packed.map(|bytes| ("compressed? unpack it first", bytes));
    for (guess, bytes) in utf32.chain(packed).chain([("not a text?", b"\xffBVH".to_vec())]) {
        let error = bvh::read(bytes.as_slice()).expect_err(guess);
        assert!(error.to_string().contains(&format!("` ({guess}); a BVH file begins with")), "{error}");
        assert_eq!(error.snippet(), None, "{error}");
    }
}

#[test]
fn what_upsets_a_terminal_is_not_shown() {
    let upsetting = "\u{1b}[31m\n\u{9b}\u{61c}\u{200b}\u{202e}\u{2066}\u{feff}";
    let harmless = "\u{fffd}[31m\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}";
    assert_eq!(parser::printable(upsetting), harmless);
    assert_eq!(parser::printable("my\twalk Hüfte 腰 {1}"), "my walk Hüfte 腰 {1}");
    let path = std::path::PathBuf::from(upsetting);
    let opened = FileError::Open { path: path.clone(), cause: std::io::Error::other("gone") };
    assert_eq!(opened.to_string(), format!("{harmless}: cannot be opened: gone"));
    let cause = bvh::read("".as_bytes()).expect_err("an empty file");
    let read = FileError::Read { path, cause }.to_string();
    assert!(read.starts_with(&format!("{harmless}:1:1: ")), "{read}");
}

#[test]
fn a_failing_disk_is_not_mistaken_for_a_bad_text() {
    /// Gives so much of a text, and then fails.
    struct Failing<'a>(&'a [u8]);

    impl std::io::Read for Failing<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            match self.0.read(buffer)? {
                0 => Err(std::io::Error::other("the disk is gone")),
                read => Ok(read),
            }
        }
    }

    for length in 0..=GOOD.len() {
        let error = bvh::read(Failing(&GOOD.as_bytes()[..length])).expect_err("the disk is gone");
        assert!(matches!(error.kind(), ErrorKind::Common(Problem::Io(_))), "after {length} bytes: {error}");
    }
}

/// What is wrong, and the text.
fn cases() -> Vec<(&'static str, String)> {
    vec![
        ("an empty file", "".to_owned()),
        ("a file of blanks", " \n\n".to_owned()),
        ("JSON", "{\"a\": 1}".to_owned()),
        ("XML", "<bvh/>".to_owned()),
        ("an Acclaim skeleton", "#!OML:ASF\n:version 1.10".to_owned()),
        ("a picture", "\u{7f}PNG\r\n\u{1a}\n\0\0".to_owned()),
        ("zeros", "\0\0\0\0\0\0".to_owned()),
        ("prose", "Dear Sir or Madam".to_owned()),
        ("a zip archive", "PK\u{3}\u{4}\u{14}\0".to_owned()),
        ("no first line", GOOD.replace("HIERARCHY\n", "")),
        ("only a motion", GOOD[GOOD.find("MOTION").unwrap_or(0)..].to_owned()),
        ("a conflict at the top", with("HIERARCHY\n", "<<<<<<< HEAD\nHIERARCHY\n")),
        ("a conflict among the joints", with("\tEnd Site", "=======\n\tEnd Site")),
        ("a conflict among the frames", with("4 5 6", "<<<<<<< HEAD\n4 5 6\n=======\n4 5 7\n>>>>>>> theirs")),
        ("a conflict behind the frames", with("4 5 6", "4 5 6\n>>>>>>> theirs")),
        ("no root", with("ROOT", "JOINT")),
        ("no name", with("ROOT Hips", "ROOT")),
        ("no opening brace", with("{\n", "")),
        ("no opening brace behind a name that ends in two", with("Hips\n{", "Hips{{")),
        ("no offset", with("\tOFFSET 0 1 0\n", "")),
        ("an offset of two numbers", with("0 1 0", "0 1")),
        ("an offset of four numbers", with("0 1 0", "0 1 0 5")),
        ("an offset with a comma", with("0 1 0", "0 1,5 0")),
        ("an offset that is not a number", with("0 1 0", "0 nan 0")),
        ("an unknown channel", with("Xrotation", "Wrotation")),
        ("a repeated channel", with("Xrotation", "Zrotation")),
        ("fewer channels than counted", with("CHANNELS 3", "CHANNELS 4")),
        ("more channels than counted", with("CHANNELS 3", "CHANNELS 2")),
        ("channels that are not counted", with("CHANNELS 3", "CHANNELS")),
        ("one channel of two", with("CHANNELS 3 Zrotation Xrotation", "CHANNELS 2")),
        ("a count of channels that no number holds", with("CHANNELS 3", "CHANNELS 18446744073709551616")),
        ("a second offset", with("\tEnd", "\tOFFSET 1 2 3\n\tEnd")),
        ("an End Site that is something else", with("End Site", "End Point")),
        ("an End Site with channels", with("\t\tOFFSET 0 2 0\n", "\t\tOFFSET 0 2 0\n\t\tCHANNELS 0\n")),
        ("a closing brace too few", with("}\nMOTION", "MOTION")),
        ("a closing brace too many", with("}\nMOTION", "}\n}\nMOTION")),
        ("a closing brace before all joints", with("ROOT", "}\nROOT")),
        ("a closing brace that is cut off", GOOD[..GOOD.find("}\nMOTION").unwrap_or(0)].to_owned()),
        ("a root in a joint", with("\tEnd Site", "ROOT Other")),
        ("only joints", GOOD[..GOOD.find("MOTION").unwrap_or(0)].to_owned()),
        ("no count of frames", with("Frames: 2\n", "")),
        ("a negative count of frames", with("Frames: 2", "Frames: -1")),
        ("half a frame", with("Frames: 2", "Frames: 1.5")),
        ("a count of frames with an exponent", with("Frames: 2", "Frames: 1e3")),
        ("a count of frames that no number holds", with("Frames: 2", "Frames: 18446744073709551616")),
        ("no frame time", with("Frame Time: 0.04\n", "")),
        ("a word for a frame time", with("0.04", "fast")),
        ("an endless frame time", with("0.04", "inf")),
        ("a last frame that is cut off", with("4 5 6", "4 5")),
        ("a frame too few", with("4 5 6\n", "")),
        ("no frames", with("1 2 3\n4 5 6\n", "")),
        ("a count of frames that no memory could hold", with("Frames: 2", "Frames: 999999999999")),
        ("a frame too few in one line", with("1 2 3\n4 5 6", "1 2 3 4 5")),
        ("rows of another skeleton", with("1 2 3\n4 5 6", "1 2 3 4\n5 6 7 8")),
        ("rows of twice the width", with("1 2 3\n4 5 6", "1 2 3 4 5 6\n1 2 3 4 5 6")),
        ("one row that is too wide", with("4 5 6", "4 5 6 7")),
        ("a row in the middle that is too wide", with("1 2 3\n4 5 6", "1 2 3 0\n4 5 6\n7 8 9")),
        ("a word for a number", with("5", "five")),
        ("a comma in the frames", with("4 5 6", "4,0 5,5 6,1")),
        ("frames separated by commas", with("4 5 6", "4,5,6")),
        ("frames separated by semicolons", with("4 5 6", "4;5;6")),
        (
            "one frame of one channel that is missing",
            with("CHANNELS 3 Zrotation Xrotation", "CHANNELS 1")
                .replace("Frames: 2", "Frames: 1")
                .replace("1 2 3\n4 5 6\n", ""),
        ),
        ("NaN", with("5", "NaN")),
        ("NaN as C programs print it", with("5", "-1.#IND")),
        ("a number that is too large", with("5", "1e39")),
        ("what would upset a terminal", with("5", "\u{1b}[31m\u{202e}5")),
        (
            "a place far along a line",
            with("Frames: 2", "Frames: 200")
                .replace("1 2 3", &format!("{} x {}", "1 ".repeat(300), "2 ".repeat(300))),
        ),
        ("a place behind letters of two bytes", with("Hips", "Hüfte { OFSET")),
        ("a name without an end", with("Hips", &"x".repeat(5000))),
        ("a number without an end", with("5", &"5".repeat(5000))),
    ]
}
