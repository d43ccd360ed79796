//! From a program that can be asked to a verdict.

use std::io::{self, PipeReader, Read};
use std::thread;
use std::time::{Duration, Instant};

use exam::{Subject, WorkerProcess};
use grading::{Exam, PartReport, PartState, WholeReport, after_time_out, grade_part, grade_whole_motion};
use results::{Picture, Verdict};
use sandbox::{Confinement, Limits, Sandbox};

use crate::compile::Worker;
use crate::picture::Portrait;
use crate::verdict;

/// Asks the questions of one exam.
#[derive(Debug)]
pub struct Examiner<'a> {
    /// The questions and the right answers.
    pub exam: &'a Exam,
    /// The pose that is drawn, where the exercise is about poses.
    pub portrait: Option<&'a Portrait>,
    /// Where the workers run.
    pub sandbox: &'a Sandbox,
    /// What a worker may use.
    pub limits: Limits,
    /// How long a check may take. After the first that takes longer, each has less ([`after_time_out`]).
    pub patience: Duration,
}

/// What all the questions brought to light.
#[derive(Debug)]
pub struct Marked {
    /// The parts in the rubric's order.
    pub parts: Vec<PartReport>,
    /// The parts together.
    pub whole: WholeReport,
    /// One pose, if there was an answer.
    pub picture: Option<Picture>,
}

impl Examiner<'_> {
    /// Asks `worker` everything, and gives the verdict and the time that it took.
    ///
    /// # Errors
    ///
    /// When this machine fails, not the worker.
    pub fn verdict(&self, slot: u32, worker: &Worker) -> io::Result<(Verdict, Duration)> {
        let start = Instant::now();
        let marked = self.mark(slot, worker, io::sink());
        let verdict = match marked {
            Ok(marked) => verdict::of(&marked),
            Err(Trouble::Jail(what)) => Verdict::HarnessError { what },
            Err(Trouble::Io(error)) => return Err(error),
        };
        Ok((verdict, start.elapsed()))
    }

    /// Asks `worker` everything. What it prints goes to `sink`.
    ///
    /// # Errors
    ///
    /// When the worker could not be started.
    pub fn mark(
        &self,
        slot: u32,
        worker: &Worker,
        sink: impl io::Write + Send + 'static,
    ) -> Result<Marked, Trouble> {
        let confinement = Confinement {
            read: worker.reads.clone(),
            folder: None,
            environment: worker.environment.clone(),
            limits: self.limits,
        };
        let mut command = self.sandbox.command(slot, &confinement, &worker.program)?;
        let (errors, to_errors) = io::pipe()?;
        command.stderr(to_errors);
        let errors = thread::spawn(move || ends(errors));
        let mut subject = WorkerProcess::new(command).printing_to(sink);
        let marked = self.ask(&mut subject);
        // With the subject goes the last hold on the pipe.
        drop(subject);
        let errors = errors.join().unwrap_or_default();
        match self.sandbox.setup_failure(&errors) {
            Some(what) => Err(Trouble::Jail(what)),
            None => Ok(marked),
        }
    }

    fn ask(&self, subject: &mut dyn Subject) -> Marked {
        let mut patience = self.patience;
        let mut parts = Vec::new();
        for paper in &self.exam.parts {
            let report = grade_part(subject, paper, patience);
            if timed_out(&report) {
                patience = after_time_out(self.patience);
            }
            parts.push(report);
        }
        let whole = grade_whole_motion(subject, &self.exam.whole_motion, patience);
        // Who has not answered for the whole motion will not answer for one frame of it.
        let picture = if whole.frames > 0 { self.picture(subject, patience) } else { None };
        Marked { parts, whole, picture }
    }

    fn picture(&self, subject: &mut dyn Subject, patience: Duration) -> Option<Picture> {
        let portrait = self.portrait?;
        portrait.picture(&subject.ask(&portrait.question, patience).ok()?)
    }
}

/// Why a worker could not be asked.
#[derive(Debug, thiserror::Error)]
pub enum Trouble {
    /// The sandbox could not be set up.
    #[error("the sandbox could not be set up: {0}")]
    Jail(String),
    /// The system refused something.
    #[error(transparent)]
    Io(#[from] io::Error),
}

fn timed_out(report: &PartReport) -> bool {
    let is_time = |state: &grading::CheckState| {
        matches!(state, grading::CheckState::Failed { failure: exam::Failure::TimedOut { .. }, .. })
    };
    report.state == PartState::TimedOut || report.checks.iter().any(|check| is_time(&check.state))
}

/// Reads to the end, so that nobody waits for a full pipe, and keeps what came first and what came last.
fn ends(mut pipe: PipeReader) -> Vec<u8> {
    const KEPT: usize = 32 * 1024;
    let mut kept = Vec::new();
    let mut last = Vec::new();
    let mut chunk = [0; 16 * 1024];
    while let Ok(count) = pipe.read(&mut chunk) {
        if count == 0 {
            break;
        }
        let room = KEPT.saturating_sub(kept.len()).min(count);
        kept.extend_from_slice(&chunk[..room]);
        last.extend_from_slice(&chunk[room..count]);
        last.drain(..last.len().saturating_sub(KEPT));
    }
    kept.extend(last);
    kept
}
