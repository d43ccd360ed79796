//! What Acclaim files of other programs look like: all of it is read, some of it with a warning.

mod common;

use common::acclaim::{
    AMC, ASF, amc, asf, figure, motion, motion_and_warnings, skeleton, skeleton_and_warnings,
};
use glam::Vec3;
use parser::acclaim;
use skeleton::acclaim::{AngleUnit, BoneId, DegreeOfFreedom, LocalAxes, Skeleton};
use skeleton::{Axis, Channel, RotationOrder};

fn utf16(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_le_bytes).collect()
}

fn names(skeleton: &Skeleton) -> Vec<&str> {
    skeleton.bones().iter().map(|bone| bone.name.as_str()).collect()
}

#[test]
fn a_plain_skeleton_is_read() {
    let skeleton = figure();
    assert_eq!((skeleton.name.as_str(), skeleton.units.length), ("FIGURE", 0.45));
    assert_eq!(names(&skeleton), ["root", "hip", "thigh", "shin"]);
    let [root, hip, thigh, shin] = skeleton.bones() else { panic!("four") };
    assert_eq!((root.dofs.len(), root.rotation_order), (6, RotationOrder::Zyx));
    assert_eq!((hip.parent, hip.dofs.len(), hip.direction, hip.length), (Some(root.id), 0, Vec3::X, 2.0));
    assert_eq!((thigh.parent, shin.parent), (Some(hip.id), Some(thigh.id)));
    assert_eq!(thigh.axis, LocalAxes { angles: [10.0, 0.0, 20.0], order: RotationOrder::Zyx });
    let limits: Vec<(String, f32, f32)> =
        thigh.dofs.iter().map(|dof| (dof.to_string(), dof.low, dof.high)).collect();
    assert_eq!(limits, [("rx".into(), -160.0, 20.0), ("ry".into(), -70.0, 70.0), ("rz".into(), -60.0, 70.0)]);
}

#[test]
fn a_plain_motion_is_read() {
    let motion = motion(AMC);
    assert_eq!(motion.frame_count(), 2);
    assert_eq!(motion.values(), (1..=20).map(|value| value as f32).collect::<Vec<_>>());
    let posture = motion.posture(1);
    assert_eq!(posture.angles, [[14.0, 15.0, 16.0], [0.0; 3], [17.0, 18.0, 19.0], [20.0, 0.0, 0.0]]);
    assert_eq!(posture.translations[0], Vec3::new(11.0, 12.0, 13.0));
}

#[test]
fn blanks_comments_and_line_ends_do_not_matter_in_a_skeleton() {
    let same = [
        ASF.replace('\n', "\r\n"),
        ASF.trim_end().to_owned(),
        ASF.replace("  ", "\t"),
        ASF.replace('\n', " \t\n\n"),
        ASF.replace('\n', " # a comment: ( 1 2 end\n"),
        ASF.replace('\n', "\n#comment\n"),
        format!("\u{feff}{ASF}"),
        format!("#!OML:ASF C:\\x.asf\n# made by hand\n{ASF}"),
        ASF.replace(":bonedata", ":BoneData")
            .replace("begin", "BEGIN")
            .replace("XYZ", "xyz")
            .replace("TX TY", "tx Ty"),
        asf("  One leg.\n", ""),
        asf("  One leg.\n", "a:b 1 2 end\n begin\n# :root\n"),
        asf("  mass 1.0\n  length 0.45\n", "  length 4.5e-001\n  mass 1\n"),
        asf("  order TX TY TZ RX RY RZ\n  axis XYZ\n", "  axis XYZ\n  order TX TY TZ RX RY RZ\n"),
        asf("  position 0 0 0\n  orientation 0 0 0\n", ""),
        asf("    id 1\n", ""),
        asf("    id 1\n", "    id one two\n    bodymass 10.0\n    cofmass 1.0 end\n"),
        asf("    direction 1 0 0\n    length 2\n", "    length\n2\n    direction 1.\n .0 -0\n"),
        asf("axis 10 0 20 XYZ", "axis 1.0e+001 -0.0 20   XYZ"),
        asf("(-160.0 20.0)\n           (-70.0 70.0)", "(-160.0,20.0), ( -70.0 , 70.0 )"),
        asf("(-160.0 20.0)\n", "-160 20"),
        asf("thigh shin", "THIGH Shin"),
        asf("    hip thigh\n    thigh shin\n", "    thigh shin\n    hip thigh\n    shin\n"),
        format!("{ASF}:skin body.obj\n  other.obj\n"),
        moved_to_the_end(":name FIGURE\n"),
        moved_to_the_end(":units\n  mass 1.0\n  length 0.45\n  angle deg\n"),
    ];
    let expected = figure();
    for text in same {
        assert_eq!(skeleton(&text), expected, "{text}");
    }
}

/// The skeleton's text with one of its sections behind all others.
fn moved_to_the_end(section: &str) -> String {
    asf(section, "") + section
}

#[test]
fn blanks_comments_and_line_ends_do_not_matter_in_a_motion() {
    let same = [
        AMC.replace('\n', "\r\n"),
        AMC.trim_end().to_owned(),
        AMC.replace(' ', "\t  "),
        AMC.replace('\n', "  \n\n\t\n"),
        AMC.replace('\n', " # a comment: 1 root\n"),
        format!("\u{feff}{AMC}"),
        AMC.replace("\n2\n", "\n# in between\n 2 # the second\n"),
        AMC.to_lowercase(),
        AMC.replace("thigh", "Thigh"),
        amc("thigh 7 8 9\nshin 10\n", "shin 10\nhip\nthigh 7.0 +8 9e0\n"),
        amc("thigh 17 18 19\nshin 20\n", "shin 20\nthigh 17 18 19\n"),
        amc(":FULLY-SPECIFIED\n:DEGREES\n", ""),
        amc(":DEGREES\n", ""),
        amc("10\n", "1.0e+001\n"),
        amc("\n1\n", "\n0\n").replace("\n2\n", "\n1\n"),
    ];
    let expected = motion(AMC);
    for text in same {
        assert_eq!(motion(&text), expected, "{text}");
    }
}

#[test]
fn other_encodings_are_read_with_a_warning() {
    let warning = "line 1, column 1: the text is UTF-16; it was converted. Save it as UTF-8 so that other programs can \
                   read it";
    assert_eq!(skeleton_and_warnings(utf16(ASF)), (figure(), vec![warning.to_owned()]));
    let marked = [&[0xff, 0xfe][..], &utf16(AMC)].concat();
    assert_eq!(motion_and_warnings(marked, &figure()), (motion(AMC), vec![warning.to_owned()]));
    let (skeleton, warnings) = skeleton_and_warnings(ASF.replace('\n', "\r"));
    assert_eq!(skeleton, figure());
    let lone =
        "line 1, column 1: lines end with CR alone, this one first; they were read as lines all the same";
    assert_eq!(warnings, [lone]);
    let (read, warnings) = motion_and_warnings(AMC.replace('\n', "\r"), &figure());
    assert_eq!((read, warnings), (motion(AMC), vec![lone.to_owned()]));
    let text = ASF.replace("shin", "s\u{1}").into_bytes();
    let text: Vec<u8> = text.into_iter().map(|byte| if byte == 1 { 0xff } else { byte }).collect();
    let (skeleton, warnings) = skeleton_and_warnings(text);
    assert_eq!(names(&skeleton)[3], "s\u{fffd}");
    let encoding =
        "line 35, column 10: the name `s\u{fffd}` is not UTF-8; what cannot be read of it was replaced";
    assert_eq!(warnings, [encoding]);
}

#[test]
fn names_are_words_of_any_letters() {
    for name in ["LeftUpLeg", "a:b-c.d", "Hüfte", "腰", "1.5", "7", "(x)", "a#b", "bone", "end1", "XYZ"] {
        let skeleton = skeleton(ASF.replace("thigh", name));
        assert_eq!(names(&skeleton)[2], name);
        let (motion, warnings) = motion_and_warnings(AMC.replace("thigh", name), &skeleton);
        assert_eq!((motion.posture(0).angles[2], warnings.len()), ([7.0, 8.0, 9.0], 0), "{name}");
    }
}

#[test]
fn a_line_of_one_whole_number_is_a_frame_number_even_if_a_bone_is_called_so() {
    let skeleton = skeleton(ASF.replace("shin", "2"));
    let (motion, _) = motion_and_warnings(AMC.replace("shin", "2"), &skeleton);
    assert_eq!((motion.frame_count(), motion.posture(1).angles[3][0]), (2, 20.0));
}

#[test]
fn dofs_come_in_any_selection_and_order() {
    let text = asf("dof rx ry rz", "dof rz TY rx").replace("order TX TY TZ RX RY RZ", "order RZ TY RX");
    let skeleton = skeleton(&text);
    let words = |id: usize| skeleton.bones()[id].dofs.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!((words(0), words(2)), (vec!["rz".into(), "ty".into(), "rx".into()], words(2)));
    assert_eq!(words(2), ["rz", "ty", "rx"]);
    let (motion, _) = motion_and_warnings("1\nroot 1 2 3\nthigh 4 5 6\nshin 7", &skeleton);
    let posture = motion.posture(0);
    assert_eq!((posture.angles[0], posture.angles[2]), ([3.0, 0.0, 1.0], [6.0, 0.0, 4.0]));
    assert_eq!((posture.translations[0], posture.translations[2]), (Vec3::Y * 2.0, Vec3::Y * 5.0));
}

#[test]
fn an_axis_may_be_turned_in_any_order() {
    for (letters, order) in [
        ("XYZ", RotationOrder::Zyx),
        ("xzy", RotationOrder::Yzx),
        ("YXZ", RotationOrder::Zxy),
        ("YZX", RotationOrder::Xzy),
        ("ZXY", RotationOrder::Yxz),
        ("ZYX", RotationOrder::Xyz),
    ] {
        let skeleton = skeleton(asf("axis 10 0 20 XYZ", &format!("axis 10 0 20 {letters}")));
        assert_eq!(skeleton.bones()[2].axis, LocalAxes { angles: [10.0, 0.0, 20.0], order });
        let root =
            asf("axis XYZ", &format!("axis {letters}")).replace("orientation 0 0 0", "orientation 1 2 3");
        let root = common::acclaim::skeleton(root).root().axis;
        assert_eq!(root, LocalAxes { angles: [1.0, 2.0, 3.0], order });
    }
}

#[test]
fn the_roots_position_is_added_to_every_frame() {
    let skeleton = skeleton(asf("position 0 0 0", "position 1 2 3"));
    let (motion, _) = motion_and_warnings(AMC, &skeleton);
    assert_eq!(motion.posture(0).translations[0], Vec3::new(2.0, 4.0, 6.0));
    assert_eq!(motion.row(0).map(|row| &row[..3]), Some(&[1.0, 2.0, 3.0][..]));
}

#[test]
fn radians_become_degrees() {
    let text = asf("angle deg", "angle rad")
        .replace("axis 10 0 20", "axis 0 0 0.5")
        .replace("(-160.0 20.0)\n           (-70.0 70.0)", "(-inf 1)\n (-Infinity +inf)");
    let skeleton = skeleton(text);
    assert_eq!(skeleton.units.angle, AngleUnit::Radians);
    let thigh = &skeleton.bones()[2];
    assert_eq!(thigh.axis.angles, [0.0, 0.0, 0.5_f64.to_degrees() as f32]);
    assert_eq!((thigh.dofs[0].low, thigh.dofs[0].high), (f32::NEG_INFINITY, 1_f64.to_degrees() as f32));
    assert!(!thigh.dofs[1].is_limited());
    let degrees = |text: &str, skeleton| motion_and_warnings(text, skeleton).0.posture(0);
    assert_eq!(degrees(AMC, &skeleton).angles[3][0], 10.0, "the motion says :DEGREES");
    let unsaid = degrees(&amc(":DEGREES\n", ""), &skeleton);
    assert_eq!(unsaid.angles[3][0], 10_f64.to_degrees() as f32);
    assert_eq!(unsaid.translations[0], Vec3::new(1.0, 2.0, 3.0), "lengths stay");
    let said = degrees(&amc(":DEGREES", ":radians"), &figure());
    assert_eq!(said.angles[3][0], 10_f64.to_degrees() as f32);
}

#[test]
fn brackets_and_commas_between_numbers_and_dofs_are_blanks() {
    let text = asf("direction 0 -1 0", "direction (0, -1, 0)")
        .replace("axis 10 0 20 XYZ", "axis(10 ,0 , 20),XYZ")
        .replace("dof rx ry rz", "dof (rx,ry, rz)")
        .replace("limits (-160.0 20.0)", "limits(-160.0,20.0)")
        .replace("position 0 0 0", "position (0, 0, 0)")
        .replace("order TX TY TZ RX RY RZ", "order TX, TY, TZ, RX, RY, RZ");
    assert_eq!(skeleton(text), figure());
    let text = amc("thigh 7 8 9", "thigh (7, 8, 9)").replace("shin 20", "shin ( 20 )");
    assert_eq!(motion(text), motion(AMC));
    // Names are as they are.
    let text = ASF.replace("thigh", "thigh(l,1)");
    assert_eq!(skeleton(text).bones()[2].name, "thigh(l,1)");
}

#[test]
fn a_list_of_dofs_may_go_on_in_the_next_line() {
    assert_eq!(skeleton(asf("dof rx ry rz", "dof rx # and\n  ry\n rz")), figure());
}

#[test]
fn infinite_limits_are_read_in_all_spellings() {
    for (low, high) in [("-inf", "inf"), ("-Infinity", "+INF"), ("-1.#INF", "1.#INF")] {
        let text = asf("(-10.0 170.0)", &format!("({low} {high})"));
        assert!(!skeleton(text).bones()[3].dofs[0].is_limited(), "{low} {high}");
    }
}

#[test]
fn limits_of_translations_are_lengths() {
    let text =
        asf("angle deg", "angle rad").replace("dof rx\n    limits (-10.0 170.0)", "dof tx\n limits (-1 2)");
    let dof = skeleton(text).bones()[3].dofs[0];
    assert_eq!(dof, DegreeOfFreedom { channel: Channel::Position(Axis::X), low: -1.0, high: 2.0 });
}

#[test]
fn all_joints_may_be_forced_to_have_three_dofs() {
    let text = amc(":FULLY-SPECIFIED\n", ":FULLY-SPECIFIED\n:FORCE-ALL-JOINTS-BE-3DOF\n")
        .replace("shin 10", "shin 10 11 12")
        .replace("shin 20", "shin 20 21 22");
    let motion = motion(text);
    assert!(motion.columns().has_three_angles());
    assert_eq!(motion.posture(0).angles, [[4.0, 5.0, 6.0], [0.0; 3], [7.0, 8.0, 9.0], [10.0, 11.0, 12.0]]);
    // Those that the skeleton lists come first.
    let skeleton = skeleton(asf("dof rx\n    limits (-10.0 170.0)", "dof ry"));
    let text = ":FORCE-ALL-JOINTS-BE-3DOF\n1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshin 1 2 3";
    assert_eq!(motion_and_warnings(text, &skeleton).0.posture(0).angles[3], [2.0, 1.0, 3.0]);
}

#[test]
fn bones_come_out_parents_first_in_any_order_of_the_file() {
    let bone = |name: &str| format!("begin\nname {name}\ndirection 0 1 0\nlength 1\naxis 0 0 0 XYZ\nend\n");
    let file = |hierarchy: &str| {
        let bones: String = ["d", "b", "c", "a", "e"].into_iter().map(bone).collect();
        format!(":root\norder TX\n:bonedata\n{bones}:hierarchy\nbegin\n{hierarchy}\nend\n")
    };
    let skeleton = skeleton(file("c d\nroot a\nb c\na b e"));
    assert_eq!(names(&skeleton), ["root", "a", "b", "c", "d", "e"]);
    let children = |id| skeleton.children(BoneId(id)).map(|bone| bone.id.0).collect::<Vec<_>>();
    assert_eq!((children(0), children(1), children(2)), (vec![1], vec![2, 5], vec![3]));
    let skeleton = common::acclaim::skeleton(file("root a b c d e"));
    assert_eq!(names(&skeleton), ["root", "d", "b", "c", "a", "e"]);
}

#[test]
fn a_root_can_be_alone() {
    let skeleton = skeleton(":root\norder\n:bonedata\n:hierarchy\nbegin\nend");
    assert_eq!((skeleton.len(), skeleton.root().dofs.len()), (1, 0));
    let (motion, warnings) = motion_and_warnings("1\n2\nroot\n3", &skeleton);
    assert_eq!((motion.frame_count(), motion.values().len(), warnings.len()), (3, 0, 0));
}

#[test]
fn oddities_of_a_skeleton_are_warned_of() {
    let odd = [
        (
            asf(":root", ":shape round\n box\n:root"),
            "line 9, column 1: `:shape` is not known here; it was left out",
        ),
        (
            asf("  mass 1.0", "  time 1.0"),
            "line 4, column 3: `time` is not known here; the line was left out",
        ),
        (
            asf("    length 2", "    colour red # a\n    length 2"),
            "line 19, column 5: `colour` is not known here; the line was left out",
        ),
        (
            asf("  order TX TY TZ RX RY RZ\n", ""),
            "line 9, column 6: the root has no `order`; it was read as TX TY TZ RX RY RZ",
        ),
        (
            asf("    axis 0 0 0 XYZ\n", ""),
            "line 17, column 10: the bone `hip` has no `axis`; it was read as 0 0 0 XYZ",
        ),
        (
            asf("direction 1 0 0", "direction 1 1 0"),
            "line 17, column 10: the direction of `hip` is 1.4142135 long instead of 1; the bone is as much longer or \
             shorter",
        ),
        (
            asf("limits (-10.0 170.0)", "limits (-10.0 170.0) (1 2)"),
            "line 40, column 11: `shin` has 4 numbers for its limits instead of two for each of 1 dof; limits that are \
             missing were left open",
        ),
        (
            asf("           (-60.0 70.0)\n", ""),
            "line 29, column 11: `thigh` has 4 numbers for its limits instead of two for each of 3 dofs; limits that \
             are missing were left open",
        ),
    ];
    for (text, expected) in odd {
        assert_eq!(skeleton_and_warnings(&text).1, [expected], "{text}");
    }
    let open = skeleton_and_warnings(asf("           (-60.0 70.0)\n", "")).0.bones()[2].dofs[2];
    assert!(!open.is_limited());
    let zero = asf("direction 1 0 0\n    length 2", "direction 0 0 0\n    length 0");
    assert_eq!(skeleton(zero).bones()[1].length, 0.0, "a bone without length needs no direction");
}

#[test]
fn oddities_of_a_motion_are_warned_of() {
    let odd = [
        (
            amc(":DEGREES", ":SAMPLES-PER-SECOND 120"),
            "line 3, column 1: `:SAMPLES-PER-SECOND` is not known here; it was left out",
        ),
        (
            amc("\n2\n", "\n5\n"),
            "line 8, column 1: frame 5 stands where frame 2 should; the frames were read in the order of the file",
        ),
        (
            amc("\n2\n", "\n1\n"),
            "line 8, column 1: frame 1 stands where frame 2 should; the frames were read in the order of the file",
        ),
        (
            AMC.replace("shin 10\n", "").replace("shin 20\n", ""),
            "line 4, column 1: the motion has no line for `shin`; what has no line stays as it is at rest",
        ),
        (
            String::from(":DEGREES\n1\nshin 1\n"),
            "line 2, column 1: the motion has no line for `root` and 1 bone more; what has no line stays as it is at \
             rest",
        ),
        (
            String::from(":DEGREES\n1\n2\n3"),
            "line 2, column 1: the motion has no line for `root` and 2 bones more; what has no line stays as it is at \
             rest",
        ),
        (
            String::from(":DEGREES\n"),
            "line 2, column 1: there are no frames; the motion was read without any",
        ),
    ];
    for (text, expected) in odd {
        assert_eq!(motion_and_warnings(&text, &figure()).1, [expected], "{text}");
    }
    let (motion, _) = motion_and_warnings("1\nshin 1\n2\nshin 2", &figure());
    assert_eq!((motion.columns().still(), motion.values()), (&[BoneId(0), BoneId(2)][..], &[1.0, 2.0][..]));
    assert_eq!(motion.posture(1).angles[3], [2.0, 0.0, 0.0]);
}

#[test]
fn warnings_are_in_the_order_of_the_text() {
    let text = ASF.replace('\n', "\r").replace("direction 1 0 0", "direction 2 0 0").replace("  mass", "  x");
    let lines: Vec<u64> = acclaim::read_skeleton(text.as_bytes())
        .expect("a skeleton with oddities")
        .warnings
        .iter()
        .map(|warning| warning.line)
        .collect();
    assert_eq!(lines, [1, 4, 17]);
}
