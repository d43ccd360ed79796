//! What is printed of bones.

use super::*;

/// `FK_LAB_BLESS=1` writes it again.
fn assert_golden(name: &str, now: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join("golden").join(name);
    if std::env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(&path, now).unwrap();
    }
    assert_eq!(now, fs::read_to_string(path).unwrap());
}

#[test]
fn bones_are_printed_with_all_that_the_file_says_of_them() {
    let (said, complaints) = run(&[&data("walk.asf"), &data("walk.amc"), "--print"]).unwrap();
    assert_eq!(complaints, "");
    assert_golden("walk.txt", &said);
}

#[test]
fn what_is_unusual_about_bones_is_printed() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 3);
    let text = odd_motion(3).replace("three 100\n", "").replace("three 120\n", "").replace("three 140\n", "");
    fs::write(&odd, text).unwrap();
    let limits = "dof ry rz rx\n    limits (-inf 10) (-5 inf) (1 2.5)";
    let bones = ODD_BONES.replace("dof ry rz rx", limits).replace("angle deg", "angle deg\n  force 3");
    fs::write(folder.path("odd one.asf"), bones).unwrap();
    let (said, _) = run(&[&odd, "--print", "--rate", "30"]).unwrap();
    for expected in [
        "ry ..10, rz -5.., rx 1..2.5",
        "ZXY",
        "order RY TZ TX TY RZ RX, position 1 2 3, orientation 10 20 30 YZX",
        "not moved        three\n",
        "rate             30 frames per second",
        "warning          line",
    ] {
        assert!(said.contains(expected), "{expected} is missing in: {said}");
    }
    let (alone, _) = run(&[&folder.text("odd one.asf"), "--print"]).unwrap();
    assert!(alone.contains("a skeleton alone") && !alone.contains("rate  "), "{alone}");
}

#[test]
fn names_in_wide_letters_do_not_move_the_columns() {
    let folder = Folder::new();
    let (asf, bvh) = (folder.text("bones.asf"), folder.text("joints.bvh"));
    // Two wide letters are as wide as four others.
    let [wide, narrow] = ["腰骨", "four"].map(|name| {
        fs::write(&asf, ODD_BONES.replace("two", name)).unwrap();
        run(&[&asf, "--out", &bvh, "--overwrite"]).unwrap();
        [&asf, &bvh].map(|file| run(&[file, "--print"]).unwrap().0)
    });
    assert_eq!(wide.map(|said| said.replace("腰骨", "four")), narrow);
}

#[test]
fn what_is_odd_about_the_skeleton_is_told_with_its_file() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 2);
    fs::write(folder.path("odd one.asf"), ODD_BONES.replace("direction 0 1 0", "direction 0 2 0")).unwrap();
    let (said, _) = run(&[&odd, "--print"]).unwrap();
    assert!(said.contains("\nwarning          in odd one.asf, line 15, column "), "{said}");
    let (said, _) = run(&[&folder.text("odd one.asf"), "--print"]).unwrap();
    assert!(said.contains("\nwarning          line 15, column "), "{said}");
}

/// What is read from a pipe is not there a second time.
#[test]
#[cfg(target_os = "linux")]
fn a_motion_and_the_same_one_warped_are_read_once() {
    let file = fs::File::open(data("dance.bvh")).unwrap();
    let (reader, mut writer) = std::io::pipe().unwrap();
    let feed = std::thread::spawn(move || std::io::copy(&mut { file }, &mut writer));
    let printed = command(&["/dev/stdin", "--print", "--warp", "9"]).stdin(reader).output().unwrap();
    feed.join().unwrap().unwrap();
    let said = String::from_utf8(printed.stdout).unwrap();
    assert!(printed.status.success() && said.contains("frames           9 (numbered 0 to 8)"), "{said}");
}

#[test]
fn help_fits_into_a_terminal_of_80_columns() {
    for help in ["--help", "-h"] {
        let output = command(&[help]).env("COLUMNS", "80").output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        let long: Vec<&str> = text.lines().filter(|line| line.chars().count() > 80).collect();
        assert!(text.contains("--between") && long.is_empty(), "{long:#?}");
    }
}

#[test]
fn a_warped_motion_is_not_printed_a_second_time() {
    let once = run(&[&data("walk.amc"), "--print"]).unwrap().0;
    for (warp, title, frames, seconds) in [
        (&["--warp", "960"][..], "480 → 960 frames", "960 (numbered 0 to 959)", "8.00"),
        (&["--between", "10,100"], "frames 10–100: 90 → 180", "570 (numbered 0 to 569)", "4.75"),
        (
            &["--between", "160,100", "--warp", "200"],
            "frames 100–160: 60 → 200",
            "620 (numbered 0 to 619)",
            "5.17",
        ),
    ] {
        let said = run(&[&[&*data("walk.amc"), "--print"], warp].concat()).unwrap().0;
        let facts = format!("frames           {frames}\nduration         {seconds} s\n");
        assert_eq!(said, format!("{once}\nwalk.amc, {title}\n\n{facts}"));
    }
}

#[test]
#[cfg(unix)]
fn no_name_of_a_bone_can_command_the_terminal() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 2);
    let bad = |text: &str| text.replace("two", "t\u{1b}[31m\u{202e}wo");
    fs::write(folder.path("odd one.asf"), bad(ODD_BONES)).unwrap();
    fs::write(&odd, bad(&odd_motion(2))).unwrap();
    let printed = run(&[&odd, "--print"]).unwrap().0;
    let warped = run(&[&odd, "--out", &folder.text("new.amc"), "--warp", "9"]).unwrap().0;
    assert!(warped.contains("the two angles of t"), "{warped}");
    assert!(![printed, warped].concat().contains(['\u{1b}', '\u{202e}']));
}
