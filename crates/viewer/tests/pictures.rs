//! The pictures in the book are those that the viewer makes now.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use viewer::draw::canvas::{Canvas, Color};
use viewer::motion::source::Source;
use viewer::output::pictures::{PICTURES, Studio};

/// A pixel counts as different when a channel differs by more than this: sines differ a little between machines.
const SHADES: u8 = 24;

/// The share of the pixels that may be different.
const SHARE: f64 = 0.0005;

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..")
}

fn studio() -> Studio {
    let read = |name: &str| parser::bvh::read_file(workspace().join("data").join(name)).unwrap().motion;
    let data = |name: &str| workspace().join("data").join(name);
    let walk = Source { skeleton: Some(data("walk.asf")), ..Source::new(data("walk.amc")) };
    Studio::new(read("running.bvh"), read("dance.bvh"), walk.read().unwrap().stage)
}

fn folder() -> PathBuf {
    workspace().join("docs").join("pictures")
}

fn read(path: &Path) -> Vec<[u8; 3]> {
    let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

fn different(canvas: &Canvas, pixels: &[[u8; 3]]) -> f64 {
    if canvas.pixels().len() != pixels.len() {
        return 1.0;
    }
    let differs = |(now, then): (&u32, &[u8; 3])| {
        Color(*now).channels().iter().zip(then).any(|(a, b)| a.abs_diff(*b) > SHADES)
    };
    canvas.pixels().iter().zip(pixels).filter(|pair| differs(*pair)).count() as f64 / pixels.len() as f64
}

#[test]
fn every_picture_is_up_to_date() {
    let mut studio = studio();
    for picture in PICTURES {
        let now = picture.draw(&mut studio);
        let share = different(&now, &read(&folder().join(format!("{}.png", picture.name))));
        assert!(share <= SHARE, "{}: {share} of the picture has changed: run `cargo pictures`", picture.name);
    }
}

#[test]
fn there_are_no_other_pictures() {
    let files =
        std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    // Those that are no PNG are looked at in tests/experiment.rs.
    let files = files.filter(|name| name.ends_with(".png"));
    let expected: BTreeSet<String> = PICTURES.iter().map(|picture| format!("{}.png", picture.name)).collect();
    assert_eq!(files.collect::<BTreeSet<_>>(), expected);
}

#[test]
fn the_comparison_sees_a_change() {
    let pixels = read(&folder().join("solved.png"));
    let mut canvas = PICTURES.iter().find(|picture| picture.name == "solved").unwrap().draw(&mut studio());
    canvas.rectangle((100, 300), (30, 12), Color::BLACK, 0.3);
    assert!(different(&canvas, &pixels) > SHARE);
}
