//! Functions that are asked here and now: for pictures, which wait for them.

use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex};

use exam::Subject;

use super::hand::{Report, StudentHand};
use super::hands::Event;
use crate::edit::Hand;
use crate::live::package::Package;
use crate::live::version::Version;
use crate::live::worker::Trouble;

/// The functions of one version as a hand, and what is wrong with them.
pub struct Now<S> {
    hand: StudentHand<S>,
    events: Receiver<(u64, Event)>,
}

impl<S: Subject + Send> Now<S> {
    /// Asks `subject`, which runs the functions of `version`. What is not the student's part of an edit is done by `rest`.
    pub fn new(package: Package, version: &Version, subject: S, rest: Box<dyn Hand>) -> Now<S> {
        let (sender, events) = mpsc::channel();
        // Nothing is told while they are asked: whoever asks does so afterwards.
        let report = Report::new(1, version.clone(), sender, Arc::new(Mutex::new(|_| {})));
        Now { hand: StudentHand::new(package, 0, subject, rest, report), events }
    }

    /// What edits.
    pub fn hand(&mut self) -> &mut dyn Hand {
        &mut self.hand
    }

    /// What was wrong with the first answer, since this was last asked, that could not be used.
    pub fn trouble(&mut self) -> Option<Arc<Trouble>> {
        let all: Vec<_> = self.events.try_iter().collect();
        all.into_iter().find_map(|(_, event)| match event {
            Event::Trouble(_, trouble) => Some(trouble),
            _ => None,
        })
    }
}
