//! Pictures, films and contact sheets, from outside.
#![allow(clippy::unwrap_used)]

mod command;

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use command::view;
use skeleton::Representation;
use viewer::edit::ReferenceHand;
use viewer::motion::source::Source;
use viewer::output::picture;
use viewer::view::app::{App, Shown};
use viewer::view::gallery::Gallery;
use viewer::view::screen::Screen;

const SMALL: [&str; 3] = ["--solution", "--size", "160x120"];

/// Runs it with what makes a small picture of the reference, and gives what it says.
fn small(arguments: &[&str]) -> Result<String, String> {
    let output = view(&[&SMALL[..], arguments].concat());
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    match output.status.success() {
        true => Ok(text(output.stdout)),
        false => Err(text(output.stderr)),
    }
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::Builder::new().prefix("with blank ").tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
}

fn pixels(path: &Path) -> ((u32, u32), Vec<u8>) {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    ((info.width, info.height), bytes)
}

fn data(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name).to_str().unwrap().to_owned()
}

#[test]
fn a_gif_plays_at_the_motions_speed_and_says_so() {
    let folder = Folder::new();
    let path = folder.path("run.gif");
    for (speed, seconds) in [("1", 1.0), ("0.5", 2.0)] {
        let said =
            small(&["--gif", path.to_str().unwrap(), "--frames", "100..219", "--speed", speed]).unwrap();
        assert!(said.contains("160 x 120") && said.contains(&format!("{seconds:.2} seconds")), "{said}");
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(File::open(&path).unwrap()).unwrap();
        let mut hundredths = 0;
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            hundredths += u32::from(frame.delay);
            assert!(frame.delay >= 2, "browsers slow it down otherwise");
        }
        assert_eq!(hundredths, (100.0 * seconds) as u32);
    }
}

#[test]
fn a_chosen_step_is_kept_and_a_film_never_has_too_many_pictures() {
    let folder = Folder::new();
    let path = folder.path("run.gif");
    for (range, pictures) in
        [("0..239", "60 pictures"), ("0..239/2", "60 pictures"), ("0..239/40", "6 pictures")]
    {
        let said = small(&["--gif", path.to_str().unwrap(), "--frames", range]).unwrap();
        assert!(said.contains(pictures), "{range}: {said}");
    }
}

#[test]
fn an_apng_is_a_png_with_frames() {
    let folder = Folder::new();
    let path = folder.path("run.apng");
    small(&["--apng", path.to_str().unwrap(), "--frames", "0..11"]).unwrap();
    let reader = png::Decoder::new(BufReader::new(File::open(&path).unwrap())).read_info().unwrap();
    let control = reader.info().animation_control().unwrap();
    assert_eq!((control.num_frames, control.num_plays), (6, 0));
}

#[test]
fn a_sheet_shows_frames_side_by_side() {
    let folder = Folder::new();
    let path = folder.path("sheet.png");
    let said = small(&["--sheet", path.to_str().unwrap(), "--frames", "0..100", "--pictures", "6"]).unwrap();
    assert!(said.contains("6 frames"), "{said}");
    let ((width, height), _) = pixels(&path);
    assert!(width >= 160 && height >= 120 && width * height >= 6 * 160 * 120, "{width} x {height}");
    let said = small(&["--sheet", path.to_str().unwrap(), "--frames", "0..100/50"]).unwrap();
    assert!(said.contains("3 frames"), "{said}");
}

#[test]
fn everything_that_can_be_changed_changes_the_picture() {
    let folder = Folder::new();
    let path = folder.path("picture.png");
    // Large enough for all texts.
    let picture = |arguments: &[&str]| {
        let usual = ["--solution", "--frame", "300", "--size", "800x600", "--png", path.to_str().unwrap()];
        let output = view(&[&usual, arguments].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        pixels(&path)
    };
    let usual = picture(&[]);
    assert!(picture(&[]) == usual, "the same twice");
    for change in [
        &["--camera", "90,10"][..],
        &["--camera", "-120,60,2"],
        &["--lines"],
        &["--hide", "words"],
        &["--hide", "axes,traces"],
        &["--show", "help"],
        &["--scale", "2"],
        &["--joint", "LeftFoot"],
        &["--up", "z"],
    ] {
        assert!(picture(change) != usual, "{change:?}");
    }
}

/// The picture of frame 60 of the dance with its settings changed, as the window shows it.
fn in_the_window(file: &Path, change: impl FnOnce(&mut App)) -> Vec<u8> {
    const SIZE: (usize, usize) = (800, 600);
    let source = Source::new(data("dance.bvh"));
    let loaded = source.read().unwrap();
    let mut app = App::new(loaded.stage, source.title(), loaded.warnings, SIZE);
    app.settings.still = true;
    change(&mut app);
    app.edit(&mut ReferenceHand::default());
    app.go_to(60);
    let mut screen = Screen::new(SIZE);
    screen.update(&mut Gallery::new(vec![app]), |_| Shown::Reference, SIZE);
    picture::save(screen.canvas(), file).unwrap();
    fs::read(file).unwrap()
}

#[test]
fn a_picture_begins_with_as_many_keyframes_as_are_asked_for() {
    let folder = Folder::new();
    let path = folder.path("picture.png");
    for (options, keyframes, representation) in [
        (&["--keyframes", "12"][..], 12, Representation::Quaternion),
        (&["--keyframes", "7", "--mode", "euler"], 7, Representation::Euler),
        (&["--mode", "euler"], 20, Representation::Euler),
    ] {
        let expected = in_the_window(&folder.path("expected.png"), |app| {
            let edit = &mut app.settings.edit;
            (edit.automatic, edit.keyframes, edit.representation) = (true, keyframes, representation);
        });
        // The student's functions are not seen, and not asked: both figures are the reference's.
        for whose in [&["--solution"][..], &[]] {
            let path = path.to_str().unwrap();
            let file = [&*data("dance.bvh"), "--frame", "60", "--size", "800x600", "--png", path];
            let output = view(&[&file, options, whose].concat());
            assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
            assert!(fs::read(path).unwrap() == expected, "{options:?} {whose:?}");
        }
    }
    assert!(in_the_window(&folder.path("expected.png"), |_| ()) != fs::read(&path).unwrap());
}

#[test]
fn films_and_sheets_begin_with_keyframes_too() {
    let folder = Folder::new();
    for (option, name) in [("--gif", "film.gif"), ("--apng", "film.apng"), ("--sheet", "sheet.png")] {
        let path = folder.path(name);
        let made = |keyframes: &[&str]| {
            let wanted = [&*data("dance.bvh"), option, path.to_str().unwrap(), "--frames", "50..56/2"];
            small(&[&wanted, keyframes].concat()).unwrap();
            fs::read(&path).unwrap()
        };
        let [usual, few, more] = [&[][..], &["--keyframes", "5"], &["--keyframes", "9"]].map(made);
        assert!(usual != few && few != more, "{option}");
    }
}

/// Where there are no words in the picture, the terminal tells.
#[test]
fn a_motion_that_is_too_long_for_keyframes_is_told_and_shown_as_it_is() {
    let folder = Folder::new();
    let (file, sheet) = (folder.path("long.bvh"), folder.path("sheet.png"));
    let joints = "JOINT j\n{\nOFFSET 0 1 0\nCHANNELS 0\n}\n".repeat(4000);
    let rows = "0\n".repeat(1500);
    let text = format!(
        "HIERARCHY\nROOT r\n{{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n{joints}}}\nMOTION\nFrames: 1500\nFrame Time: 0.1\n{rows}"
    );
    fs::write(&file, text).unwrap();
    let wanted = [file.to_str().unwrap(), "--keyframes", "20", "--frames", "0..9/9", "--sheet"];
    let output = view(&[&SMALL, &wanted[..], &[sheet.to_str().unwrap()]].concat());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && sheet.is_file(), "{said}");
    assert!(
        said.starts_with("long.bvh: only the original is shown: too long: 1500 frames of 4001 joints"),
        "{said}"
    );
}

#[test]
fn several_motions_stand_side_by_side_at_the_same_time() {
    let folder = Folder::new();
    let both = folder.path("both.png");
    let (run, dance) = (data("running.bvh"), data("dance.bvh"));
    let arguments = ["--hide", "words", "--png", both.to_str().unwrap(), "--frame", "100"];
    small(&[&[run.as_str(), &dance], &arguments[..]].concat()).unwrap();
    let ((width, height), together) = pixels(&both);
    assert_eq!((width, height), (160, 120));
    // 100 frames of the run take as long as 25 of the dance.
    let half = |motion: &str, frame: &str| {
        let output = view(&[
            motion,
            "--solution",
            "--size",
            "80x120",
            "--hide",
            "words",
            "--frame",
            frame,
            "--png",
            both.to_str().unwrap(),
        ]);
        assert!(output.status.success());
        pixels(&both).1
    };
    let (left, right) = (half(&run, "100"), half(&dance, "25"));
    // All but the line between the two, which is drawn over the last column and row of each.
    for y in 0..119 {
        for x in 0..79 {
            let at = |pixels: &[u8], width: usize, x: usize| pixels[3 * (y * width + x)..][..3].to_vec();
            assert_eq!(at(&together, 160, x), at(&left, 80, x), "{x}, {y}");
            assert_eq!(at(&together, 160, 80 + x), at(&right, 80, x), "{x}, {y}");
        }
    }
}

#[test]
fn what_cannot_be_done_is_told_and_nothing_is_written() {
    let folder = Folder::new();
    let (gif, png) = (folder.path("run.gif"), folder.path("run.png"));
    let (gif, png) = (gif.to_str().unwrap(), png.to_str().unwrap());
    let motion = folder.path("dance.bvh");
    fs::copy(data("dance.bvh"), &motion).unwrap();
    let motion = motion.to_str().unwrap();
    for (arguments, expected) in [
        (&["--gif", gif, "--frames", "0..5000"][..], "there is no frame 5000"),
        (&["--gif", gif, "--frames", "30..20"], "write 20..30"),
        (&["--gif", png], "ends in .gif"),
        (&["--gif", motion], "to show dance.bvh: cargo view"),
        (&["--sheet", gif], "ends in .png"),
        (&["--apng", gif], "ends in .png or .apng"),
        (&["--png", png, "--joint", "Nose"], "there is no joint \"Nose\""),
        (&["--png", png, "--gif", gif], "cannot be used with"),
        (&["--png", png, "--frames", "1..2"], "cannot be used with"),
        (&["--gif", gif, "--frame", "1"], "cannot be used with"),
        (&["--png", png, "--camera", "north"], "90,20"),
        (&["--png", png, "--speed", "0"], "0.01 to 100"),
        (&["--png", png, "--hide", "nose"], "goal"),
    ] {
        let said = small(arguments).unwrap_err();
        assert!(said.contains(expected), "{arguments:?}: {said}");
    }
    let left: Vec<_> =
        fs::read_dir(folder.0.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["dance.bvh"]);
}
