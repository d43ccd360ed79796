//! Where the files go, and what must not happen to those that are there.

use super::*;

#[test]
fn a_motion_is_never_lost() {
    let folder = Folder::new();
    let (file, other) = (folder.text("arm.bvh"), folder.text("other motion.bvh"));
    fs::write(&file, arm(9)).unwrap();
    fs::write(&other, arm(4)).unwrap();
    let link = folder.text("link.bvh");
    #[cfg(unix)]
    std::os::unix::fs::symlink(&file, &link).unwrap();
    #[cfg(not(unix))]
    fs::write(&link, arm(9)).unwrap();

    for out in [&*file, &folder.text("./arm.bvh")] {
        let told = run(&[&file, "--out", out, "--overwrite"]).unwrap_err();
        assert_eq!(told, format!("{out} is the motion: the new motion needs a name of its own\n"));
    }
    if cfg!(unix) {
        assert!(run(&[&file, "--out", &link, "--overwrite"]).unwrap_err().contains("is the motion"));
        assert!(run(&[&link, "--out", &file, "--overwrite"]).unwrap_err().contains("is the motion"));
    }
    let told = run(&[&file, "--out", &other]).unwrap_err();
    let expected =
        "is there already: choose another name, or add --overwrite to put the new motion in its place\n";
    assert_eq!(told, format!("{other} {expected}"));
    // The name of a motion alone, behind --out: what is meant is to look at it.
    assert!(run(&["--out", &other]).unwrap_err().ends_with(expected));
    assert_eq!(fs::read_to_string(&other).unwrap(), arm(4));

    run(&[&file, "--out", &other, "--overwrite", "--keyframes", "3"]).unwrap();
    assert_eq!(read(&other).frame_count(), 9);
    assert_eq!(fs::read_to_string(&file).unwrap(), arm(9));
    assert_eq!(folder.names(), ["arm.bvh", "link.bvh", "other motion.bvh"]);
}

#[test]
fn every_ending_is_looked_at_before_anything_is_read() {
    let told = |arguments: &[&str]| run(&[&["no such file.bvh"], arguments].concat()).unwrap_err();
    for (option, what, endings) in [
        ("--out", "new motion", "bvh, .amc or .asf"),
        ("--plot", "picture", "svg"),
        ("--csv", "table", "csv"),
    ] {
        for name in ["error", "error.png", ".bv", "a.bvh.txt"] {
            let expected = format!(
                "{option} names the {what} to write, and that name ends in .{endings}: {name} does not\n"
            );
            assert_eq!(told(&[option, name]), expected);
        }
    }
    let expected =
        "--csv names the table to write; to show my dance.BVH: cargo view \"my dance.BVH\" --csv table.csv\n";
    assert_eq!(told(&["--csv", "my dance.BVH"]), expected);
    let expected =
        "--plot names the picture to write; to show walk.amc: cargo view walk.amc --plot picture.svg\n";
    assert_eq!(told(&["--plot", "walk.amc"]), expected);
    // All of them, not the first one only.
    assert!(told(&["--out", "new.bvh", "--plot", "error.svg", "--csv", "error.txt"]).contains(".csv"));
    assert!(told(&["--out", "new.BVH", "--csv", "new.CSV"]).contains("no such file.bvh"));
}

#[test]
fn what_cannot_be_written_is_told_and_nothing_is_left_behind() {
    let folder = Folder::new();
    let file = folder.text("arm.bvh");
    fs::write(&file, arm(9)).unwrap();
    for name in ["folder.bvh", "folder.svg", "folder.csv"] {
        fs::create_dir(folder.path(name)).unwrap();
    }
    for (option, what, ending) in
        [("--out", "new motion", "bvh"), ("--plot", "picture", "svg"), ("--csv", "table", "csv")]
    {
        let overwrite: &[&str] = if option == "--out" { &["--overwrite"] } else { &[] };
        let told = |target: &str| run(&[&[&*file, option, target], overwrite].concat()).unwrap_err();
        let target = folder.text(&format!("folder.{ending}"));
        assert_eq!(told(&target), format!("{target} is a folder: the {what} needs a name of its own\n"));
        for (name, is) in [("none", "is not there"), ("arm.bvh", "is no folder")] {
            let target = folder.text(&format!("{name}/new.{ending}"));
            let expected = format!(
                "the {what} cannot be written to {target}: the folder {} {is}; make it first, or choose another\n",
                folder.text(name)
            );
            assert_eq!(told(&target), expected);
        }
    }
    assert_eq!(folder.names(), ["arm.bvh", "folder.bvh", "folder.csv", "folder.svg"]);
}

#[test]
#[cfg(unix)]
fn no_name_can_command_the_terminal() {
    let folder = Folder::new();
    let file = folder.text("a\u{1b}[31m\u{202e}.bvh");
    fs::write(&file, arm(9).replace("ROOT r", "ROOT \u{7}r").replace("3 Zrotation Xr", "3 Yposition Xr"))
        .unwrap();
    let out = folder.text("b\u{1b}[31m.bvh");
    let (said, complaints) = run(&[&file, "--out", &out, "--keyframes", "3"]).unwrap();
    assert!(
        said.contains("9 frames, 3 keyframes") && complaints.contains("2 rotation channels"),
        "{complaints}"
    );
    let told = run(&[&file, "--out", &out]).unwrap_err() + &run(&[&out, "--out", &out]).unwrap_err();
    let ending =
        run(&[&file, "--out", "c\u{1b}.txt"]).unwrap_err() + &run(&["--csv", "\u{1b}.bvh"]).unwrap_err();
    for text in [said, complaints, told, ending] {
        assert!(!text.contains(['\u{1b}', '\u{7}', '\u{202e}']), "{text:?}");
    }
}

#[test]
fn options_that_mean_nothing_together_are_refused() {
    let folder = Folder::new();
    let (out, csv) = (folder.text("new.bvh"), folder.text("error.csv"));
    for wrong in [
        &["--out", &out, "--png", "a.png"][..],
        &["--csv", &csv, "--print"],
        &["--out", &out, "--frames", "0..9"],
        &["--out", &out, "--size", "100x100"],
        &["--plot", "error.svg", "--camera", "1,2"],
        &["--csv", &csv, "--mode", "euler"],
        &["--plot", "error.svg", "--csv", &csv, "--mode", "euler"],
        &["--csv", &csv, "--overwrite"],
        &["--out", &out, "--method", "best"],
        &["--keyframes", "20", "--print"],
        &["--mode", "euler", "--print"],
        &["--png", "a.png", "--method", "even"],
        &["--size", "100x100", "--overwrite"],
    ] {
        let output = view(&[&[&*data("arm.bvh")], wrong].concat());
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
    }
    let told = run(&[&data("arm.bvh"), &data("dance.bvh"), "--csv", &csv]).unwrap_err();
    assert_eq!(told, "keyframes are those of one motion, and there are 2 files\n");
    assert!(folder.names().is_empty());
}

#[test]
fn what_is_odd_about_a_file_is_told_and_what_is_wrong_ends_it() {
    let folder = Folder::new();
    let (file, out) = (folder.text("odd one.bvh"), folder.text("new.bvh"));
    fs::write(&file, arm(9) + "1 2 3\n").unwrap();
    let (_, complaints) = run(&[&file, "--out", &out]).unwrap();
    assert!(
        complaints.starts_with("odd one.bvh: line ") && complaints.contains("3 numbers more"),
        "{complaints}"
    );
    fs::write(&file, arm(9).replace("OFFSET 0 10 0", "OFFSET 0 ten 0")).unwrap();
    let told = run(&[&file, "--out", &out, "--overwrite"]).unwrap_err();
    assert!(told.contains("odd one.bvh:8:10"), "{told}");
}
