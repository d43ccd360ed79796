//! How far a run is.

use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use results::Record;

use crate::batch::is_harness_error;

/// A bar where there is a terminal, and a line for each tenth where there is none.
pub struct Progress {
    bar: ProgressBar,
    total: usize,
    done: AtomicUsize,
    /// Submissions without any points.
    without_points: AtomicUsize,
    /// Submissions that could not be marked.
    failures: AtomicUsize,
}

impl Progress {
    /// For `total` submissions, of which `done` are done already.
    pub fn new(total: usize, done: usize) -> Progress {
        let bar = ProgressBar::new(total as u64).with_position(done as u64);
        let template = "{wide_bar} {pos} done, {msg}, {eta} to go";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        let progress = Progress {
            bar,
            total,
            done: AtomicUsize::new(done),
            without_points: AtomicUsize::new(0),
            failures: AtomicUsize::new(0),
        };
        progress.say(done);
        progress
    }

    /// One more is done.
    pub fn done(&self, record: &Record) {
        if is_harness_error(&record.verdict) {
            self.failures.fetch_add(1, Ordering::Relaxed);
        } else if record.points() == Some(0) {
            self.without_points.fetch_add(1, Ordering::Relaxed);
        }
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        self.say(done);
        self.bar.inc(1);
        let tenth = |count: usize| count * 10 / self.total.max(1);
        if self.bar.is_hidden() && tenth(done) > tenth(done - 1) {
            eprintln!("{done} of {} done, {}", self.total, self.bar.message());
        }
    }

    fn say(&self, done: usize) {
        let left = self.total.saturating_sub(done);
        let zero = self.without_points.load(Ordering::Relaxed);
        let mut message = format!("{left} left, {zero} without points");
        match self.failures.load(Ordering::Relaxed) {
            0 => {}
            failures => message += &format!(", {failures} could not be marked"),
        }
        self.bar.set_message(message);
    }

    /// Takes the bar away.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }
}
