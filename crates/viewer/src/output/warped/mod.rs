//! Motions with another number of frames, as files. Rows are made one by one as they are written: any number of frames
//! takes no more memory than the motion that is warped.

mod bones;
mod joints;
mod rows;

use std::io;

pub use bones::{Freed, fitting, write_bones};
pub use joints::write_joints;

/// What is told how many frames are done.
pub type Tick<'a> = dyn FnMut(usize) + 'a;

/// What is told when the motion that is warped does not have the frames of which the warp speaks.
fn another_motion() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, "the warp is one of another motion")
}
