//! What files of other programs look like: all of it is read, some of it with a warning.

mod common;

use common::{GOOD, with};
use glam::Vec3;
use parser::bvh::{self, ErrorKind, Reading, WarningKind};
use skeleton::{Motion, RotationOrder, Skeleton};

fn read(text: impl AsRef<[u8]>) -> Reading {
    bvh::read(text.as_ref())
        .unwrap_or_else(|error| panic!("{}\n{error}", String::from_utf8_lossy(text.as_ref())))
}

/// Reads a text in which there is nothing to warn of.
fn read_clean(text: impl AsRef<[u8]>) -> Motion {
    let reading = read(text);
    assert_eq!(reading.warnings, []);
    reading.motion
}

/// Reads a text that gives one warning. Gives it as it is shown, too.
fn read_with_warning(text: impl AsRef<[u8]>) -> (Motion, String) {
    let reading = read(text);
    assert_eq!(reading.warnings.len(), 1, "{:?}", reading.warnings);
    (reading.motion, reading.warnings[0].to_string())
}

fn names(skeleton: &Skeleton) -> Vec<&str> {
    skeleton.joints().iter().map(|joint| joint.name.as_str()).collect()
}

#[test]
fn a_plain_file_is_read() {
    let motion = read_clean(GOOD);
    let [hips, tip] = motion.skeleton().joints() else { panic!("two joints") };
    assert_eq!((hips.name.as_str(), hips.parent, hips.is_end_site), ("Hips", None, false));
    assert_eq!((hips.offset, hips.rotation_order), (Vec3::Y, RotationOrder::Zxy));
    assert_eq!((tip.name.as_str(), tip.parent, tip.is_end_site), ("End Site", Some(hips.id), true));
    assert_eq!((tip.offset, tip.channels.as_slice()), (Vec3::Y * 2.0, [].as_slice()));
    assert_eq!((motion.frame_count(), motion.frame_time()), (2, 0.04));
    assert_eq!(motion.values(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
}

#[test]
fn blanks_and_line_ends_do_not_matter() {
    let crlf = GOOD.replace('\n', "\r\n");
    let (head, frames) = GOOD.split_once("1 2 3").expect("frames");
    let same = [
        crlf.clone(),
        format!("{}1 2 3{frames}", head.replace('\n', "\r\n")),
        GOOD.trim_end().to_owned(),
        crlf.trim_end().to_owned(),
        GOOD.replace('\t', "    "),
        GOOD.replace('\n', " \t\n"),
        GOOD.replace('\n', "\n\n\n"),
        GOOD.replace('\n', "\n  \t"),
        format!("\n \n{GOOD}\n\n \t\n"),
        with("Frames: 2", "Frames:\t2"),
        with("Frames: 2", "Frames:2"),
        with("Frames: 2", "Frames :  2 "),
        with("Frame Time: 0.04", "Frame Time:\t0.04"),
        with("Frame Time: 0.04", "Frame  Time:   0.04"),
        with("Frame Time: 0.04", "Frame Time:0.04"),
        with("Frame Time: 0.04", "frame time: 0.04"),
        with("1 2 3\n4 5 6", "1 2 3 4 5 6"),
        with("1 2 3\n4 5 6", "1\n2\n3\n4\n5\n6"),
        with("1 2 3\n4 5 6", "  1\t\t2   3 \n\n 4 5 6  "),
        with("1 2 3\n4 5 6", "1 2\x0b3\n4 5\x0c6"),
        with("ROOT Hips\n{", "ROOT Hips {"),
        with("ROOT Hips\n{", "root \t Hips\t{"),
        GOOD.replacen('\n', " ", 10),
        with(
            "\tOFFSET 0 1 0\n\tCHANNELS 3 Zrotation Xrotation Yrotation\n",
            "\tCHANNELS 3 Zrotation Xrotation Yrotation\n\tOFFSET 0 1 0\n",
        ),
        with("Zrotation Xrotation Yrotation", "ZROTATION xrotation yRotation"),
        with("{\n\t\tOFFSET 0 2 0\n\t}\n}", "{OFFSET 0 2 0}}"),
        format!("\u{feff}{GOOD}"),
    ];
    let expected = read_clean(GOOD);
    for text in same {
        assert_eq!(read_clean(&text), expected, "{text}");
    }
}

#[test]
fn numbers_are_written_in_many_ways() {
    let numbers = "1e-006 .5 5. -0.000000 7 -1.25E+2";
    let motion = read_clean(with("1 2 3\n4 5 6", numbers));
    let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(motion.values()), bits(&[1e-6, 0.5, 5.0, -0.0, 7.0, -125.0]));
    assert_eq!(read_clean(with("0.04", ".0083333")).frame_time(), 0.0083333);
    assert_eq!(read_clean(with("0.04", "0.0417083750417")).frame_time(), 0.0417083750417);
}

#[test]
fn a_name_is_the_rest_of_its_line() {
    for name in
        ["LeftUpLeg", "a:b-c.d", "Left Up  Leg", "Hüfte", "腰", "JOINT", "{x}", "a{", "End Site", "1.5", "#"]
    {
        assert_eq!(names(read_clean(with("Hips", name)).skeleton()), [name, "End Site"]);
    }
}

#[test]
fn a_brace_may_stand_right_behind_a_name() {
    let expected = read_clean(GOOD);
    for text in [
        with("Hips\n{", "Hips{"),
        with("Hips\n{", "Hips{\r\n"),
        with("Hips\n{", "Hips{ "),
        with("End Site\n\t{", "End Site{"),
        with("Hips\n{\n\tOFFSET 0 1 0\n", "Hips{\n").replace("Yrotation\n", "Yrotation\nOFFSET 0 1 0\n"),
    ] {
        assert_eq!(read_clean(&text), expected, "{text}");
    }
}

#[test]
fn blanks_behind_a_name_do_not_count_for_its_length() {
    let (blanks, longest) = (" ".repeat(70_000), "x".repeat(4096));
    for name in ["Hips", &longest] {
        for brace in ["\n{", "\r\n{", "{ "] {
            let text = with("Hips\n{", &format!("{name}{blanks}{brace}"));
            assert_eq!(names(read_clean(text).skeleton()), [name, "End Site"]);
        }
    }
    let error = bvh::read(with("Hips", &format!("Hips{blanks}x")).as_bytes()).expect_err("a long name");
    assert!(matches!(error.kind(), ErrorKind::LongName { .. }), "{error}");
}

#[test]
fn an_end_site_keeps_its_name() {
    for name in ["End Site", "End Site20", "End Site Head Tip", "END SITE", "End  Site"] {
        let motion = read_clean(with("End Site", name));
        assert_eq!(names(motion.skeleton()), ["Hips", name]);
        assert!(motion.skeleton().joints()[1].is_end_site);
    }
}

#[test]
fn a_leaf_needs_no_end_site() {
    let motion = read_clean(with("\tEnd Site\n\t{\n\t\tOFFSET 0 2 0\n\t}\n", ""));
    assert_eq!(names(motion.skeleton()), ["Hips"]);
}

#[test]
fn bones_may_have_no_length() {
    let motion = read_clean(GOOD.replace("0 2 0", "0 0 0").replace("0 1 0", "0 0 0"));
    assert_eq!(motion.skeleton().extent(), 0.0);
}

#[test]
fn channels_come_in_any_number_and_order() {
    let orders = [
        ("6 Zrotation Xrotation Yrotation Yposition Xposition Zposition", RotationOrder::Zxy),
        ("1 Yrotation", RotationOrder::Yxz),
        ("2 Zrotation Yrotation", RotationOrder::Zyx),
        ("3 Zposition Xposition Yposition", RotationOrder::None),
        ("0", RotationOrder::None),
    ];
    for (list, order) in orders {
        let text = with("3 Zrotation Xrotation Yrotation", list)
            .replace("Frames: 2", "Frames: 0")
            .replace("1 2 3\n4 5 6\n", "");
        let motion = read_clean(text);
        let joint = &motion.skeleton().joints()[0];
        let words: Vec<&str> = joint.channels.iter().map(|channel| channel.word()).collect();
        assert_eq!(words.join(" "), list[1..].trim(), "{list}");
        assert_eq!(joint.rotation_order, order, "{list}");
    }
}

#[test]
fn a_motion_may_have_no_frames() {
    let motion = read_clean(with("2\nFrame Time: 0.04\n1 2 3\n4 5 6\n", "0\nFrame Time: 0.04\n"));
    assert_eq!((motion.frame_count(), motion.values()), (0, [].as_slice()));
}

#[test]
fn utf16_is_read_with_a_warning() {
    let text = with("Hips", "Hüfte 🦴");
    for big_endian in [false, true] {
        for mark in ["\u{feff}", ""] {
            let units = format!("{mark}{text}").encode_utf16().collect::<Vec<_>>();
            let bytes = |unit: &u16| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() };
            let bytes: Vec<u8> = units.iter().flat_map(bytes).collect();
            let (motion, warning) = read_with_warning(bytes);
            assert_eq!(motion, read_clean(&text));
            assert!(warning.starts_with("line 1, column 1: the text is UTF-16"), "{warning}");
        }
    }
}

#[test]
fn lone_carriage_returns_are_read_with_a_warning() {
    let (motion, warning) = read_with_warning(GOOD.replace('\n', "\r"));
    assert_eq!(motion, read_clean(GOOD));
    assert!(warning.starts_with("line 1, column 1: lines end with CR alone, this one first"), "{warning}");
    let error =
        bvh::read(with("5", "five").replace('\n', "\r").as_bytes()).expect_err("five is not a number");
    assert_eq!((error.line(), error.column()), (15, 3));
}

#[test]
fn several_roots_are_read_with_a_warning() {
    let second = "}\nROOT Other\n{\n\tOFFSET 5 0 0\n\tCHANNELS 0\n}\nMOTION";
    let (motion, warning) = read_with_warning(with("}\nMOTION", second));
    assert_eq!(names(motion.skeleton()), ["Hips", "End Site", "Other"]);
    assert!(motion.skeleton().joints()[2].is_root());
    assert!(warning.starts_with("line 11, column 6: this is a second ROOT"), "{warning}");
}

#[test]
fn a_repeated_name_is_read_with_a_warning() {
    let child = "\tJOINT Hips\n\t{\n\t\tOFFSET 0 0 0\n\t\tCHANNELS 0\n\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 0 0\n\t\t}\n\t}\n";
    let (motion, warning) = read_with_warning(with("\tEnd Site", &format!("{child}\tEnd Site")));
    assert_eq!(names(motion.skeleton()), ["Hips", "Hips", "End Site", "End Site"]);
    assert!(warning.starts_with("line 6, column 8: the name `Hips` was used in line 2 already"), "{warning}");
}

#[test]
fn a_joint_without_channels_is_read_with_a_warning() {
    let text = with("\tCHANNELS 3 Zrotation Xrotation Yrotation\n", "").replace("2\nFrame", "0\nFrame");
    let (motion, warning) = read_with_warning(text.replace("1 2 3\n4 5 6\n", ""));
    assert_eq!(motion.skeleton().channel_count(), 0);
    assert!(warning.starts_with("line 2, column 6: `Hips` has no CHANNELS"), "{warning}");
}

#[test]
fn frames_without_channels_are_left_out_with_a_warning() {
    let text = with("3 Zrotation Xrotation Yrotation", "0").replace("Frames: 2", "Frames: 999999999999");
    let (motion, warning) = read_with_warning(text.replace("1 2 3\n4 5 6\n", ""));
    assert_eq!(motion.frame_count(), 0);
    assert!(warning.contains("the 999999999999 frames declared can hold no numbers"), "{warning}");
}

#[test]
fn a_name_that_is_not_utf8_is_read_with_a_warning() {
    let latin1: Vec<u8> = with("Hips", "H§fte").bytes().filter(|&byte| byte != 0xc2).collect();
    let (motion, warning) = read_with_warning(latin1);
    assert_eq!(names(motion.skeleton()), ["H\u{fffd}fte", "End Site"]);
    assert!(warning.starts_with("line 2, column 6: the name `H\u{fffd}fte` is not UTF-8"), "{warning}");
}

#[test]
fn a_frame_time_that_cannot_be_played_is_read_with_a_warning() {
    for seconds in ["0", "-0.04", "1e-300", "9e-7", "1000001", "1e300"] {
        let (motion, warning) = read_with_warning(with("0.04", seconds));
        assert_eq!(seconds.parse(), Ok(motion.frame_time()));
        assert_eq!(motion.playable_frame_time(), 1.0 / 30.0);
        let expected = format!("line 13, column 13: a Frame Time of {seconds} s cannot be played");
        assert!(warning.starts_with(&expected), "{warning}");
    }
    for seconds in ["1e-6", "1e6"] {
        let motion = read_clean(with("0.04", seconds));
        assert_eq!(motion.playable_frame_time(), motion.frame_time());
    }
}

#[test]
fn of_too_many_rows_the_declared_ones_are_read_with_a_warning() {
    for rows in ["1 2 3\n4 5 6\n7 8 9\n7 8 9", "1 2 3 4 5 6 7 8 9 7 8 9", "1 2 3\n4\n5 6\n7\n8 9\n7 8 9"] {
        let (motion, warning) = read_with_warning(with("1 2 3\n4 5 6", rows));
        assert_eq!(motion, read_clean(GOOD), "{rows}");
        assert!(warning.contains("found 6 numbers more than the 2 frames that `Frames:` says"), "{warning}");
    }
    let (_, warning) = read_with_warning(with("4 5 6", "4 5 6\n7 8 9"));
    assert!(warning.starts_with("line 16, column 1: "), "{warning}");
}

#[test]
fn whole_frames_in_one_line_are_read_however_many_are_declared() {
    for (channels, row) in
        [("3 Zrotation Xrotation Yrotation", "1 2 3 4 5 6 7 8 9"), ("1 Zrotation", "1 2 3")]
    {
        let text = with("3 Zrotation Xrotation Yrotation", channels).replace("1 2 3\n4 5 6", row);
        for (declared, frames) in ["the 0 frames", "the 1 frame ", "the 2 frames"].into_iter().enumerate() {
            let text = text.replace("Frames: 2", &format!("Frames: {declared}"));
            let (motion, warning) = read_with_warning(&text);
            assert_eq!(motion.frame_count(), declared, "{text}");
            assert!(warning.contains(frames), "{warning}");
        }
        assert_eq!(read_clean(text.replace("Frames: 2", "Frames: 3")).frame_count(), 3);
    }
}

#[test]
fn junk_behind_the_frames_is_left_out_with_a_warning() {
    for junk in ["# made by hand", "\u{1a}", "\0\0\0\0", "NaN", "}", "HIERARCHY"] {
        let (motion, warning) = read_with_warning(format!("{GOOD}{junk}\n1 2 3\n"));
        assert_eq!(motion, read_clean(GOOD), "{junk:?}");
        assert!(warning.starts_with("line 16, column 1: `"), "{warning}");
    }
    let reading = read(format!("{GOOD}7 8 9\nend"));
    let kinds: Vec<&WarningKind> = reading.warnings.iter().map(|warning| &warning.kind).collect();
    assert!(matches!(kinds[..], [WarningKind::MoreRows { .. }, WarningKind::Junk { .. }]), "{kinds:?}");
}

#[test]
fn uneven_rows_that_add_up_are_read_with_a_warning() {
    let (motion, warning) = read_with_warning(with("1 2 3\n4 5 6", "1 2 3 4\n5 6"));
    assert_eq!(motion, read_clean(GOOD));
    assert!(warning.starts_with("line 14, column 1: this line holds 4 numbers, a frame 3"), "{warning}");
}

#[test]
fn position_channels_take_the_place_of_their_offsets() {
    let text = GOOD
        .replace("OFFSET 0 1 0", "OFFSET 10 20 30")
        .replace("3 Zrotation Xrotation Yrotation", "5 Zposition Zrotation Xrotation Xposition Yrotation")
        .replace("1 2 3\n4 5 6", "1 2 3 4 5\n6 7 8 9 10");
    let frame = read_clean(text).frame(1);
    assert_eq!(frame.angles, [7.0, 8.0, 10.0]);
    assert_eq!(frame.local_positions, [Vec3::new(9.0, 20.0, 6.0), Vec3::new(0.0, 2.0, 0.0)]);
}
