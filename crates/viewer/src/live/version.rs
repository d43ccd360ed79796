//! One saved state of the student's file.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use super::lock;

/// Bytes that the functions may print about one question.
const PRINT_LIMIT: usize = 256 * 1024;

/// One saved state of the student's file, from when it is built until the next one is saved.
///
/// It is known here whether anybody is still interested in it, and in what its functions print.
#[derive(Clone, Default)]
pub struct Version(Arc<Inner>);

#[derive(Default)]
struct Inner {
    abandoned: AtomicBool,
    last_acts: Mutex<Vec<LastAct>>,
    /// What is printed now is not for the user.
    hushed: AtomicBool,
    /// Something was printed.
    printed: AtomicBool,
    /// Bytes that were printed about this question and reached the user.
    heard: AtomicUsize,
}

type LastAct = Box<dyn FnOnce() + Send>;

impl Version {
    /// Whether a newer one is there, or the viewer has gone.
    pub fn is_abandoned(&self) -> bool {
        self.0.abandoned.load(Ordering::SeqCst)
    }

    /// Does `act` as soon as nobody is interested any more: at once if that is so already. It should be quick.
    pub fn when_abandoned(&self, act: impl FnOnce() + Send + 'static) {
        let mut acts = lock(&self.0.last_acts);
        if self.is_abandoned() {
            drop(acts);
            act();
        } else {
            acts.push(Box::new(act));
        }
    }

    /// A way to `sink` for what the functions print, as long as it is not very much. It is closed while they are asked
    /// for what is not on show.
    pub fn voice<W: Write + Send + 'static>(&self, sink: W) -> impl Write + Send + use<W> {
        Voice { version: self.clone(), sink }
    }

    /// Nobody is interested any more. What is to be done then is still to be done, by [`end`](Version::end).
    pub(super) fn abandon(&self) {
        self.0.abandoned.store(true, Ordering::SeqCst);
    }

    /// Does what is to be done when nobody is interested any more.
    pub(super) fn end(&self) {
        self.abandon();
        let acts = std::mem::take(&mut *lock(&self.0.last_acts));
        acts.into_iter().for_each(|act| act());
    }

    /// Closes or opens the way for print.
    pub(crate) fn hush(&self, hushed: bool) {
        self.0.hushed.store(hushed, Ordering::SeqCst);
        self.0.heard.store(0, Ordering::SeqCst);
    }

    /// Whether the functions have printed anything.
    pub(super) fn is_talkative(&self) -> bool {
        self.0.printed.load(Ordering::SeqCst)
    }
}

struct Voice<W> {
    version: Version,
    sink: W,
}

impl<W: Write> Write for Voice<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.version.0.printed.store(true, Ordering::SeqCst);
        if self.version.0.hushed.load(Ordering::SeqCst) || self.version.is_abandoned() {
            return Ok(bytes.len());
        }
        let before = self.version.0.heard.fetch_add(bytes.len(), Ordering::SeqCst);
        let allowed = PRINT_LIMIT.saturating_sub(before).min(bytes.len());
        self.sink.write_all(&bytes[..allowed])?;
        if before <= PRINT_LIMIT && before + bytes.len() > PRINT_LIMIT {
            writeln!(self.sink, "\n(your code prints very much: the rest is left out)")?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicUsize;

    use super::*;

    #[test]
    fn last_acts_are_done_once_and_at_once_when_it_is_too_late() {
        let count = Arc::new(AtomicUsize::new(0));
        let act = || {
            let count = Arc::clone(&count);
            move || {
                count.fetch_add(1, Ordering::SeqCst);
            }
        };
        let version = Version::default();
        version.when_abandoned(act());
        assert_eq!(count.load(Ordering::SeqCst), 0);
        version.end();
        version.end();
        assert_eq!(count.load(Ordering::SeqCst), 1);
        version.when_abandoned(act());
        assert_eq!(count.load(Ordering::SeqCst), 2);
    }

    #[test]
    fn what_is_printed_reaches_the_sink_unless_it_is_hushed() {
        let version = Version::default();
        let (mut reader, writer) = io::pipe().unwrap();
        let mut voice = version.voice(writer);
        assert!(!version.is_talkative());
        for (hushed, text) in [(false, "shown "), (true, "hushed "), (false, "again")] {
            version.hush(hushed);
            voice.write_all(text.as_bytes()).unwrap();
        }
        assert!(version.is_talkative());
        drop(voice);
        assert_eq!(io::read_to_string(&mut reader).unwrap(), "shown again");
    }

    #[test]
    fn a_flood_is_cut_off_once_for_every_question() {
        #[derive(Clone, Default)]
        struct Sink(Arc<Mutex<Vec<u8>>>);
        impl Write for Sink {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                self.0.lock().unwrap().write(bytes)
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let (version, sink) = (Version::default(), Sink::default());
        let mut voice = version.voice(sink.clone());
        for _ in 0..2 {
            version.hush(false);
            (0..2000).for_each(|_| voice.write_all(&[b'.'; 1000]).unwrap());
        }
        let text = String::from_utf8(sink.0.lock().unwrap().clone()).unwrap();
        assert_eq!(text.matches("the rest is left out").count(), 2);
        assert_eq!(text.matches('.').count(), 2 * PRINT_LIMIT);
    }
}
