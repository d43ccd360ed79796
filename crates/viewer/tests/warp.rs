//! The command `cargo view --warp`, from outside.
#![allow(clippy::unwrap_used)]

mod command;

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::Output;

use command::view;

fn data(name: &str) -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    path.to_str().unwrap().to_owned()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn assert_done(output: &Output) {
    assert!(output.status.success(), "{}", text(&output.stderr));
}

#[test]
fn keyframes_and_frames_that_are_not_there_are_told() {
    let walk = data("walk.amc");
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("a.png").to_str().unwrap().to_owned();
    for arguments in [&["--between", "400,900"][..], &["--between", "400,900", "--png", &png]] {
        let refused = view(&[&[walk.as_str()], arguments].concat());
        assert!(!refused.status.success());
        assert!(
            text(&refused.stderr).contains("the motion has frames 0 to 479"),
            "{}",
            text(&refused.stderr)
        );
    }
    let refused = view(&[&walk, "--warp", "700", "--png", &png, "--frame", "700"]);
    assert!(text(&refused.stderr).contains("counted from 0 to 699"), "{}", text(&refused.stderr));
    for count in ["0", "100000001", "-5", "x"] {
        assert!(!view(&[&walk, "--print", "--warp", count]).status.success(), "{count}");
    }
}

fn pixels(path: &Path) -> (usize, Vec<u8>) {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width as usize, bytes)
}

#[test]
fn a_picture_shows_both_and_counts_the_frames_of_the_longer_one() {
    let folder = tempfile::tempdir().unwrap();
    let dance = data("dance.bvh");
    let halves = |frame: &str| {
        let path = folder.path().join("both.png");
        let size = ["--size", "800x300", "--hide", "words,traces", "--solution", "--lines"];
        let wanted = ["--warp", "282", "--frame", frame, "--png", path.to_str().unwrap()];
        assert_done(&view(&[&[dance.as_str()][..], &size, &wanted].concat()));
        let (width, bytes) = pixels(&path);
        let half = |left: bool| {
            let rows = bytes.chunks_exact(3 * width);
            // Without the border between them.
            let columns = if left { 0..width / 2 - 1 } else { width / 2..width - 1 };
            rows.flat_map(|row| row[3 * columns.start..3 * columns.end].to_vec()).collect::<Vec<u8>>()
        };
        [half(true), half(false)]
    };
    let [begin, same] = halves("0");
    assert!(begin == same, "both begin with the same frame");
    let [end, middle] = halves("140");
    assert!(end != middle);
    let [waits, late] = halves("200");
    assert!(waits == end && late != middle, "the original waits, the other one goes on");
    let [waits, last] = halves("281");
    assert!(waits == end && last == end, "both end with the same frame");
}

#[test]
fn a_film_runs_until_the_longer_one_ends() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.png");
    let dance = data("dance.bvh");
    for (count, frames) in [("282", 282), ("70", 141)] {
        let film = ["--size", "64x48", "--hide", "words", "--solution", "--lines"];
        let wanted = ["--warp", count, "--apng", path.to_str().unwrap()];
        assert_done(&view(&[&[dance.as_str()][..], &film, &wanted].concat()));
        let reader = png::Decoder::new(BufReader::new(File::open(&path).unwrap())).read_info().unwrap();
        let pictures = reader.info().animation_control.unwrap().num_frames;
        // Programs show so many a second, and the dance has as many.
        assert_eq!(pictures, frames, "{count}");
    }
}

#[test]
fn a_film_of_too_many_pictures_is_refused_and_one_picture_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (dance, gif, png) = (data("dance.bvh"), path("a.gif"), path("a.png"));
    let refused = view(&[&dance, "--warp", "100000000", "--gif", &gif]);
    assert!(text(&refused.stderr).contains("choose frames with --frames"), "{}", text(&refused.stderr));
    assert!(!Path::new(&gif).exists());
    let size = ["--size", "300x200", "--solution"];
    assert_done(&view(&[&[dance.as_str(), "--warp", "100000000", "--png", &png][..], &size].concat()));
    let sheet = path("sheet.png");
    assert_done(&view(&[&[dance.as_str(), "--warp", "100000000", "--sheet", &sheet][..], &size].concat()));
}
