//! Texts too long to be kept.

use std::io::{self, Read};

/// A text of which parts are repeated many times and never all there.
pub fn repeated<'a>(parts: &'a [(&'a str, u64)]) -> impl Read + 'a {
    struct Repeated<'a> {
        parts: std::slice::Iter<'a, (&'a str, u64)>,
        part: io::Take<Cycle<'a>>,
    }
    struct Cycle<'a>(&'a [u8], usize);

    impl Read for Cycle<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            for byte in buffer.iter_mut() {
                *byte = self.0[self.1];
                self.1 = (self.1 + 1) % self.0.len();
            }
            Ok(buffer.len())
        }
    }

    impl Read for Repeated<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            loop {
                match self.part.read(buffer)? {
                    0 => match self.parts.next() {
                        Some((text, times)) => {
                            self.part = Cycle(text.as_bytes(), 0).take(text.len() as u64 * times);
                        }
                        None => return Ok(0),
                    },
                    read => return Ok(read),
                }
            }
        }
    }

    Repeated { parts: parts.iter(), part: Cycle(b" ", 0).take(0) }
}
