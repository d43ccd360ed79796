//! Films as files: a GIF or an animated PNG, written picture by picture.
//!
//! However long a film is, only a few pictures are in memory: the one that is drawn and the one before it, so that
//! only the part that has changed is written. A GIF has one palette for all of its pictures, made from some of them
//! before the first is written; so the same picture may be asked for more than once.

mod apng_file;
mod changed;
mod dither;
mod gif_file;
mod pace;
mod palette;

use std::error;
use std::io;
use std::path::{Path, PathBuf};

pub use pace::{fraction, hundredths};

use parser::printable;

use crate::draw::canvas::Canvas;
use crate::output::beside::write_whole;

/// What kind of file a film becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 255 colours and whole hundredths of a second, but shown everywhere.
    Gif,
    /// Every colour and exact times, in a larger file that fewer programs show. Others show its first picture.
    Apng,
}

/// The pictures of a film, before they are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frames {
    /// How many there are. None counts as one: that of a rest pose.
    pub count: usize,
    /// Width and height in pixels, brought into the range of [`Canvas::new`].
    pub size: (usize, usize),
    /// How long each is shown, in seconds; 1/30 when it is less than a millionth or more than a million, or no number.
    /// A film with too many pictures a second is shown too slowly: see [`Format::every`].
    pub seconds: f64,
}

/// Why a film could not be written. What was there before is still there.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file could not be written.
    #[error("the film cannot be written to {}: {source}", printable(&path.display().to_string()))]
    Write {
        /// The film's file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A picture could not be drawn.
    #[error("picture {index} of {} cannot be drawn: {source}", printable(&path.display().to_string()))]
    Draw {
        /// The film's file.
        path: PathBuf,
        /// Which picture, counted from 0.
        index: usize,
        /// What the one who draws says.
        source: Box<dyn error::Error + Send + Sync>,
    },
}

/// Writes a film that is repeated for ever, in place of any file that is at `path`. What is there is lost only when
/// the whole film has been written.
///
/// `draw` draws the picture with the number that it is given, from 0, over whatever the canvas shows. It may be asked
/// for the same one twice, and in any order. `progress` is told after each picture how many have been written.
///
/// # Errors
///
/// When the file cannot be written, when `draw` gives an error, or a canvas of another size.
pub fn write<E>(
    path: &Path,
    format: Format,
    frames: Frames,
    mut draw: impl FnMut(usize, &mut Canvas) -> Result<(), E>,
    mut progress: impl FnMut(usize),
) -> Result<(), Error>
where
    E: Into<Box<dyn error::Error + Send + Sync>>,
{
    let canvas = Canvas::new(frames.size.0, frames.size.1);
    let frames = Frames { count: frames.count.max(1), size: canvas.size(), ..frames };
    let mut draw = |index: usize, canvas: &mut Canvas| draw(index, canvas).map_err(Into::into);
    let reel = Reel { frames, canvas, draw: &mut draw };
    let written = write_whole(path, |file| match format {
        Format::Gif => gif_file::write(file, reel, &mut progress),
        Format::Apng => apng_file::write(file, reel, &mut progress),
    });
    written.map_err(|failure| match failure {
        Failure::Write(source) => Error::Write { path: path.to_owned(), source },
        Failure::Draw(index, source) => Error::Draw { path: path.to_owned(), index, source },
    })
}

/// What draws the pictures, and what they are drawn on.
struct Reel<'a> {
    frames: Frames,
    canvas: Canvas,
    draw: &'a mut Draw<'a>,
}

type Draw<'a> = dyn FnMut(usize, &mut Canvas) -> Result<(), Box<dyn error::Error + Send + Sync>> + 'a;

impl Reel<'_> {
    /// The pixels of one picture.
    fn picture(&mut self, index: usize) -> Result<&[u32], Failure> {
        (self.draw)(index, &mut self.canvas).map_err(|source| Failure::Draw(index, source))?;
        let (size, (width, height)) = (self.canvas.size(), self.frames.size);
        if size != (width, height) {
            let words = format!("it has {} x {} pixels, not {width} x {height}", size.0, size.1);
            return Err(Failure::Draw(index, words.into()));
        }
        Ok(self.canvas.pixels())
    }
}

/// An [`Error`] that does not yet know the file.
enum Failure {
    Write(io::Error),
    Draw(usize, Box<dyn error::Error + Send + Sync>),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Failure {
        Failure::Write(error)
    }
}

impl From<png::EncodingError> for Failure {
    fn from(error: png::EncodingError) -> Failure {
        Failure::Write(error.into())
    }
}

impl From<gif::EncodingError> for Failure {
    fn from(error: gif::EncodingError) -> Failure {
        Failure::Write(match error {
            gif::EncodingError::Io(error) => error,
            error => io::Error::other(error),
        })
    }
}
