//! The command `cargo view`, from outside.
#![allow(clippy::unwrap_used)]

mod command;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use std::sync::Arc;

use command::view;
use skeleton::PositionChannels;
use viewer::camera::Spot;
use viewer::draw::color_of;
use viewer::live::mover::Mover;
use viewer::live::package::Package;
use viewer::live::student::{self, Status};
use viewer::live::version::Version;
use viewer::live::worker::{self, Trouble};
use viewer::motion::stage::Stage;
use viewer::scene::Tint;
use viewer::view::answers::Recorded;
use viewer::view::app::{App, Shown};

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn golden(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join("golden").join(name)
}

/// Compares with the golden file, or writes it when FK_LAB_BLESS is set.
fn assert_golden(name: &str, text: &str) {
    if std::env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(golden(name), text).unwrap();
    }
    let expected = fs::read_to_string(golden(name)).unwrap().replace("\r\n", "\n");
    assert!(text == expected, "{name} differs; if that is right, set FK_LAB_BLESS=1. Now it is:\n{text}");
}

fn read_png(path: &Path) -> (u32, u32, Vec<[u8; 3]>) {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.height, bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect())
}

mod print {
    use super::*;

    #[test]
    fn the_default_file_is_printed_as_a_tree_with_a_summary() {
        let output = view(&["--print"]);
        assert!(output.status.success());
        assert_eq!(stderr(&output), "");
        assert_golden("running.txt", &stdout(&output));
    }

    #[test]
    #[cfg(unix)]
    fn no_file_name_can_command_the_terminal() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a\u{1b}[31m\u{202e}b.bvh");
        fs::copy(golden("odd.bvh"), &path).unwrap();
        let text = stdout(&view(&[path.to_str().unwrap(), "--print"]));
        assert!(text.starts_with('a') && !text.contains(['\u{1b}', '\u{202e}']), "{text:?}");
    }

    #[test]
    fn odd_files_are_printed_with_their_oddities() {
        let output = view(&[golden("odd.bvh").to_str().unwrap(), "--print"]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert_golden("odd.txt", &stdout(&output));
    }
}

mod png_file {
    use super::*;

    #[test]
    fn a_picture_has_its_size_and_purple_squares_where_the_joints_are() {
        let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
        let path = folder.path().join("picture.png");
        let arguments =
            ["--solution", "--lines", "--png", path.to_str().unwrap(), "--frame", "300", "--size", "800x600"];
        let output = view(&arguments);
        assert!(output.status.success(), "{}", stderr(&output));
        let (width, height, pixels) = read_png(&path);
        assert_eq!((width, height), (800, 600));

        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/running.bvh");
        let motion = parser::bvh::read_file(data).unwrap().motion;
        let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
        let mut app = App::new(stage.clone(), "running.bvh".into(), Vec::new(), (800, 600));
        app.go_to(300);
        let view = app.scene(Shown::Reference, (800, 600)).camera.view((800, 600));
        let purple = color_of(Tint::Joint).channels();
        let mut hidden = 0;
        for transform in stage.reference(300).transforms() {
            let spot = view.project(transform.position).unwrap();
            let center = pixels[spot.y as usize * 800 + spot.x as usize];
            hidden += usize::from(center != purple);
        }
        assert!(hidden <= 6, "{hidden} joints are hidden or not where they should be");
    }

    /// Whatever the student's file holds: the squares are where its functions put the joints, or the message tells
    /// why there are none.
    #[test]
    fn the_students_functions_make_a_picture_too_whatever_their_state() {
        const FRAME: usize = 300;
        // Too small for a legend, which would show purple too.
        const SIZE: (usize, usize) = (700, 440);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        let arguments = ["--png", path.to_str().unwrap(), "--frame", "300", "--size", "700x440"];
        let output = view(&arguments);
        assert!(output.status.success(), "{}", stderr(&output));
        let (width, height, pixels) = read_png(&path);
        assert_eq!((width as usize, height as usize), SIZE);

        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let motion = parser::bvh::read_file(workspace.join("data/running.bvh")).unwrap().motion;
        let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
        let answer = worker::compile(Package::Fk, &workspace, &Version::default()).and_then(|program| {
            student::ask(Mover::Fk, &mut program.worker(), &stage, FRAME..FRAME + 1).map_err(Trouble::from)
        });
        let purple = color_of(Tint::Joint).channels();
        let posed = match &answer {
            Ok(answer) => &answer[0],
            Err(trouble) => {
                let told = format!("{}: the picture shows only the goal", trouble.headline);
                assert!(stderr(&output).contains(&told), "{}", stderr(&output));
                assert!(!pixels.contains(&purple), "there are joints that nobody knows");
                return;
            }
        };
        assert!(!stderr(&output).contains("only the goal"), "{}", stderr(&output));
        let mut app = App::new(stage, "running.bvh".into(), Vec::new(), SIZE);
        app.go_to(FRAME);
        let recorded =
            Recorded { poses: [(FRAME, posed.clone())].into(), ..Recorded::new(Mover::Fk, Status::Answered) };
        let view = app.scene(Shown::Student(&recorded), SIZE).camera.view(SIZE);
        let spots = posed.pose.transforms().iter().filter_map(|joint| view.project(joint.position));
        let inside = spots
            .filter(|spot| (0.0..SIZE.0 as f32).contains(&spot.x) && (0.0..SIZE.1 as f32).contains(&spot.y));
        let (seen, hidden): (Vec<Spot>, Vec<Spot>) =
            inside.partition(|spot| pixels[spot.y as usize * SIZE.0 + spot.x as usize] == purple);
        // In unfinished work many joints are close together, and hide each other.
        assert!(seen.len() >= hidden.len(), "{} joints are seen and {} are not", seen.len(), hidden.len());
        assert_eq!(seen.is_empty(), !pixels.contains(&purple));
    }

    #[test]
    fn position_channels_can_be_added_to_the_offsets() {
        let folder = tempfile::tempdir().unwrap();
        let draw = |name: &str, positions: &str| {
            let path = folder.path().join(name);
            let file = golden("odd.bvh");
            let arguments = [file.to_str().unwrap(), "--solution", "--png", path.to_str().unwrap()];
            let output = view(&[&arguments[..], &["--positions", positions]].concat());
            assert!(output.status.success(), "{}", stderr(&output));
            read_png(&path).2
        };
        assert_ne!(draw("a.png", "replace"), draw("b.png", "add"));
    }

    #[test]
    fn a_frame_that_does_not_exist_is_an_error_for_the_picture_and_for_the_window() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        for mode in [&["--png", path.to_str().unwrap()][..], &[]] {
            let output = view(&[&["--solution", "--frame", "1377"], mode].concat());
            assert_eq!(output.status.code(), Some(1));
            let expected =
                "running.bvh: there is no frame 1377: the motion's frames are counted from 0 to 1376\n";
            assert_eq!(stderr(&output), expected);
        }
        assert!(!path.exists());
    }

    #[test]
    fn a_picture_that_cannot_be_written_is_an_error_that_names_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("none").join("picture.png");
        let output = view(&["--solution", "--png", path.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(1));
        let expected = format!("the picture cannot be written to {}: ", path.display());
        assert!(stderr(&output).starts_with(&expected), "{}", stderr(&output));
    }

    #[test]
    fn a_motion_is_never_written_over() {
        let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
        let motion = fs::read(golden("odd.bvh")).unwrap();
        let refused = |target: &str, file: &str, reason: &str| {
            let (target, file) = (folder.path().join(target), folder.path().join(file));
            fs::write(&file, &motion).unwrap();
            let arguments = ["--solution", file.to_str().unwrap(), "--png", target.to_str().unwrap()];
            let output = view(&arguments);
            assert_eq!(output.status.code(), Some(1));
            assert!(stderr(&output).contains(reason), "{}", stderr(&output));
            assert_eq!(fs::read(&file).unwrap(), motion);
            assert_eq!(target.exists(), target.canonicalize().ok() == file.canonicalize().ok());
        };
        refused("dance.bvh", "dance.bvh", "to show dance.bvh: cargo view");
        refused("new.bvh", "dance.bvh", "--png names the picture to write");
        refused("picture.jpg", "dance.bvh", "ends in .png");
        refused("picture", "dance.bvh", "ends in .png");
        refused("odd.png", "odd.png", "is the motion");
    }

    #[test]
    fn a_wrong_target_is_told_before_anything_is_read() {
        for (target, shown) in
            [("data/dance.BVH", "data/dance.BVH"), ("my data/dance.BVH", "\"my data/dance.BVH\"")]
        {
            let output = view(&["no such file.bvh", "--png", target]);
            assert_eq!(output.status.code(), Some(1));
            let expected = format!(
                "--png names the picture to write; to show dance.BVH: cargo view {shown} --png picture.png\n"
            );
            assert_eq!(stderr(&output), expected);
        }
    }
}

mod errors {
    use super::*;

    #[test]
    fn a_missing_file_is_named() {
        let output = view(&["no such file.bvh", "--print"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(stderr(&output).contains("no such file.bvh"), "{}", stderr(&output));
        assert_eq!(stdout(&output), "");
    }

    #[test]
    fn a_bad_file_is_told_with_path_line_and_column() {
        let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
        let path = folder.path().join("bad file.bvh");
        fs::write(&path, "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 zero 0\n}\n").unwrap();
        for mode in [&["--print"][..], &["--solution", "--png", "never.png"], &[]] {
            let output = view(&[&[path.to_str().unwrap()], mode].concat());
            assert_eq!(output.status.code(), Some(1));
            assert!(stderr(&output).contains("bad file.bvh:4:12"), "{}", stderr(&output));
        }
    }

    #[test]
    #[cfg(all(unix, not(target_os = "macos")))]
    fn without_a_display_the_message_says_why_and_names_the_picture() {
        let output = view(&["--solution"]);
        assert_eq!(output.status.code(), Some(1));
        let text = stderr(&output);
        for part in ["No window", "--png", "--frame", "DISPLAY is not set", "libX11"] {
            assert!(text.contains(part), "{part} is missing in: {text}");
        }
        assert!(stdout(&output).contains("Hips"), "the skeleton is printed all the same");
    }

    #[test]
    fn an_exercise_on_bones_wants_bones_and_says_how_to_get_them() {
        let folder = tempfile::tempdir().unwrap();
        let picture = folder.path().join("never.png");
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/dance.bvh");
        let file = file.to_str().unwrap();
        for mode in [&["--png", picture.to_str().unwrap()][..], &["--solution"], &[]] {
            let output = view(&[&["--exercise", "acclaim", file], mode].concat());
            assert_eq!(output.status.code(), Some(1));
            let told = stderr(&output);
            assert!(told.starts_with("dance.bvh holds joints, and this exercise moves bones"), "{told}");
            assert!(
                told.contains("data/walk.asf") && told.contains(&format!("cargo view {file} --out ")),
                "{told}"
            );
        }
        assert!(!picture.exists());
        // What is asked of no functions needs no bones.
        assert!(view(&["--exercise", "acclaim", file, "--print"]).status.success());
    }

    #[test]
    fn an_unknown_option_is_a_usage_error() {
        for wrong in [&["--sizes"][..], &["--size", "12"], &["--frame", "-1"], &["--positions", "no"]] {
            assert_eq!(view(wrong).status.code(), Some(2));
        }
    }

    #[test]
    fn help_names_every_key() {
        let output = view(&["--help"]);
        assert!(output.status.success());
        for (_, help) in viewer::window::keys::help() {
            assert!(stdout(&output).contains(help));
        }
    }
}

mod odd_files {
    use super::*;

    /// Each is drawn, and the picture shows a figure.
    #[test]
    fn odd_skeletons_make_pictures() {
        let folder = tempfile::tempdir().unwrap();
        let joint = |indent: usize, name: &str, inner: &str| {
            format!(
                "{:indent$}JOINT {name}\n{{\nOFFSET 0 1 0.1\nCHANNELS 3 Zrotation Xrotation Yrotation\n{inner}}}\n",
                ""
            )
        };
        let many = (0..172)
            .fold("End Site\n{\nOFFSET 0 1 0\n}\n".to_owned(), |inner, i| joint(1, &format!("j{i}"), &inner));
        let tip = "End Site\n{\nOFFSET 0 1 0\n}\n".to_owned();
        let files = [
            ("two joints", joint(1, "tip", ""), 1),
            ("173 joints", many, 2),
            ("no frames", tip.clone(), 0),
            ("one point", String::new(), 1),
            ("one frame", tip, 1),
        ];
        for (name, inner, frames) in files {
            let head = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
            let channels = 3 + 3 * (1 + inner.matches("JOINT").count());
            let row = vec!["1"; channels].join(" ") + "\n";
            let text =
                format!("{head}{inner}}}\nMOTION\nFrames: {frames}\nFrame Time: 0.1\n{}", row.repeat(frames));
            let path = folder.path().join(format!("{name}.bvh"));
            fs::write(&path, text).unwrap();
            let picture = folder.path().join(format!("{name}.png"));
            let arguments = [path.to_str().unwrap(), "--solution", "--png", picture.to_str().unwrap()];
            let output = view(&arguments);
            assert!(output.status.success(), "{name}: {}", stderr(&output));
            let purple = color_of(Tint::Joint).channels();
            // The legend's swatch alone has about a hundred.
            let count = read_png(&picture).2.iter().filter(|pixel| **pixel == purple).count();
            assert!(count > 110, "{name}: {count} purple pixels");
        }
    }
}
