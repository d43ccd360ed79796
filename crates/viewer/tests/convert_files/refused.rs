//! What cannot be written, and what must not happen to files that are there.

use super::*;

#[test]
fn what_bones_cannot_say_is_told_with_its_joint_and_frame() {
    let folder = Folder::new();
    let out = folder.text("arm.amc");
    let told = run(&[&data("arm.bvh"), "--out", &out]).unwrap_err();
    let expected = "arm.bvh: in frame 2 (counted from 1) the joint `Slide` is elsewhere on its parent than before: bones do not \
                    change their length\n";
    assert_eq!(told, expected);
    let told = run(&[&data("arm.bvh"), "--out", &out, "--warp", "9"]).unwrap_err();
    assert_eq!(told, expected);
    let file = folder.text("two.bvh");
    let root = |name: &str| format!("ROOT {name}\n{{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}}\n");
    let text = format!("HIERARCHY\n{}{}MOTION\nFrames: 1\nFrame Time: 1\n1 2\n", root("a"), root("b"));
    fs::write(&file, text).unwrap();
    let told = run(&[&file, "--out", &out]).unwrap_err();
    let (_, told) = told.split_once('\n').unwrap();
    assert_eq!(told, "two.bvh: `b` is a second root, and a skeleton of bones has one\n");
    assert_eq!(folder.names(), ["two.bvh"]);
}

#[test]
fn neither_of_two_files_is_overwritten_unless_that_is_said() {
    let folder = Folder::new();
    let file = data("dance.bvh");
    let (amc, asf) = (folder.text("new dance.amc"), folder.text("new dance.asf"));
    let there = |path: &str, what: &str| {
        format!(
            "{path} is there already: choose another name, or add --overwrite to put the {what} in its place\n"
        )
    };
    fs::write(&asf, "older").unwrap();
    assert_eq!(run(&[&file, "--out", &amc]).unwrap_err(), there(&asf, "new skeleton"));
    fs::remove_file(&asf).unwrap();
    fs::write(&amc, "older").unwrap();
    assert_eq!(run(&[&file, "--out", &amc]).unwrap_err(), there(&amc, "new motion"));
    assert_eq!(folder.names(), ["new dance.amc"]);
    run(&[&file, "--out", &amc, "--overwrite"]).unwrap();
    assert_eq!(read_bones(&amc).frame_count(), read(&file).frame_count());
    assert_eq!(folder.names(), ["new dance.amc", "new dance.asf"]);
}

#[test]
fn neither_a_motion_nor_its_skeleton_is_ever_lost() {
    let folder = Folder::new();
    let odd = odd_files(&folder, 3);
    let (asf, other) = (folder.text("odd one.asf"), folder.text("other.asf"));
    let told = run(&[&odd, "--out", &odd, "--overwrite"]).unwrap_err();
    assert_eq!(told, format!("{odd} is the motion: the new motion needs a name of its own\n"));
    let told = run(&[&odd, "--out", &asf, "--overwrite"]).unwrap_err();
    assert_eq!(told, format!("{asf} is the skeleton: the new motion needs a name of its own\n"));
    // The skeleton beside the new motion is the one that is read.
    fs::rename(&asf, &other).unwrap();
    let out = folder.text("other.amc");
    let told = run(&[&other, &odd, "--out", &out, "--overwrite", "--warp", "6"]).unwrap_err();
    assert_eq!(told, format!("{other} is the skeleton: the new skeleton needs a name of its own\n"));
    assert_eq!(fs::read_to_string(&other).unwrap(), ODD_BONES);
    assert_eq!(folder.names(), ["odd one.amc", "other.asf"]);
}

#[test]
fn when_one_of_two_cannot_be_written_the_other_is_not_there() {
    let folder = Folder::new();
    let (amc, asf) = (folder.text("new.amc"), folder.text("new.asf"));
    for (taken, what, warp) in
        [(&amc, "motion", &[][..]), (&asf, "skeleton", &[]), (&amc, "motion", &["--warp", "30"])]
    {
        fs::create_dir(taken).unwrap();
        let told = run(&[&[&*data("dance.bvh"), "--out", &amc, "--overwrite"], warp].concat()).unwrap_err();
        assert_eq!(told, format!("{taken} is a folder: the new {what} needs a name of its own\n"));
        assert_eq!(folder.names().len(), 1, "{:?}", folder.names());
        fs::remove_dir(taken).unwrap();
    }
    // What bones cannot hold is found when the first of the two files is there in part.
    let file = folder.text("far.bvh");
    let text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 3e38 3e38 3e38\n}\n}\n\
                MOTION\nFrames: 1\nFrame Time: 0.5\n10\n";
    fs::write(&file, text).unwrap();
    let told = run(&[&file, "--out", &amc]).unwrap_err();
    let expected = format!(
        "the motion and its skeleton cannot be written to {amc} and {asf}: a number of `r_end` is not"
    );
    assert!(told.starts_with(&expected), "{told}");
    assert_eq!(folder.names(), ["far.bvh"]);
}

#[test]
#[cfg(unix)]
fn a_link_is_there_even_if_it_leads_nowhere() {
    let folder = Folder::new();
    let out = folder.text("link.bvh");
    std::os::unix::fs::symlink("nowhere.bvh", &out).unwrap();
    let told = run(&[&data("walk.amc"), "--out", &out]).unwrap_err();
    assert!(told.starts_with(&format!("{out} is there already: ")), "{told}");
    assert!(fs::symlink_metadata(&out).unwrap().is_symlink());
}

/// Ends the program while it writes more frames than it could in any time.
#[test]
#[cfg(unix)]
fn ctrl_c_leaves_nothing_behind_and_what_was_there() {
    let folder = Folder::new();
    let (amc, asf) = (folder.text("endless.amc"), folder.text("endless.asf"));
    fs::write(&asf, "older").unwrap();
    let arguments = [&*data("dance.bvh"), "--warp", "100000000", "--out", &amc, "--overwrite"];
    let mut running = command(&arguments).stderr(std::process::Stdio::null()).spawn().unwrap();
    while folder.names().len() < 3 {
        assert!(running.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::yield_now();
    }
    let id = running.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(running.wait().unwrap().code(), Some(130));
    assert_eq!(
        (folder.names(), fs::read_to_string(&asf).unwrap()),
        (vec!["endless.asf".into()], "older".into())
    );
}

/// What nobody would miss on a terminal is lost in a file.
#[test]
#[cfg(target_os = "linux")]
fn an_output_that_cannot_be_written_is_told_and_one_that_nobody_reads_is_not() {
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let output = command(&[&data("walk.amc"), "--print"]).stdout(full).output().unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(1) && told.contains("the standard output"), "{told}");
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = command(&[&data("walk.amc"), "--print"]).stdout(writer).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty());
}

#[test]
fn motions_without_frames_are_told() {
    let folder = Folder::new();
    let told = |words: &[&str]| run(words).unwrap_err();
    let (asf, out) = (data("walk.asf"), folder.text("new.amc"));
    let expected = "walk.asf: there are no frames, and so no motion of bones: --out NAME.asf writes the skeleton alone\n";
    assert_eq!(told(&[&asf, "--out", &out]), expected);
    let expected = "walk.asf: there are no frames, and so nothing to warp\n";
    for warp in [&["--warp", "9"][..], &["--between", "2,5"]] {
        for name in ["new.amc", "new.bvh"] {
            assert_eq!(told(&[&[&*asf, "--out", &folder.text(name)], warp].concat()), expected);
        }
    }
    let told = told(&[&asf, "--out", &folder.text("new.bvh"), "--keyframes", "3"]);
    assert_eq!(told, "walk.asf: there are no frames, and so no keyframes\n");
    assert!(folder.names().is_empty());
}

#[test]
fn options_that_mean_nothing_together_are_refused() {
    let folder = Folder::new();
    let (bvh, amc, asf) = (folder.text("new.bvh"), folder.text("new.amc"), folder.text("new.asf"));
    for (wrong, word) in [
        (&["--out", &bvh, "--warp", "0"][..], "how many frames there are to be, from 1"),
        (&["--out", &bvh, "--warp", "100000001"], "from 1 to 100000000"),
        (&["--out", &bvh, "--warp", "9", "--keyframes", "3"], "--keyframes is about keyframes"),
        (&["--out", &bvh, "--between", "1,5", "--method", "even"], "--method is about keyframes"),
        (&["--out", &bvh, "--warp", "9", "--mode", "euler"], "--mode is about keyframes"),
        (&["--plot", "a.svg", "--warp", "9"], "--plot is about keyframes"),
        (&["--csv", "a.csv", "--warp", "9"], "--csv is about keyframes"),
        (&["--out", &asf, "--warp", "9"], "a skeleton alone cannot be warped"),
        (&["--out", &asf, "--keyframes", "9"], "--keyframes means nothing for a skeleton alone"),
        (&["--out", &amc, "--print"], "cannot be used with"),
        (&["--out", &amc, "--frame", "3"], "cannot be used with"),
        (&["--out", &amc, "--up", "z"], "cannot be used with"),
        (&["--rate", "-5"], "from 0.000001 to 1000000"),
        (&["--rate", "0"], "from 0.000001 to 1000000"),
        (&["--warp", "-3"], "how many frames there are to be, from 1"),
    ] {
        let output = view(&[&[&*data("walk.amc")], wrong].concat());
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && told.contains(word), "{wrong:?}: {told}");
    }
    let told = run(&[&data("dance.bvh"), "--out", &amc, "--rate", "60"]).unwrap_err();
    assert!(told.ends_with("which do not say how fast they are; dance.bvh says it: Frame Time\n"), "{told}");
    for more in [&[][..], &["--warp", "9"]] {
        let told =
            run(&[&[&*data("walk.amc"), &data("dance.bvh"), "--out", &bvh], more].concat()).unwrap_err();
        assert_eq!(told, "--out writes one motion, and there are 2 files\n");
    }
    let told = run(&[&data("walk.amc"), "--out", &bvh, "--between", "100,480"]).unwrap_err();
    assert_eq!(
        told,
        "walk.amc: between frames 100 and 480 there is nothing to warp: the motion has frames 0 to 479\n"
    );
    assert!(folder.names().is_empty());
}
