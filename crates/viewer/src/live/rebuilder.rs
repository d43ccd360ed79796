//! Beginning with a new version, from whatever thread notices the save.

use std::io;
use std::sync::{Arc, Mutex};

use super::lock;
use super::version::Version;

/// Has the student's file built again. Can be handed to the thread that notices a save: no picture need come in
/// between.
#[derive(Clone)]
pub struct Rebuilder(Arc<Mutex<Last>>);

struct Last {
    version: Version,
    begin: Begin,
    start: Start,
    trouble: Option<io::Error>,
    /// The viewer has gone.
    ended: bool,
}

/// What was known of the version before is of no use any more. Gives the number of the new one.
pub(super) type Begin = Box<dyn FnMut() -> u64 + Send>;

/// Starts the thread of a version, whose number comes first; the version before comes last.
pub(super) type Start = Box<dyn FnMut(u64, Version, Version) -> io::Result<()> + Send>;

impl Rebuilder {
    pub(super) fn new(begin: Begin, start: Start) -> Rebuilder {
        let last = Last { version: Version::default(), begin, start, trouble: None, ended: false };
        Rebuilder(Arc::new(Mutex::new(last)))
    }

    /// The file was saved: the version before is abandoned, whatever it is doing, and the new one built and asked. Does
    /// not wait for either. Gives whether a build begins: not when the viewer has gone.
    pub fn rebuild(&self) -> bool {
        let mut last = lock(&self.0);
        if last.ended {
            return false;
        }
        let before = std::mem::take(&mut last.version);
        before.abandon();
        let number = (last.begin)();
        let version = last.version.clone();
        last.trouble = (last.start)(number, version, before).err();
        true
    }

    /// Why the last version has no thread, if so.
    pub(super) fn take_trouble(&self) -> Option<io::Error> {
        lock(&self.0).trouble.take()
    }

    /// Ends the last version.
    pub(super) fn end(&self) {
        let mut last = lock(&self.0);
        last.ended = true;
        last.version.end();
        (last.begin)();
    }
}
