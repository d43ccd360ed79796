//! Films, read again by other readers than wrote them.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::convert::Infallible;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use viewer::draw::canvas::{Canvas, Color};
use viewer::output::film::{self, Format, Frames};

/// What a reader finds in a file.
struct Film {
    /// Every picture, put together from what has changed.
    pictures: Vec<Canvas>,
    /// Numerator and denominator of a second.
    delays: Vec<(u16, u16)>,
    /// Left, top, width and height of what was written of each picture.
    parts: Vec<[usize; 4]>,
    endless: bool,
}

fn put(canvas: &mut Canvas, [left, top, width, _]: [usize; 4], pixels: impl Iterator<Item = Option<Color>>) {
    for (index, color) in pixels.enumerate() {
        if let Some(color) = color {
            let (x, y) = (left + index % width, top + index / width);
            canvas.rectangle((x as i32, y as i32), (1, 1), color, 1.0);
        }
    }
}

fn color(channels: &[u8]) -> Color {
    Color(u32::from_be_bytes([0, channels[0], channels[1], channels[2]]))
}

fn read_gif(path: &Path) -> Film {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    options.check_frame_consistency(true);
    let mut decoder = options.read_info(File::open(path).unwrap()).unwrap();
    let mut shown = Canvas::new(decoder.width().into(), decoder.height().into());
    let mut film = Film { pictures: Vec::new(), delays: Vec::new(), parts: Vec::new(), endless: false };
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!(frame.dispose, gif::DisposalMethod::Keep);
        let part = [frame.left, frame.top, frame.width, frame.height].map(usize::from);
        put(&mut shown, part, frame.buffer.chunks_exact(4).map(|rgba| (rgba[3] > 0).then(|| color(rgba))));
        film.pictures.push(shown.clone());
        film.delays.push((frame.delay, 100));
        film.parts.push(part);
    }
    film.endless = matches!(decoder.repeat(), gif::Repeat::Infinite);
    film
}

fn read_apng(path: &Path) -> Film {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let control = *reader.info().animation_control().unwrap();
    let mut shown = Canvas::new(reader.info().width as usize, reader.info().height as usize);
    let mut film =
        Film { pictures: Vec::new(), delays: Vec::new(), parts: Vec::new(), endless: control.num_plays == 0 };
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    for _ in 0..control.num_frames {
        let info = reader.next_frame(&mut buffer).unwrap();
        let frame = *reader.info().frame_control().unwrap();
        assert_eq!((frame.dispose_op, frame.blend_op), (png::DisposeOp::None, png::BlendOp::Source));
        let part = [frame.x_offset, frame.y_offset, frame.width, frame.height].map(|side| side as usize);
        put(&mut shown, part, buffer[..info.buffer_size()].chunks_exact(3).map(|rgb| Some(color(rgb))));
        film.pictures.push(shown.clone());
        film.delays.push((frame.delay_num, frame.delay_den));
        film.parts.push(part);
    }
    assert!(reader.next_frame(&mut buffer).is_err(), "there are no more pictures than it says");
    film
}

type Read = fn(&Path) -> Film;

const FORMATS: [(Format, Read); 2] = [(Format::Gif, read_gif), (Format::Apng, read_apng)];

/// A soft sky of more colours than a GIF has, and a square that moves to the right.
fn draw(index: usize, canvas: &mut Canvas) -> Result<(), Infallible> {
    let (width, height) = canvas.size();
    for y in 0..height {
        for x in 0..width {
            let (right, down) = (90 * x / width, 120 * y / height);
            let sky = Color(((100 + right) << 16 | (120 + down) << 8 | 230) as u32);
            canvas.rectangle((x as i32, y as i32), (1, 1), sky, 1.0);
        }
    }
    canvas.rectangle((3 * index as i32, height as i32 / 2), (6, 5), Color(0x8A_2B_D8), 1.0);
    Ok(())
}

fn drawn(index: usize, size: (usize, usize)) -> Canvas {
    let mut canvas = Canvas::new(size.0, size.1);
    draw(index, &mut canvas).unwrap();
    canvas
}

/// The mean difference of the channels.
fn difference(a: &Canvas, b: &Canvas) -> f64 {
    assert_eq!(a.size(), b.size());
    let channels = |canvas: &Canvas| -> Vec<u8> {
        canvas.pixels().iter().flat_map(|pixel| Color(*pixel).channels()).collect()
    };
    let (a, b) = (channels(a), channels(b));
    a.iter().zip(&b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
}

fn place(folder: &tempfile::TempDir) -> PathBuf {
    folder.path().join("a film")
}

#[test]
fn every_picture_is_read_as_it_was_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let size = (161, 90);
    for (format, read) in FORMATS {
        let mut told = Vec::new();
        let frames = Frames { count: 30, size, seconds: 1.0 / 30.0 };
        film::write(&place(&folder), format, frames, draw, |count| told.push(count)).unwrap();
        assert_eq!(told, (1..=30).collect::<Vec<_>>());
        let film = read(&place(&folder));
        assert_eq!(film.pictures.len(), 30);
        assert!(film.endless);
        for (index, picture) in film.pictures.iter().enumerate() {
            let difference = difference(picture, &drawn(index, size));
            match format {
                Format::Gif => assert!(difference < 3.0, "{index}: {difference}"),
                Format::Apng => assert_eq!(difference, 0.0, "{index}"),
            }
        }
        let seconds: f64 = film.delays.iter().map(|(part, whole)| f64::from(*part) / f64::from(*whole)).sum();
        assert!((seconds - 1.0).abs() < 1e-9, "{format:?}: {seconds}");
    }
}

#[test]
fn a_soft_sky_stays_soft_in_few_colours() {
    let folder = tempfile::tempdir().unwrap();
    let size = (320, 240);
    let frames = Frames { count: 1, size, seconds: 0.1 };
    film::write(&place(&folder), Format::Gif, frames, draw, |_| ()).unwrap();
    let (film, wanted) = (&read_gif(&place(&folder)).pictures[0], drawn(0, size));
    // Seen from far away: the mean of each 8 x 8 pixels.
    let mean = |canvas: &Canvas, left: usize, top: usize, channel: usize| {
        let pixel = |i: usize| canvas.pixel(left + i % 8, top + i / 8).unwrap().channels()[channel];
        (0..64).map(|i| f64::from(pixel(i))).sum::<f64>() / 64.0
    };
    let mut worst = 0.0f64;
    let mut total = 0.0;
    for (left, top) in (0..1200).map(|i| (i % 40 * 8, i / 40 * 8)) {
        for channel in 0..3 {
            let off = (mean(film, left, top, channel) - mean(&wanted, left, top, channel)).abs();
            worst = worst.max(off);
            total += off / 3600.0;
        }
    }
    assert!(worst < 4.0 && total < 0.6, "{worst} at most, {total} on average");
}

#[test]
fn only_what_has_changed_is_written() {
    let folder = tempfile::tempdir().unwrap();
    for (format, read) in FORMATS {
        let frames = Frames { count: 4, size: (64, 48), seconds: 0.04 };
        // The second picture is like the first, and the third and fourth like each other.
        let twice = |index: usize, canvas: &mut Canvas| draw(index / 2, canvas);
        film::write(&place(&folder), format, frames, twice, |_| ()).unwrap();
        let film = read(&place(&folder));
        assert_eq!(film.parts, [[0, 0, 64, 48], [0, 0, 1, 1], [0, 24, 9, 5], [0, 0, 1, 1]], "{format:?}");
        assert!(film.pictures[0].pixels() == film.pictures[1].pixels());
        assert!(film.pictures[2].pixels() == film.pictures[3].pixels());
        assert!(film.pictures[1].pixels() != film.pictures[2].pixels());
    }
}

#[test]
fn the_smallest_films_and_odd_sizes_are_films() {
    let folder = tempfile::tempdir().unwrap();
    for (format, read) in FORMATS {
        for (count, size) in [(1, (1, 1)), (3, (1, 1)), (2, (1, 7)), (2, (7, 1)), (1, (33, 17)), (0, (5, 5))]
        {
            let frames = Frames { count, size, seconds: 1.0 / 120.0 };
            film::write(&place(&folder), format, frames, draw, |_| ()).unwrap();
            let film = read(&place(&folder));
            assert_eq!(film.pictures.len(), count.max(1), "{format:?} {size:?}");
            for (index, picture) in film.pictures.iter().enumerate() {
                // So few colours are all in the palette.
                assert!(difference(picture, &drawn(index, size)) < 1.0, "{format:?} {size:?} {index}");
            }
        }
    }
}

#[test]
fn an_animated_png_has_the_time_that_the_motion_has() {
    let folder = tempfile::tempdir().unwrap();
    for (seconds, fraction) in [(0.008333, (1, 120)), (1.0 / 24.0, (1, 24)), (0.0, (1, 30))] {
        let frames = Frames { count: 3, size: (8, 8), seconds };
        film::write(&place(&folder), Format::Apng, frames, draw, |_| ()).unwrap();
        assert_eq!(read_apng(&place(&folder)).delays, [fraction; 3]);
    }
}

#[test]
fn a_film_that_fails_leaves_everything_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = place(&folder);
    fs::write(&path, "precious").unwrap();
    let frames = Frames { count: 50, size: (16, 16), seconds: 0.04 };
    let unharmed = |words: &str, wanted: &str| {
        assert!(words.contains(wanted) && words.contains("a film"), "{words}");
        assert_eq!(fs::read(&path).unwrap(), b"precious");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left lying about");
    };
    for (format, _) in FORMATS {
        // 49 is among those that a palette is made from, 48 is not.
        for last in [0, 48, 49] {
            let broken = |index: usize, canvas: &mut Canvas| match index {
                index if index == last => Err(format!("no pose for {index}")),
                index => draw(index, canvas).map_err(|never| match never {}),
            };
            let error = film::write(&path, format, frames, broken, |_| ()).unwrap_err();
            unharmed(&error.to_string(), &format!("picture {last} of"));
            unharmed(&error.to_string(), &format!("no pose for {last}"));
        }
        let other_size = |_: usize, canvas: &mut Canvas| -> Result<(), Infallible> {
            *canvas = Canvas::new(3, 4);
            Ok(())
        };
        let error = film::write(&path, format, frames, other_size, |_| ()).unwrap_err();
        unharmed(&error.to_string(), "it has 3 x 4 pixels, not 16 x 16");
    }
}

#[test]
fn a_folder_that_is_not_there_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nowhere").join("a film.gif");
    let frames = Frames { count: 1, size: (4, 4), seconds: 0.1 };
    let error = film::write(&path, Format::Gif, frames, draw, |_| ()).unwrap_err();
    let words = error.to_string();
    assert!(words.starts_with(&format!("the film cannot be written to {}: ", path.display())), "{words}");
}

#[test]
fn pixels_of_a_gif_that_stay_are_not_written_again() {
    let folder = tempfile::tempdir().unwrap();
    let frames = Frames { count: 3, size: (64, 48), seconds: 0.04 };
    // Two corners change, and with them the part that is written is the whole picture.
    let corners = |index: usize, canvas: &mut Canvas| {
        draw(0, canvas).map(|()| {
            for corner in [(0, 0), (63, 47)] {
                canvas.rectangle(corner, (1, 1), Color(0x40_00_00 * index as u32), 1.0);
            }
        })
    };
    film::write(&place(&folder), Format::Gif, frames, corners, |_| ()).unwrap();
    let mut decoder = gif::DecodeOptions::new().read_info(File::open(place(&folder)).unwrap()).unwrap();
    let mut kept = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!((frame.width, frame.height), (64, 48));
        kept.push(frame.buffer.iter().filter(|index| Some(**index) == frame.transparent).count());
    }
    assert_eq!(kept, [0, 64 * 48 - 2, 64 * 48 - 2]);
}
