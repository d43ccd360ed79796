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
    /// How the process ended; `None` when that cannot be found out.
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
        let deadline = Instant::now() + confinement.limits.wall;
        let output = read(&mut child, deadline, confinement.limits.output);
        let (end, limit) = match output.limit {
            Some(limit) => (kill(&mut child), Some(limit)),
            None => wait(&mut child, deadline),
        };
        if let Some(reason) = self.setup_failure(&output.stderr) {
            return Err(io::Error::other(reason));
        }
        let (status, cpu) = end.map_or((None, Duration::ZERO), |end| (Some(end.status), end.cpu));
        let limit = limit.or_else(|| {
            let killed_for_memory = || self.0.resources.killed_for_memory(slot, &confinement.limits);
            let memory = || (gave_up(&output.stderr, status) || killed_for_memory()).then_some(Limit::Memory);
            cpu_limit(status, cpu, &confinement.limits).or_else(memory)
        });
        Ok(Finished { status, stdout: output.stdout, stderr: output.stderr, limit, cpu })
    }
}

struct Output {
    stdout: Vec<u8>,
    stderr: Vec<u8>,
    limit: Option<Limit>,
}

/// Reads what `child` writes, until it has closed both or reaches a limit.
fn read(child: &mut Child, deadline: Instant, most: usize) -> Output {
    let mut output = Output { stdout: Vec::new(), stderr: Vec::new(), limit: None };
    // Small, so that a flood waits in the pipe and not in here.
    let (sender, chunks) = mpsc::sync_channel(2);
    if let Some(pipe) = child.stdout.take() {
        pass_on(pipe, Stream::Output, sender.clone());
    }
    if let Some(pipe) = child.stderr.take() {
        pass_on(pipe, Stream::Error, sender.clone());
    }
    drop(sender);
    loop {
        match chunks.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
            Ok((stream, chunk)) => {
                let room = most - output.stdout.len() - output.stderr.len();
                let kept = chunk.get(..room).unwrap_or(&chunk);
                match stream {
                    Stream::Output => output.stdout.extend_from_slice(kept),
                    Stream::Error => output.stderr.extend_from_slice(kept),
                }
                if chunk.len() > room {
                    output.limit = Some(Limit::Output);
                    return output;
                }
            }
            Err(RecvTimeoutError::Disconnected) => return output,
            Err(RecvTimeoutError::Timeout) => {
                output.limit = Some(Limit::Wall);
                return output;
            }
        }
    }
}

#[derive(Clone, Copy)]
enum Stream {
    Output,
    Error,
}

/// Reads on a thread of its own, which ends with the pipe, or when nobody listens any more.
fn pass_on(mut pipe: impl Read + Send + 'static, stream: Stream, sender: SyncSender<(Stream, Vec<u8>)>) {
    thread::spawn(move || {
        let mut buffer = vec![0; 64 * 1024];
        while let Ok(count @ 1..) = pipe.read(&mut buffer) {
            if sender.send((stream, buffer[..count].to_vec())).is_err() {
                break;
            }
        }
    });
}

struct End {
    status: ExitStatus,
    cpu: Duration,
}

/// Waits for `child`, which has closed its output and so has ended, or is about to, or hides.
fn wait(child: &mut Child, deadline: Instant) -> (io::Result<End>, Option<Limit>) {
    let mut pause = Duration::from_micros(20);
    loop {
        match try_wait(child) {
            Ok(Some(end)) => return (Ok(end), None),
            Err(error) => return (Err(error), None),
            Ok(None) if Instant::now() >= deadline => return (kill(child), Some(Limit::Wall)),
            Ok(None) => thread::sleep(pause),
        }
        pause = (pause * 2).min(Duration::from_millis(5));
    }
}

fn kill(child: &mut Child) -> io::Result<End> {
    let _ = child.kill();
    #[cfg(unix)]
    crate::unix::wait::kill_group(child.id());
    loop {
        if let Some(end) = try_wait(child)? {
            return Ok(end);
        }
        thread::sleep(Duration::from_micros(100));
    }
}

#[cfg(unix)]
fn try_wait(child: &mut Child) -> io::Result<Option<End>> {
    let end = crate::unix::wait::try_wait(child.id())?;
    if end.is_some() {
        // Where no layer keeps it from starting others, they end with it.
        crate::unix::wait::kill_group(child.id());
    }
    Ok(end.map(|(status, cpu)| End { status, cpu }))
}

#[cfg(not(unix))]
fn try_wait(child: &mut Child) -> io::Result<Option<End>> {
    Ok(child.try_wait()?.map(|status| End { status, cpu: Duration::ZERO }))
}

/// The system warns first and then kills. Whoever ignores the warning is known by the time.
fn cpu_limit(status: Option<ExitStatus>, cpu: Duration, limits: &Limits) -> Option<Limit> {
    #[cfg(unix)]
    {
        use std::os::unix::process::ExitStatusExt;
        let signal = status?.signal()?;
        let killed = signal == libc::SIGKILL && cpu >= limits.cpu;
        (signal == libc::SIGXCPU || killed).then_some(Limit::Cpu)
    }
    #[cfg(not(unix))]
    {
        let _ = (status, cpu, limits);
        None
    }
}

/// Whether the last words are those of Rust's or LLVM's allocator when the system gives no more.
fn gave_up(stderr: &[u8], status: Option<ExitStatus>) -> bool {
    let end = &stderr[stderr.len().saturating_sub(2000)..];
    let end = String::from_utf8_lossy(end);
    let words = [("memory allocation of ", " bytes failed"), ("LLVM ERROR: out of memory", "")];
    let says = words.iter().any(|(one, two)| end.contains(one) && end.contains(two));
    says && status.is_some_and(|status| !status.success())
}
