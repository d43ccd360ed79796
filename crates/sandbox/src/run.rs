//! Running a confined program to its end, with an eye on the clock and on what it prints.

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Child, ExitStatus, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError, SyncSender};
use std::thread;
use std::time::{Duration, Instant};

use crate::{Confinement, Limits, Sandbox};

/// How a confined program ended.
#[derive(Clone, Debug)]
pub struct Finished {
    /// How the process ended; `None` where that cannot be found out, because this process ignores the end of its
    /// children (SIGCHLD).
    pub status: Option<ExitStatus>,
    /// What it wrote on standard output, at most [`Limits::output`] together with `stderr`.
    pub stdout: Vec<u8>,
    /// What it wrote on standard error.
    pub stderr: Vec<u8>,
    /// The limit that ended it, as far as that can be told.
    pub limit: Option<Limit>,
    /// Processor time, that of setting up the jail included. Zero where the system does not tell, and less than the
    /// truth for a program that was ended from outside.
    pub cpu: Duration,
}

/// A limit that ended a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Processor time.
    Cpu,
    /// Time by the clock.
    Wall,
    /// Memory: it was refused more and gave up, or the system ended it.
    Memory,
    /// It wrote too much.
    Output,
}

impl Sandbox {
    /// Runs `program` with `arguments`, confined, to its end. It reads nothing. See [`Sandbox::command`] for `slot`.
    ///
    /// # Errors
    ///
    /// When the jail could not be set up or the program not be started: this is never the program's own doing.
    pub fn run(
        &self,
        slot: u32,
        confinement: &Confinement,
        program: &Path,
        arguments: &[OsString],
    ) -> io::Result<Finished> {
        let mut command = self.command(slot, confinement, program)?;
        command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn()?;
        let limits = &confinement.limits;
        let start = Instant::now();
        let deadline = start.checked_add(limits.wall).unwrap_or(start + FAR);
        let output = match read(&mut child, deadline, limits.output) {
            Ok(output) => output,
            Err(error) => {
                kill(&mut child)?;
                return Err(error);
            }
        };
        let (end, limit) = match output.limit {
            Some(limit) => (kill(&mut child)?, Some(limit)),
            None => wait(&mut child, deadline)?,
        };
        if let Some(reason) =
            [&output.stderr, &output.excess].into_iter().find_map(|text| self.setup_failure(text))
        {
            return Err(io::Error::other(reason));
        }
        let limit = limit.or_else(|| {
            let for_memory = || end.was_killed() && self.0.resources.killed_for_memory(slot, limits);
            if end.is_out_of_time(limits) {
                Some(Limit::Cpu)
            } else {
                (end.gave_up(&output.stderr) || for_memory()).then_some(Limit::Memory)
            }
        });
        let Output { stdout, stderr, .. } = output;
        Ok(Finished { status: end.status, stdout, stderr, limit, cpu: end.cpu })
    }
}

/// Later than any run ends.
const FAR: Duration = Duration::from_secs(1 << 30);

#[derive(Default)]
struct Output {
    stdout: Vec<u8>,
    stderr: Vec<u8>,
    /// What reached over the limit, as far as it was read.
    excess: Vec<u8>,
    limit: Option<Limit>,
}

/// Reads what `child` writes, until it has closed both or reaches a limit.
fn read(child: &mut Child, deadline: Instant, most: usize) -> io::Result<Output> {
    // Small, so that a flood waits in the pipe and not in here.
    let (sender, chunks) = mpsc::sync_channel(2);
    if let Some(pipe) = child.stdout.take() {
        pass_on(pipe, Stream::Output, sender.clone())?;
    }
    if let Some(pipe) = child.stderr.take() {
        pass_on(pipe, Stream::Error, sender.clone())?;
    }
    drop(sender);
    let mut output = Output::default();
    loop {
        match chunks.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
            Ok((stream, mut chunk)) => {
                let room = most - output.stdout.len() - output.stderr.len();
                if chunk.len() > room {
                    output.excess = chunk.split_off(room);
                    output.limit = Some(Limit::Output);
                }
                match stream {
                    Stream::Output => output.stdout.append(&mut chunk),
                    Stream::Error => output.stderr.append(&mut chunk),
                }
            }
            Err(RecvTimeoutError::Disconnected) => return Ok(output),
            Err(RecvTimeoutError::Timeout) => output.limit = Some(Limit::Wall),
        }
        if output.limit.is_some() {
            return Ok(output);
        }
    }
}

#[derive(Clone, Copy)]
enum Stream {
    Output,
    Error,
}

/// Reads on a thread of its own, which ends with the pipe, or when nobody listens any more.
fn pass_on(
    mut pipe: impl Read + Send + 'static,
    stream: Stream,
    sender: SyncSender<(Stream, Vec<u8>)>,
) -> io::Result<()> {
    let read = move || {
        let mut buffer = vec![0; 64 * 1024];
        while let Ok(count @ 1..) = pipe.read(&mut buffer) {
            if sender.send((stream, buffer[..count].to_vec())).is_err() {
                break;
            }
        }
    };
    thread::Builder::new().name("output".into()).spawn(read).map(drop)
}

/// Waits for `child`, which has closed its output and so has ended, or is about to, or hides.
fn wait(child: &mut Child, deadline: Instant) -> io::Result<(End, Option<Limit>)> {
    let mut pause = Duration::from_micros(20);
    loop {
        if let Some(end) = End::of(child)? {
            return Ok((end, None));
        }
        if Instant::now() >= deadline {
            return Ok((kill(child)?, Some(Limit::Wall)));
        }
        thread::sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(5));
    }
}

/// Ends `child` and what it has started.
fn kill(child: &mut Child) -> io::Result<End> {
    // It may have ended by itself.
    let _ = child.kill();
    #[cfg(unix)]
    crate::unix::wait::kill_group(child.id());
    let end = loop {
        match End::of(child)? {
            Some(end) => break end,
            None => thread::sleep(Duration::from_micros(100)),
        }
    };
    #[cfg(unix)]
    crate::unix::wait::wait_for_group(child.id());
    Ok(end)
}

struct End {
    status: Option<ExitStatus>,
    cpu: Duration,
}

impl End {
    /// `None` while `child` runs.
    #[cfg(unix)]
    fn of(child: &mut Child) -> io::Result<Option<End>> {
        let end = match crate::unix::wait::try_wait(child.id()) {
            Err(error) if error.raw_os_error() == Some(libc::ECHILD) => Some((None, Duration::ZERO)),
            end => end?.map(|(status, cpu)| (Some(status), cpu)),
        };
        if end.is_some() {
            // Where no layer keeps it from starting others, they end with it.
            crate::unix::wait::kill_group(child.id());
        }
        Ok(end.map(|(status, cpu)| End { status, cpu }))
    }

    #[cfg(not(unix))]
    fn of(child: &mut Child) -> io::Result<Option<End>> {
        Ok(child.try_wait()?.map(|status| End { status: Some(status), cpu: Duration::ZERO }))
    }

    #[cfg(unix)]
    fn signal(&self) -> Option<i32> {
        std::os::unix::process::ExitStatusExt::signal(&self.status?)
    }

    #[cfg(unix)]
    fn was_killed(&self) -> bool {
        self.signal() == Some(libc::SIGKILL)
    }

    /// The system warns first and then kills. Whoever ignores the warning is known by the time.
    #[cfg(unix)]
    fn is_out_of_time(&self, limits: &Limits) -> bool {
        self.signal() == Some(libc::SIGXCPU) || self.was_killed() && self.cpu >= limits.cpu
    }

    #[cfg(not(unix))]
    fn was_killed(&self) -> bool {
        false
    }

    #[cfg(not(unix))]
    fn is_out_of_time(&self, _limits: &Limits) -> bool {
        false
    }

    /// Whether the last words are those of Rust's or LLVM's allocator when the system gives no more.
    fn gave_up(&self, stderr: &[u8]) -> bool {
        // A whole line, which no message that quotes a source is. What happened on the way there may follow.
        let mut lines = stderr.split(|byte| *byte == b'\n').map(String::from_utf8_lossy);
        let said = |line: std::borrow::Cow<'_, str>| {
            line.starts_with("memory allocation of ") && line.ends_with(" bytes failed")
                || line.ends_with("LLVM ERROR: out of memory")
        };
        self.status.is_some_and(|status| !status.success()) && lines.any(said)
    }
}
