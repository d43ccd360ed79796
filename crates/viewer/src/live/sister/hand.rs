//! A student's functions as the hand that edits, and what becomes known of them on the way.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex};

use exam::keyframes::Reduction;
use exam::{Failure, Subject};
use skeleton::{LocalPose, Representation};

use super::ask::{self, Wrong};
use super::hands::Event;
use crate::edit::{Curves, Hand, Maker, Makers, Progress};
use crate::live::lock;
use crate::live::package::Package;
use crate::live::student::News;
use crate::live::version::Version;
use crate::motion::stage::Stage;

/// One version's functions on one motion. What is not their part is done by another hand.
pub(super) struct StudentHand<S> {
    package: Package,
    motion: usize,
    subject: S,
    rest: Box<dyn Hand>,
    report: Report,
}

impl<S: Subject> StudentHand<S> {
    pub(super) fn new(
        package: Package,
        motion: usize,
        subject: S,
        rest: Box<dyn Hand>,
        report: Report,
    ) -> Self {
        StudentHand { package, motion, subject, rest, report }
    }

    /// Puts questions whose answers are shown, and reports what comes of it.
    fn ask<T>(&mut self, put: impl FnOnce(&mut S, &Version) -> Result<T, Wrong>) -> Result<T, Failure> {
        self.report.version.hush(false);
        let answered = put(&mut self.subject, &self.report.version);
        match answered {
            Ok(answer) => {
                self.report.send(Event::Answered(self.motion));
                Ok(answer)
            }
            Err(Wrong { failure, trouble }) => {
                let trouble = Arc::new(trouble);
                self.report.send(Event::Trouble(self.motion, Arc::clone(&trouble)));
                self.report.tell_once(News::Trouble(trouble));
                Err(failure)
            }
        }
    }
}

impl<S: Subject + Send> Hand for StudentHand<S> {
    fn reduce(
        &mut self,
        stage: &Stage,
        representation: Representation,
        counts: &[usize],
        progress: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        match self.package {
            // How far they are is known to nobody.
            Package::Keyframes => self.ask(|subject, _| ask::reduce(subject, stage, representation, counts)),
            _ => self.rest.reduce(stage, representation, counts, progress),
        }
    }

    fn between(
        &mut self,
        stage: &Stage,
        representation: Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        match self.package {
            Package::Interpolation => self.ask(|subject, version| {
                let hush = || version.hush(true);
                ask::between(subject, stage, representation, (start, end), progress, hush)
            }),
            _ => self.rest.between(stage, representation, start, end, progress),
        }
    }

    fn makers(&self) -> Makers {
        match self.package {
            Package::Interpolation => Makers { between: Maker::Student, ..self.rest.makers() },
            Package::Keyframes => Makers { keyframes: Maker::Student, ..self.rest.makers() },
            _ => self.rest.makers(),
        }
    }

    fn curves(&mut self, stage: &Stage, progress: Progress) -> Option<Curves> {
        self.rest.curves(stage, progress)
    }
}

/// Where what is found out about a version goes: to the window, and to the terminal.
#[derive(Clone)]
pub(super) struct Report {
    number: u64,
    version: Version,
    events: Sender<(u64, Event)>,
    tell: Arc<Mutex<dyn FnMut(News) + Send>>,
    /// A trouble was told.
    told: Arc<AtomicBool>,
}

impl Report {
    pub(super) fn new(
        number: u64,
        version: Version,
        events: Sender<(u64, Event)>,
        tell: Arc<Mutex<dyn FnMut(News) + Send>>,
    ) -> Report {
        Report { number, version, events, tell, told: Arc::default() }
    }

    pub(super) fn version(&self) -> &Version {
        &self.version
    }

    pub(super) fn send(&self, event: Event) {
        // This fails when the viewer has gone.
        let _ = self.events.send((self.number, event));
    }

    pub(super) fn tell(&self, news: News) {
        let mut tell = lock(&self.tell);
        if !self.version.is_abandoned() {
            tell(news);
        }
    }

    /// The same, but not twice for one version: what fails once fails for every edit.
    fn tell_once(&self, news: News) {
        if !self.version.is_abandoned() && !self.told.swap(true, Ordering::SeqCst) {
            self.tell(news);
        }
    }
}
