//! What is told of that which does not go over into the other format.

use super::*;

/// The lines below the first one.
fn facts(said: &str) -> Vec<&str> {
    said.lines().skip(1).map(str::trim_start).collect()
}

const WALK_LOST: &str = "lost               the bones' own axes, which angles are dofs, limits and the skeleton's name: joints \
                         have no such thing";

#[test]
fn what_joints_do_not_have_of_bones_is_told() {
    let folder = Folder::new();
    let out = folder.text("new.bvh");
    let rate =
        "frames per second  120, as in most recordings; walk.amc does not say it: --rate where it is another";
    let (said, _) = run(&[&data("walk.amc"), "--out", &out]).unwrap();
    assert_eq!(facts(&said), [rate, WALK_LOST]);
    let (said, _) = run(&[&data("walk.amc"), "--out", &out, "--overwrite", "--warp", "99"]).unwrap();
    assert_eq!(facts(&said), ["warped             from 480 frames", rate, WALK_LOST]);
    let (said, _) = run(&[&data("walk.amc"), "--out", &out, "--overwrite", "--keyframes", "3"]).unwrap();
    assert_eq!(facts(&said)[5..], [rate, WALK_LOST]);
    let (said, _) = run(&[&data("walk.amc"), "--out", &out, "--overwrite", "--rate", "59.94"]).unwrap();
    assert_eq!(facts(&said), ["frames per second  59.94, as --rate says", WALK_LOST]);
    // A skeleton alone is not fast.
    let (said, _) = run(&[&data("walk.asf"), "--out", &out, "--overwrite"]).unwrap();
    assert_eq!(facts(&said), [WALK_LOST]);
}

#[test]
fn of_bones_only_that_is_told_which_they_had() {
    let folder = Folder::new();
    let (asf, out) = (folder.text("plain.asf"), folder.text("new.bvh"));
    let plain = |name: &str, units: &str, bone: &str| {
        format!(
            ":version 1.10\n{name}:units\n{units} angle deg\n:root\n order TX TY TZ RX RY RZ\n axis XYZ\n position 0 0 0\n \
             orientation 0 0 0\n:bonedata\n begin\n id 1\n name a\n direction 0 1 0\n length 5\n{bone} end\n:hierarchy\n \
             begin\n root a\n end\n"
        )
    };
    let usual = (" mass 1\n length 1\n", " axis 0 0 0 XYZ\n dof rx ry rz\n");
    for (name, units, bone, lost) in [
        ("", usual.0, usual.1, ""),
        (":name b\n", usual.0, usual.1, "the skeleton's name"),
        ("", " mass 1\n length 0.45\n", usual.1, "units (length 0.45, mass 1)"),
        ("", usual.0, " axis 0 0 9 XYZ\n dof rx ry rz\n", "the bones' own axes"),
        ("", usual.0, " axis 0 0 0 XYZ\n dof rx rz\n", "which angles are dofs"),
        ("", usual.0, " axis 0 0 0 XYZ\n dof rx ry rz\n limits (0 1) (0 1) (0 1)\n", "limits"),
    ] {
        fs::write(&asf, plain(name, units, bone)).unwrap();
        let (said, complaints) = run(&[&asf, "--out", &out, "--overwrite"]).unwrap();
        let line = format!("lost               {lost}: joints have no such thing");
        let expected: &[&str] = if lost.is_empty() { &[] } else { &[&line] };
        assert!(complaints.is_empty() && facts(&said) == expected, "{said}{complaints}");
    }
    // A joint is added for an end that moves.
    fs::write(&asf, plain("", usual.0, " axis 0 0 0 XYZ\n dof rx ry rz ty\n")).unwrap();
    let (said, _) = run(&[&asf, "--out", &out, "--overwrite"]).unwrap();
    assert_eq!(facts(&said), ["added              1 joint for the end of a bone that moves along: `a_end`"]);
}

/// Joints whose names cannot be those of bones, with a fork, and one whose position is a channel.
const ODD_JOINTS: &str = "\
HIERARCHY
ROOT Hips
{
OFFSET 0 0 0
CHANNELS 3 Xposition Yposition Zposition
JOINT Left Leg
{
OFFSET 0 5 0
CHANNELS 1 Xrotation
JOINT left leg
{
OFFSET 0 5 0
CHANNELS 4 Xposition Yposition Zposition Xrotation
End Site
{
OFFSET 0 1 0
}
}
JOINT #x
{
OFFSET 1 5 0
CHANNELS 2 Xrotation Yrotation
JOINT end
{
OFFSET 1 5 0
CHANNELS 1 Xrotation
}
}
}
}
MOTION
Frames: 2
Frame Time: 0.3
0 0 0 0 0 5 0 0 0 0 0
1 80 60 0 0 5 0 0 0 0 0
";

#[test]
fn what_becomes_of_joints_is_told() {
    let folder = Folder::new();
    let (file, amc, asf) = (folder.text("odd.bvh"), folder.text("new.amc"), folder.text("new.asf"));
    fs::write(&file, ODD_JOINTS).unwrap();
    let changes = [
        "new names          `Hips` is now `root`, `Left Leg` is now `Left_Leg`, `left leg` is now `left_leg_2` and 2 more",
        "added              3 bones without dofs between joints: `Hips_Left_Leg`, `Left_Leg_left_leg` and `Left_Leg_#x`",
        "lost               the position channels of `left leg`, which never change",
    ];
    for more in [&[][..], &["--warp", "5"], &["--positions", "add"], &["--keyframes", "2"]] {
        let (said, _) = run(&[&[&*file, "--out", &amc, "--overwrite"], more].concat()).unwrap();
        assert!(said.ends_with(&format!("  {}\n", changes.join("\n  "))), "{said}");
        assert!(said.contains("(--rate 3.3333333333333335 gives the frame time 0.3 back)\n"), "{said}");
    }
    let (said, _) = run(&[&file, "--out", &asf, "--overwrite"]).unwrap();
    assert_eq!(facts(&said), changes);
    // What names the bones is what the file says.
    let bones = acclaim::read_skeleton_file(&asf).unwrap().skeleton;
    for name in ["Left_Leg", "left_leg_2", "_#x", "_end", "Hips_Left_Leg", "Left_Leg_left_leg", "Left_Leg_#x"]
    {
        assert!(bones.find(name).is_some(), "{name}");
    }
    assert_eq!(bones.len(), 8);
}

#[test]
fn the_book_shows_what_is_told() {
    let folder = Folder::new();
    let (said, _) = run(&[&data("running.bvh"), "--out", &folder.text("run.amc")]).unwrap();
    let said = said.replace(&folder.text(""), "");
    let page = fs::read_to_string(data("../docs/converting.md")).unwrap();
    assert!(page.contains(&format!("```text\n{said}```\n")), "{said}");
}

#[test]
fn where_nothing_is_lost_nothing_is_told() {
    let folder = Folder::new();
    let (amc, bvh) = (folder.text("new.amc"), folder.text("new.bvh"));
    let (said, _) = run(&[&data("walk.amc"), "--out", &amc]).unwrap();
    let (words, rate) = (format!("{amc}: 480 frames, 30 bones"), "--rate 120 when you show it\n");
    assert!(said.starts_with(&words) && said.ends_with(rate) && said.lines().count() == 3, "{said}");
    let (said, _) = run(&[&data("arm.bvh"), "--out", &bvh, "--warp", "9"]).unwrap();
    assert_eq!(facts(&said).len(), 1, "{said}");
}

/// Bones that were reduced are made of joints.
#[test]
fn of_reduced_bones_all_is_told() {
    let folder = Folder::new();
    let (said, _) = run(&[&data("walk.amc"), "--out", &folder.text("new.amc"), "--keyframes", "3"]).unwrap();
    let facts = facts(&said);
    assert_eq!(facts[facts.len() - 2], WALK_LOST);
    assert!(
        facts[facts.len() - 1].starts_with("added              7 bones without dofs between joints: `"),
        "{said}"
    );
}

#[test]
#[cfg(unix)]
fn a_name_that_is_told_neither_commands_the_terminal_nor_fills_it() {
    let folder = Folder::new();
    let file = folder.text("odd.bvh");
    let long = format!("\u{1b}[31m{}", "x".repeat(3000));
    fs::write(&file, ODD_JOINTS.replace("Left Leg", &long)).unwrap();
    let (said, _) = run(&[&file, "--out", &folder.text("new.asf")]).unwrap();
    assert!(!said.contains('\u{1b}') && said.contains("xxx…` and"), "{said}");
    assert!(said.lines().skip(1).all(|line| line.chars().count() < 300), "{said}");
}
