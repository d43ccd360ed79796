//! What cannot be read as Acclaim, and the whole message for it.

mod common;

use common::acclaim::{AMC, ASF, amc, asf, figure};
use parser::Problem;
use parser::acclaim::{self, ErrorKind};
use skeleton::acclaim::Skeleton;

/// Under the title of each case its message, blank lines between.
const EXPECTED: &str = include_str!("acclaim_refused.txt");

#[test]
fn every_error_says_where_what_and_what_to_do() {
    let mut messages = Vec::new();
    let figure = figure();
    let skeletons = skeletons().into_iter().map(|(title, text)| (title, refused_skeleton(title, &text)));
    let motions = motions().into_iter().map(|(title, text)| (title, refused_motion(title, &text, &figure)));
    for (title, message) in skeletons.chain(motions) {
        messages.push(format!("# {title}\n{message}\n"));
    }
    let messages = messages.join("\n");
    let expected = EXPECTED.replace("\r\n", "\n");
    // Line by line, so that the first difference is what is shown.
    for (line, (message, expected)) in messages.lines().zip(expected.lines()).enumerate() {
        assert_eq!(message, expected, "acclaim_refused.txt, line {}", line + 1);
    }
    assert_eq!(messages, expected);
}

fn refused_skeleton(title: &str, text: &str) -> String {
    match acclaim::read_skeleton(text.as_bytes()) {
        Ok(reading) => panic!("{title}: was read, with {:?}", reading.warnings),
        Err(error) => error.to_string(),
    }
}

fn refused_motion(title: &str, text: &str, skeleton: &Skeleton) -> String {
    match acclaim::read_motion(text.as_bytes(), skeleton) {
        Ok(reading) => panic!("{title}: was read, with {:?}", reading.warnings),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_file_error_begins_with_path_line_and_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let (skeleton, motion) = (folder.path().join("my figure.asf"), folder.path().join("my walk.amc"));
    std::fs::write(&skeleton, ASF).expect("a file");
    std::fs::write(&motion, amc("shin 10", "shin ten")).expect("a file");
    let figure = acclaim::read_skeleton_file(&skeleton).expect("a good skeleton").skeleton;
    let message = acclaim::read_motion_file(&motion, &figure).expect_err("ten is not a number").to_string();
    let expected = format!("{}:7:6: found `ten`, expected a number\n  | shin ten\n", motion.display());
    assert!(message.starts_with(&expected), "{message}");
    let message = acclaim::read_skeleton_file(&motion).expect_err("a motion").to_string();
    assert!(message.starts_with(&format!("{}:2:1: this is not", motion.display())), "{message}");
    let none = folder.path().join("none.asf");
    let message = acclaim::read_skeleton_file(&none).expect_err("there is no such file").to_string();
    assert!(message.starts_with(&format!("{}: cannot be opened: ", none.display())), "{message}");
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

    for length in 0..=ASF.len() {
        let error = acclaim::read_skeleton(Failing(&ASF.as_bytes()[..length])).expect_err("the disk is gone");
        assert!(matches!(error.kind(), ErrorKind::Common(Problem::Io(_))), "after {length} bytes: {error}");
    }
    let figure = figure();
    for length in 0..=AMC.len() {
        let error = acclaim::read_motion(Failing(&AMC.as_bytes()[..length]), &figure).expect_err("gone, too");
        assert!(matches!(error.kind(), ErrorKind::Common(Problem::Io(_))), "after {length} bytes: {error}");
    }
}

#[test]
fn what_is_no_text_is_guessed_and_not_shown() {
    for (guess, bytes) in [
        ("compressed? unpack it first", &b"\x1f\x8b\x08\x08walk"[..]),
        ("compressed? unpack it first", b"PK\x03\x04\x14\0"),
        ("UTF-32? save it as UTF-8", b":\0\0\0v\0\0\0"),
        ("not a text?", b"\xffASF"),
    ] {
        let skeleton = acclaim::read_skeleton(bytes).expect_err(guess);
        let motion = acclaim::read_motion(bytes, &figure()).expect_err(guess);
        for error in [skeleton, motion] {
            assert!(error.to_string().contains(&format!("` ({guess}); it should begin with")), "{error}");
            assert_eq!(error.snippet(), None, "{error}");
        }
    }
}

/// What is wrong with a skeleton, and the text.
fn skeletons() -> Vec<(&'static str, String)> {
    let head = |end: &str| ASF[..ASF.find(end).unwrap_or(0)].to_owned();
    vec![
        ("an empty file", String::new()),
        ("only comments", "# nothing\n# more\n".to_owned()),
        ("JSON", "{\"a\": 1}".to_owned()),
        ("XML", "<asf/>".to_owned()),
        ("BVH", "HIERARCHY\nROOT Hips\n".to_owned()),
        ("a motion for a skeleton", AMC.to_owned()),
        ("prose", "Dear Sir or Madam".to_owned()),
        ("a conflict at the top", asf(":version", "<<<<<<< HEAD\n:version")),
        ("a conflict among the bones", asf("    length 2", "<<<<<<< HEAD\n    length 2")),
        ("a conflict in the hierarchy", asf("    hip thigh", "=======\n    hip thigh")),
        ("a section twice", asf(":bonedata", ":root\n:bonedata")),
        ("a hierarchy above the bones", asf(":bonedata", ":hierarchy\nbegin\nend\n:bonedata")),
        ("a hierarchy above the root", asf(":root", ":hierarchy\nbegin\nend\n:root")),
        ("radians below degrees", asf(":units\n", ":root\n:units\n").replace("angle deg", "angle rad")),
        ("no root", asf(":root", ":skin").replace(":hierarchy", ":other")),
        ("no bones", head(":bonedata")),
        ("no hierarchy", head(":hierarchy")),
        ("no number in the units", asf("mass 1.0", "mass heavy")),
        ("an unknown unit of angles", asf("angle deg", "angle gon")),
        ("an unknown dof of the root", asf("TX TY", "TX SY")),
        ("a root that is turned in no order", asf("axis XYZ", "axis XYY")),
        ("an order that is missing", asf("axis 0 0 20 XYZ\n    dof rx\n", "axis 0 0 20\n    dof rx\n")),
        ("too few numbers in a position", asf("position 0 0 0", "position 0 0")),
        ("too many numbers in a position", asf("position 0 0 0", "position 0 0 0 0")),
        ("a bone outside of begin and end", asf("  begin\n    id 1", "    id 1")),
        ("a bone without end", asf("  end\n  begin\n    id 2", "  begin\n    id 2")),
        ("a last bone without end", asf("  end\n:hierarchy", ":hierarchy")),
        ("a bone that is cut off", head("    length 3.5")),
        ("a bone without a name", asf("    name hip\n", "")),
        ("a bone without a direction", asf("    direction 1 0 0\n", "")),
        ("a bone without a length", asf("    length 2\n", "")),
        ("a bone of two lengths", asf("    length 2\n", "    length 2\n    length 3\n")),
        ("no name", asf("name hip", "name")),
        ("a name of two words", asf("name hip", "name left hip")),
        ("a name without an end", asf("name hip", &format!("name {}", "x".repeat(5000)))),
        ("a name that means something else", asf("name hip", "name end")),
        ("a bone that is called like another", asf("name shin", "name Thigh")),
        ("a bone that is called root", asf("name hip", "name Root")),
        ("a direction with a comma", asf("0 0.6 -0.8", "0 0,6 -0,8")),
        ("a direction that is not a number", asf("0 0.6 -0.8", "0 nan -0.8")),
        ("a length that is too large", asf("length 2", "length 1e39")),
        (
            "an angle that is too large in degrees",
            asf("angle deg", "angle rad").replace("axis 10", "axis 1e38"),
        ),
        ("a bone that is turned in no order", asf("0 0 0 XYZ", "0 0 0 XYZX")),
        ("an unknown dof", asf("dof rx ry rz", "dof rx rw rz")),
        ("a dof of length", asf("dof rx ry rz", "dof rx l")),
        ("a dof twice", asf("dof rx ry rz", "dof rx ry RX")),
        ("a limit that is not a number", asf("(-160.0", "(-l60.0")),
        ("no begin of the hierarchy", asf(":hierarchy\n  begin\n", ":hierarchy\n")),
        ("no end of the hierarchy", head("  end\n:hierarchy") + "  end\n:hierarchy\n  begin\n    root hip\n"),
        ("no end of the hierarchy, and a section", asf("    thigh shin\n  end\n", "    thigh shin\n:skin\n")),
        ("an unknown bone in the hierarchy", asf("thigh shin", "thigh shim")),
        ("an unknown parent in the hierarchy", asf("hip thigh", "torso thigh")),
        ("a second parent", asf("thigh shin", "thigh shin\n    hip shin")),
        ("a bone twice behind its parent", asf("thigh shin", "thigh shin shin")),
        ("a root that hangs on a bone", asf("thigh shin", "thigh shin root")),
        ("a bone that hangs on nothing", asf("    hip thigh\n", "")),
        ("bones in a circle", asf("root hip", "shin hip")),
        ("a bone that hangs on itself", asf("root hip", "hip hip")),
        ("something behind the hierarchy", format!("{ASF}end")),
    ]
}

/// What is wrong with a motion, and the text.
fn motions() -> Vec<(&'static str, String)> {
    vec![
        ("an empty motion", String::new()),
        ("a skeleton for a motion", ASF.to_owned()),
        ("prose for a motion", "Dear Sir or Madam".to_owned()),
        ("BVH for a motion", "HIERARCHY\nROOT Hips\n".to_owned()),
        ("a conflict among the frames", amc("shin 10", "=======\nshin 10")),
        ("no number of the first frame", amc("\n1\n", "\n")),
        ("a word for a frame number", amc("\n1\n", "\none\n")),
        ("a negative frame number", amc("\n2\n", "\n-2\n")),
        ("a frame number with more behind it", amc("\n2\n", "\n2 root\n")),
        ("a frame number that no number holds", amc("\n2\n", "\n18446744073709551616\n")),
        ("a flag among the frames", amc("\n2\n", "\n:RADIANS\n2\n")),
        ("an unknown bone", amc("shin 10", "shinn 10")),
        ("a bone that is like no other", amc("shin 10", "tail 10")),
        ("too few numbers", amc("thigh 7 8 9", "thigh 7 8")),
        ("no numbers", amc("shin 10", "shin")),
        ("too few numbers in a comment", amc("thigh 7 8 9", "thigh 7 8 # 9")),
        ("numbers on the next line", amc("thigh 7 8 9", "thigh 7 8\n9")),
        ("too many numbers", amc("thigh 7 8 9", "thigh 7 8 9 10")),
        ("numbers for a bone without dofs", amc("shin 10", "shin 10\nhip 0 0 0")),
        ("a bone twice in a frame", amc("shin 10", "thigh 7 8 9")),
        ("a bone without dofs twice in a frame", amc("shin 10", "shin 10\nhip\nhip")),
        ("a bone that a frame lacks", amc("shin 20\n", "")),
        (
            "a bone that a frame in the middle lacks",
            amc("shin 20", "3\nroot 1 2 3 4 5 6\nthigh 7 8 9\nshin 1"),
        ),
        ("a frame that is cut off", amc("thigh 17 18 19\nshin 20\n", "thi")),
        ("a number that is cut off", amc("shin 20\n", "shin -")),
        ("a bone that the first frame lacks", amc("shin 10\n", "")),
        ("a word for a number", amc("7 8 9", "7 eight 9")),
        ("a comma in the numbers", amc("7 8 9", "7,5 8 9")),
        ("NaN", amc("7 8 9", "7 NaN 9")),
        ("NaN as C programs print it", amc("7 8 9", "7 -1.#IND 9")),
        ("a number that is too large", amc("7 8 9", "7 1e39 9")),
        ("a number without an end", amc("7 8 9", &"7".repeat(5000))),
        ("what would upset a terminal", amc("7 8 9", "7 \u{1b}[31m\u{202e}8 9")),
    ]
}
