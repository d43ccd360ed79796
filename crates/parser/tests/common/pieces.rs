//! A text that arrives piece by piece.

use std::io::{self, Read};

/// Gives a text in pieces of the given sizes, over and over; where a size is 0, the system interrupts the call.
pub struct Pieces<'a> {
    text: &'a [u8],
    sizes: std::iter::Cycle<std::slice::Iter<'a, usize>>,
}

impl<'a> Pieces<'a> {
    /// `sizes` must hold another number than 0.
    pub fn new(text: &'a [u8], sizes: &'a [usize]) -> Self {
        Pieces { text, sizes: sizes.iter().cycle() }
    }
}

impl Read for Pieces<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.sizes.next().copied().unwrap_or(1) {
            0 => Err(io::ErrorKind::Interrupted.into()),
            size => {
                let size = size.min(buffer.len());
                self.text.read(&mut buffer[..size])
            }
        }
    }
}
