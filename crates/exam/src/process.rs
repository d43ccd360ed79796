//! Asking functions in a process of their own.

use std::io::{self, Write};
use std::process::{Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::stopper::Stopper;
use crate::stream::ReplyStream;
use crate::wire::{self, Reply};
use crate::{Answer, Failure, Question, Subject};

/// A process that answers by [`worker::serve`](crate::worker::serve). What it prints goes on to this process's
/// standard output, up to a limit; its errors go straight to the terminal, or where the command sends them, or through
/// [`errors_to`](WorkerProcess::errors_to).
///
/// When it crashes or takes too long it is ended, and the next question starts a new one.
pub struct WorkerProcess {
    command: Command,
    printed: Printed,
    errors: Option<Printed>,
    stopper: Stopper,
    running: Option<Running>,
}

impl WorkerProcess {
    /// A worker that `command` starts when the first question is asked.
    pub fn new(command: Command) -> Self {
        WorkerProcess {
            command,
            printed: Printed::to(io::stdout()),
            errors: None,
            stopper: Stopper::default(),
            running: None,
        }
    }

    /// The same worker, whose print goes to `sink` instead.
    pub fn printing_to(self, sink: impl Write + Send + 'static) -> Self {
        WorkerProcess { printed: Printed::to(sink), ..self }
    }

    /// The same worker, whose standard error goes to `sink`, up to the limit that holds for print.
    pub fn errors_to(mut self, sink: impl Write + Send + 'static) -> Self {
        self.command.stderr(Stdio::piped());
        self.errors = Some(Printed::to(sink));
        self
    }

    /// The same worker, which hands on `bytes` of print, and as many of errors, from every process, instead of 1 MiB.
    /// To be called when it is settled where these go.
    pub fn print_limit(mut self, bytes: usize) -> Self {
        self.printed.limit = bytes;
        if let Some(errors) = &mut self.errors {
            errors.limit = bytes;
        }
        self
    }

    /// What ends this worker from another thread.
    pub fn stopper(&self) -> Stopper {
        self.stopper.clone()
    }
}

impl Subject for WorkerProcess {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        let (mut answers, failure) = self.ask_all(&[question], limit);
        match failure {
            Some(failure) => Err(failure),
            None => answers.pop().ok_or_else(|| Failure::NoAnswer { why: "nothing came back".to_owned() }),
        }
    }

    /// All questions are on their way before the first answer is waited for: waking each other for every question would
    /// take longer than answering.
    fn ask_all(&mut self, questions: &[&Question], limit: Duration) -> (Vec<Answer>, Option<Failure>) {
        let start = Instant::now();
        let mut answers = Vec::new();
        let mut running = match self.send(questions) {
            Ok(running) => running,
            Err(error) => return (answers, Some(no_answer(error))),
        };
        for (index, _) in questions.iter().enumerate() {
            match running.receive(limit.saturating_sub(start.elapsed())) {
                Ok(answer) => answers.push(answer),
                Err(failure) => {
                    // After the last question's panic the worker goes on; otherwise it is busy with questions that
                    // nobody waits for, or in an unknown state.
                    if matches!(failure, Failure::Panicked { .. }) && index + 1 == questions.len() {
                        self.running = Some(running);
                    }
                    let failure = match failure {
                        Failure::TimedOut { .. } => Failure::TimedOut { limit },
                        other => other,
                    };
                    return (answers, Some(failure));
                }
            }
        }
        self.running = Some(running);
        (answers, None)
    }

    fn restart(&mut self) {
        self.running = None;
    }
}

impl WorkerProcess {
    /// Puts the questions to the worker that runs, or to a new one.
    fn send(&mut self, questions: &[&Question]) -> io::Result<Running> {
        let running = match self.running.take() {
            Some(running) => running,
            None => self.start()?,
        };
        for question in questions {
            running.send(wire::to_bytes(question)?, question.answer_limit());
        }
        Ok(running)
    }

    fn start(&mut self) -> io::Result<Running> {
        Running::start(&mut self.command, self.printed.clone(), self.errors.clone(), self.stopper.clone())
    }
}

/// Bytes that the functions may print.
const PRINT_LIMIT: usize = 1 << 20;

/// Bytes that a panic's message and place may add to a reply.
const PANIC_LIMIT: usize = 64 * 1024;

pub(crate) type Received = io::Result<Option<Reply>>;

struct Running {
    /// Holds the process.
    stopper: Stopper,
    to_write: Sender<Vec<u8>>,
    limits: Sender<usize>,
    replies: Receiver<Received>,
}

impl Running {
    fn start(
        command: &mut Command,
        printed: Printed,
        errors: Option<Printed>,
        stopper: Stopper,
    ) -> io::Result<Running> {
        let (to_asker, replies) = mpsc::channel();
        let pipes = stopper.start(command.stdin(Stdio::piped()).stdout(Stdio::piped()), to_asker.clone())?;
        let (Some(mut stdin), Some(stdout)) = (pipes.stdin, pipes.stdout) else {
            return Err(io::Error::other("the worker has no pipes"));
        };
        if let (Some(mut stderr), Some(mut errors)) = (pipes.stderr, errors) {
            // What cannot be written any more must not keep the worker from writing.
            let copy = move || {
                io::copy(&mut stderr, &mut errors).or_else(|_| io::copy(&mut stderr, &mut io::sink()))
            };
            thread::Builder::new().name("errors of worker".into()).spawn(copy)?;
        }
        let marker = wire::new_marker();

        // Writing and reading happen on threads of their own: whatever the worker does or leaves undone, the asker
        // waits for as long as it wants and no longer.
        let (to_write, messages) = mpsc::channel::<Vec<u8>>();
        to_write.send(marker.to_vec()).map_err(io::Error::other)?;
        thread::Builder::new().name("to worker".into()).spawn(move || {
            while let Ok(mut message) = messages.recv() {
                messages.try_iter().for_each(|next| message.extend(next));
                if stdin.write_all(&message).and_then(|()| stdin.flush()).is_err() {
                    break;
                }
            }
        })?;

        let (limits, wanted) = mpsc::channel::<usize>();
        thread::Builder::new().name("from worker".into()).spawn(move || {
            let mut stream = ReplyStream::new(stdout, printed, marker);
            while let Ok(limit) = wanted.recv() {
                let reply = stream.next_reply(limit);
                let last = !matches!(reply, Ok(Some(_)));
                if to_asker.send(reply).is_err() || last {
                    break;
                }
            }
        })?;
        Ok(Running { stopper, to_write, limits, replies })
    }

    fn send(&self, message: Vec<u8>, answer_limit: usize) {
        // When a thread is gone, so is the worker: waiting for the reply tells how it ended.
        let _ = self.limits.send(answer_limit.saturating_add(PANIC_LIMIT));
        let _ = self.to_write.send(message);
    }

    fn receive(&mut self, limit: Duration) -> Result<Answer, Failure> {
        match self.replies.recv_timeout(limit) {
            Ok(Ok(Some(reply))) => reply.into(),
            Ok(Ok(None)) | Err(RecvTimeoutError::Disconnected) => Err(self.how_it_ended()),
            Ok(Err(error)) => Err(Failure::Unreadable { why: error.to_string() }),
            Err(RecvTimeoutError::Timeout) => Err(Failure::TimedOut { limit }),
        }
    }

    /// The worker closed its output. If it did so by ending, ending it again does not change how it ended.
    fn how_it_ended(&mut self) -> Failure {
        match self.stopper.end() {
            Ok(status) => Failure::Crashed { how: status.to_string() },
            Err(error) => no_answer(error),
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // This fails only if the worker has ended by itself, or was stopped.
        let _ = self.stopper.end();
    }
}

fn no_answer(error: io::Error) -> Failure {
    Failure::NoAnswer { why: error.to_string() }
}

/// What the student's code prints, on its way to the terminal.
#[derive(Clone)]
struct Printed {
    sink: Arc<Mutex<dyn Write + Send>>,
    count: usize,
    limit: usize,
}

impl Printed {
    fn to(sink: impl Write + Send + 'static) -> Self {
        Printed { sink: Arc::new(Mutex::new(sink)), count: 0, limit: PRINT_LIMIT }
    }
}

impl Write for Printed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut sink = self.sink.lock().unwrap_or_else(PoisonError::into_inner);
        let before = self.count;
        self.count = before.saturating_add(bytes.len());
        let allowed = self.limit.saturating_sub(before).min(bytes.len());
        sink.write_all(&bytes[..allowed])?;
        if before <= self.limit && self.count > self.limit {
            writeln!(sink, "\n(your code prints very much: the rest is left out)")?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.lock().unwrap_or_else(PoisonError::into_inner).flush()
    }
}
