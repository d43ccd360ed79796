//! Marking many submissions side by side.

use std::collections::HashMap;
use std::collections::hash_map::Entry as MapEntry;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use results::{Record, Verdict};
use submissions::similar::{self, Fingerprint};
use submissions::{Batch, Entry, Loaded, Rejection, Source};

use crate::compile::{Compiled, Compiler};
use crate::journal::{Done, Journal};
use crate::log::Log;
use crate::mark::Examiner;
use crate::{Error, digest, orphans};

/// How the sources of a batch become verdicts. A trait, so that tests can leave the compiler out.
pub trait Marking: Sync {
    /// Compiles and asks one source in job `slot`, in a scratch folder of that job.
    fn mark(&self, slot: u32, folder: &Path, source: &str) -> Outcome;
}

/// A verdict and what it took.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What came of it.
    pub verdict: Verdict,
    /// Processor time of the compiler and the linker.
    pub compile: Duration,
    /// How long the program was asked.
    pub run: Duration,
}

/// The way that counts: compile, ask, compare.
#[derive(Debug)]
pub struct CompileAndAsk<'a> {
    /// For compiling.
    pub compiler: Compiler<'a>,
    /// For asking.
    pub examiner: Examiner<'a>,
}

impl Marking for CompileAndAsk<'_> {
    fn mark(&self, slot: u32, folder: &Path, source: &str) -> Outcome {
        let (compiled, compile) = match self.compiler.compile(slot, folder, source) {
            Ok(both) => both,
            Err(error) => return harness_error(&error),
        };
        let worker = match compiled {
            Compiled::Worker(worker) => worker,
            Compiled::Not(verdict) => return Outcome { verdict, compile, run: Duration::ZERO },
        };
        match self.examiner.verdict(slot, &worker) {
            Ok((verdict, run)) => Outcome { verdict, compile, run },
            Err(error) => harness_error(&error),
        }
    }
}

fn harness_error(error: &std::io::Error) -> Outcome {
    let verdict = Verdict::HarnessError { what: error.to_string() };
    Outcome { verdict, compile: Duration::ZERO, run: Duration::ZERO }
}

/// Everything that the jobs share.
pub struct Jobs<'a> {
    /// Where the submissions come from.
    pub batch: &'a Batch,
    /// How they are marked.
    pub marking: &'a dyn Marking,
    /// Named in every result.
    pub sandbox: &'a str,
    /// Where scratch folders are made.
    pub scratch: PathBuf,
    /// Where results go.
    pub journal: &'a Journal,
    /// Where it is said what was done when.
    pub log: &'a Log,
    /// Whether to stop after the submissions that are being marked.
    pub stop: &'a AtomicBool,
    /// Told of each submission that is done.
    pub progress: &'a (dyn Fn(&Record) + Sync),
}

/// What stands where an equal source is looked for.
enum Known {
    /// It is being marked; these wait for the verdict.
    InWork(Vec<Waiting>),
    /// It is in the journal, under this id.
    Done(String),
}

/// A submission that will get the verdict of another.
struct Waiting {
    record: Record,
    fingerprint: Fingerprint,
}

impl Jobs<'_> {
    /// Marks `entries`, `jobs` at a time. True when all are done, false when it was stopped.
    ///
    /// # Errors
    ///
    /// When results cannot be written. The other jobs end then, too.
    pub fn run(&self, entries: &[&Entry], jobs: u32) -> Result<bool, Error> {
        let next = AtomicUsize::new(0);
        let known = Mutex::new(self.known_sources()?);
        let failed = AtomicBool::new(false);
        let work = |slot: u32| {
            while !self.stop.load(Ordering::SeqCst) && !failed.load(Ordering::SeqCst) {
                let Some(entry) = entries.get(next.fetch_add(1, Ordering::SeqCst)) else { break };
                if let Err(error) = self.mark(slot, entry, &known) {
                    failed.store(true, Ordering::SeqCst);
                    return Err(error);
                }
            }
            Ok(())
        };
        let work = &work;
        thread::scope(|scope| {
            let threads: Vec<_> = (0..jobs).map(|slot| scope.spawn(move || work(slot))).collect();
            let panicked = || Error::Usage("a job panicked: this is a fault of the harness".to_owned());
            threads.into_iter().try_for_each(|thread| thread.join().map_err(|_| panicked())?)
        })?;
        Ok(next.load(Ordering::SeqCst) >= entries.len() && !self.stop.load(Ordering::SeqCst))
    }

    /// What the journal already knows, for a run that goes on.
    fn known_sources(&self) -> Result<HashMap<String, Known>, Error> {
        let mut known = HashMap::new();
        for done in self.journal.entries()? {
            let done = done?;
            if let (Some(source), false) = (done.source, is_harness_error(&done.record.verdict)) {
                known.insert(source, Known::Done(done.record.id));
            }
        }
        Ok(known)
    }

    fn mark(&self, slot: u32, entry: &Entry, known: &Mutex<HashMap<String, Known>>) -> Result<(), Error> {
        let source = match self.batch.load(entry) {
            Loaded::Source(source) => source,
            Loaded::Rejected(rejection) => {
                let record = rejected(entry, rejection, self.sandbox);
                return self.write(Done {
                    record,
                    source: None,
                    fingerprint: None,
                    compile_ms: 0,
                    run_ms: 0,
                });
            }
        };
        let text = digest::of(source.text.as_bytes());
        let fingerprint = similar::fingerprint(&source.text);
        let Source { sha256, remarks, text: program } = source;
        // Filled in when the verdict is known.
        let record = record(entry, Some(sha256), remarks, self.sandbox, Verdict::Missing);
        let waiting = Waiting { record, fingerprint };

        let Some(waiting) = self.queue_or_reuse(waiting, &text, known)? else { return Ok(()) };
        let id = waiting.record.id.clone();
        let folder = self.scratch.join(slot.to_string());
        let outcome = self.marking.mark(slot, &folder, &program);
        orphans::bury();
        let milliseconds = |time: Duration| u64::try_from(time.as_millis()).unwrap_or(u64::MAX);
        let times = (milliseconds(outcome.compile), milliseconds(outcome.run));
        self.finish(waiting, &text, &outcome.verdict, times)?;
        let state = if is_harness_error(&outcome.verdict) {
            lock(known).remove(&text)
        } else {
            lock(known).insert(text.clone(), Known::Done(id))
        };
        let Some(Known::InWork(queue)) = state else { return Ok(()) };
        queue.into_iter().try_for_each(|equal| self.finish(equal, &text, &outcome.verdict, (0, 0)))
    }

    /// Gives the submission back when it is the first with this text.
    fn queue_or_reuse(
        &self,
        waiting: Waiting,
        text: &str,
        known: &Mutex<HashMap<String, Known>>,
    ) -> Result<Option<Waiting>, Error> {
        let equal = match lock(known).entry(text.to_owned()) {
            MapEntry::Occupied(mut entry) => match entry.get_mut() {
                Known::InWork(queue) => {
                    queue.push(waiting);
                    return Ok(None);
                }
                Known::Done(id) => id.clone(),
            },
            MapEntry::Vacant(entry) => {
                entry.insert(Known::InWork(Vec::new()));
                return Ok(Some(waiting));
            }
        };
        match self.journal.get(&equal)? {
            Some(done) => self.finish(waiting, text, &done.record.verdict, (0, 0)).map(|()| None),
            None => Ok(Some(waiting)),
        }
    }

    fn finish(
        &self,
        waiting: Waiting,
        text: &str,
        verdict: &Verdict,
        (compile_ms, run_ms): (u64, u64),
    ) -> Result<(), Error> {
        let Waiting { mut record, fingerprint } = waiting;
        record.verdict = verdict.clone();
        self.write(Done {
            record,
            source: Some(text.to_owned()),
            fingerprint: Some(fingerprint),
            compile_ms,
            run_ms,
        })
    }

    fn write(&self, done: Done) -> Result<(), Error> {
        self.journal.append(&done)?;
        let Done { record, compile_ms, run_ms, .. } = &done;
        let points =
            record.points().map_or_else(|| "no points".to_owned(), |points| format!("{points} points"));
        let verdict = record.verdict.code();
        self.log.say(&format!(
            "{}: {verdict}, {points}; compiled in {compile_ms} ms, asked for {run_ms} ms",
            record.id
        ))?;
        (self.progress)(record);
        Ok(())
    }
}

/// Whether it should be tried again when the run goes on.
pub fn is_harness_error(verdict: &Verdict) -> bool {
    matches!(verdict, Verdict::HarnessError { .. })
}

/// What is written down about a submission that cannot be marked.
pub(crate) fn rejected(entry: &Entry, rejection: Rejection, sandbox: &str) -> Record {
    let verdict = Verdict::Rejected { code: rejection.code.to_owned(), why: rejection.why };
    record(entry, rejection.sha256, Vec::new(), sandbox, verdict)
}

/// What is written down about a submission.
pub(crate) fn record(
    entry: &Entry,
    sha256: Option<String>,
    remarks: Vec<String>,
    sandbox: &str,
    verdict: Verdict,
) -> Record {
    let lms = match &entry.lms {
        submissions::Lms::None | submissions::Lms::CanvasAnonymous { .. } => results::Lms::None,
        submissions::Lms::Canvas { user_id } => results::Lms::Canvas { user_id: user_id.clone() },
        submissions::Lms::Moodle { participant } => {
            results::Lms::Moodle { participant_id: participant.clone() }
        }
    };
    Record {
        id: entry.id.clone(),
        student: results::Student { number: entry.student.number.clone(), name: entry.student.name.clone() },
        lms,
        file: entry.file.clone(),
        sha256,
        marked_late: entry.marked_late,
        remarks,
        sandbox: sandbox.to_owned(),
        verdict,
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
