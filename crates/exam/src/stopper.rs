//! Ending a worker from outside.

use std::io;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::process::Received;

/// Ends a [`WorkerProcess`](crate::WorkerProcess) from any thread, once and for all: whoever waits for its answer gets
/// [`Failure::NoAnswer`](crate::Failure::NoAnswer) at once, and so does who asks it later.
#[derive(Clone, Default)]
pub struct Stopper(Arc<Mutex<Held>>);

#[derive(Default)]
struct Held {
    stopped: bool,
    child: Option<Child>,
    /// Wakes the asker, who may wait for a pipe that some other process holds open too.
    asker: Option<Sender<Received>>,
}

/// The ends of the worker's pipes.
pub(crate) struct Pipes {
    pub(crate) stdin: Option<ChildStdin>,
    pub(crate) stdout: Option<ChildStdout>,
    pub(crate) stderr: Option<ChildStderr>,
}

impl Stopper {
    /// Ends the worker. It is gone soon after this returns.
    pub fn stop(&self) {
        let mut held = self.lock();
        held.stopped = true;
        if let Some(child) = &mut held.child {
            // This fails only if the worker has ended by itself.
            let _ = child.kill();
        }
        if let Some(asker) = held.asker.take() {
            let _ = asker.send(Ok(None));
        }
    }

    /// Starts the process, unless it must not be any more.
    pub(crate) fn start(&self, command: &mut Command, asker: Sender<Received>) -> io::Result<Pipes> {
        // As long as this is locked nobody stops what has not been written down yet.
        let mut held = self.lock();
        if held.stopped {
            return Err(stopped());
        }
        let mut child = command.spawn()?;
        let pipes =
            Pipes { stdin: child.stdin.take(), stdout: child.stdout.take(), stderr: child.stderr.take() };
        held.child = Some(child);
        held.asker = Some(asker);
        Ok(pipes)
    }

    /// Ends the process, if it has not ended yet, and says how it did.
    pub(crate) fn end(&self) -> io::Result<ExitStatus> {
        let mut held = self.lock();
        held.asker = None;
        let child = held.child.take();
        let stopped_before = held.stopped;
        drop(held);
        let mut child = child.ok_or_else(|| io::Error::other("it has ended before"))?;
        let _ = child.kill();
        let status = child.wait()?;
        if stopped_before { Err(stopped()) } else { Ok(status) }
    }

    fn lock(&self) -> MutexGuard<'_, Held> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn stopped() -> io::Error {
    io::Error::other("the worker was stopped")
}
