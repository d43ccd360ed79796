//! Telling a worker's replies from what the student's code prints.

use std::io::{self, Read, Write};

use crate::wire::{self, Marker, Reply};

/// Reads replies from a worker's output, and hands everything else on.
pub(crate) struct ReplyStream<R, W> {
    source: R,
    printed: W,
    marker: Marker,
    /// Read, but not yet known to be print or reply.
    pending: Vec<u8>,
}

impl<R: Read, W: Write> ReplyStream<R, W> {
    pub(crate) fn new(source: R, printed: W, marker: Marker) -> Self {
        ReplyStream { source, printed, marker, pending: Vec::new() }
    }

    /// The next reply of at most `limit` bytes; `None` at the end of the output.
    pub(crate) fn next_reply(&mut self, limit: usize) -> io::Result<Option<Reply>> {
        if !self.skip_to_marker()? {
            return Ok(None);
        }
        let Some(length) = self.take(4)? else { return Ok(None) };
        let length = length.iter().rev().fold(0, |length, byte| length << 8 | usize::from(*byte));
        if length > limit {
            return Err(io::Error::other(format!("the answer is too long: {length} bytes, at most {limit}")));
        }
        let Some(message) = self.take(length)? else { return Ok(None) };
        wire::from_bytes(&message).map(Some)
    }

    /// Hands on what was printed before the next marker, and takes the marker. False at the end of the output.
    fn skip_to_marker(&mut self) -> io::Result<bool> {
        loop {
            let marker = &self.marker[..];
            if let Some(at) = self.pending.windows(marker.len()).position(|window| window == marker) {
                self.hand_on(at)?;
                self.pending.drain(..marker_len());
                return Ok(true);
            }
            // The last bytes may be the beginning of a marker. Text never is: a marker begins with 0.
            let start = self.pending.len().saturating_sub(marker_len() - 1);
            let maybe = self.pending[start..].iter().position(|&byte| byte == marker[0]);
            self.hand_on(maybe.map_or(self.pending.len(), |at| start + at))?;
            if !self.fill()? {
                self.hand_on(self.pending.len())?;
                return Ok(false);
            }
        }
    }

    fn take(&mut self, count: usize) -> io::Result<Option<Vec<u8>>> {
        while self.pending.len() < count {
            if !self.fill()? {
                return Ok(None);
            }
        }
        Ok(Some(self.pending.drain(..count).collect()))
    }

    fn fill(&mut self) -> io::Result<bool> {
        let mut chunk = [0; 16 * 1024];
        let count = self.source.read(&mut chunk)?;
        self.pending.extend_from_slice(&chunk[..count]);
        Ok(count > 0)
    }

    fn hand_on(&mut self, count: usize) -> io::Result<()> {
        if count > 0 {
            // A closed terminal must not cost the answers.
            let _ = self.printed.write_all(&self.pending[..count]).and_then(|()| self.printed.flush());
            self.pending.drain(..count);
        }
        Ok(())
    }
}

const fn marker_len() -> usize {
    size_of::<Marker>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives a few bytes at a time, so that markers and lengths are cut in every place.
    struct Trickle<'a>(&'a [u8], usize);

    impl Read for Trickle<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let count = self.1.min(self.0.len()).min(buffer.len());
            buffer[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }

    fn reply(message: &str) -> Reply {
        Reply::Panicked { message: message.into(), location: None }
    }

    #[test]
    fn replies_and_print_come_apart_wherever_they_are_cut() {
        let marker = wire::new_marker();
        let mut bytes = b"hello \0 there".to_vec();
        wire::write_reply(&mut bytes, &marker, &reply("one")).unwrap();
        wire::write_reply(&mut bytes, &marker, &reply("two")).unwrap();
        bytes.extend_from_slice(b"between");
        wire::write_reply(&mut bytes, &marker, &reply("three")).unwrap();
        bytes.extend_from_slice(b"last \0");
        for step in 1..40 {
            let mut printed = Vec::new();
            let mut stream = ReplyStream::new(Trickle(&bytes, step), &mut printed, marker);
            for message in ["one", "two", "three"] {
                assert_eq!(stream.next_reply(100).unwrap(), Some(reply(message)), "step {step}");
            }
            assert_eq!(stream.next_reply(100).unwrap(), None);
            assert_eq!(printed, b"hello \0 therebetweenlast \0", "step {step}");
        }
    }

    #[test]
    fn a_reply_that_is_too_long_is_refused() {
        let marker = wire::new_marker();
        let mut bytes = marker.to_vec();
        bytes.extend_from_slice(&u32::MAX.to_le_bytes());
        let error = ReplyStream::new(&bytes[..], io::sink(), marker).next_reply(100).unwrap_err();
        assert!(error.to_string().contains("too long"), "{error}");
    }

    #[test]
    fn a_reply_that_breaks_off_is_the_end() {
        let marker = wire::new_marker();
        let mut bytes = Vec::new();
        wire::write_reply(&mut bytes, &marker, &reply("one")).unwrap();
        bytes.pop();
        assert_eq!(ReplyStream::new(&bytes[..], io::sink(), marker).next_reply(100).unwrap(), None);
    }
}
