//! Waiting for a process, and ending it with all that it started.

use std::io;
use std::mem::MaybeUninit;
use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;
use std::thread;
use std::time::Duration;

use nix::sys::signal::{Signal, killpg};
use nix::unistd::Pid;

/// How the child `pid` ended and the processor time that it and its own children took; `None` while it runs.
#[allow(unsafe_code)]
pub fn try_wait(pid: u32) -> io::Result<Option<(ExitStatus, Duration)>> {
    let mut status = 0;
    let mut usage = MaybeUninit::<libc::rusage>::zeroed();
    // SAFETY: both pointers are to live values of the right type.
    let waited =
        unsafe { libc::wait4(pid.cast_signed(), &raw mut status, libc::WNOHANG, usage.as_mut_ptr()) };
    match waited {
        -1 => Err(io::Error::last_os_error()),
        0 => Ok(None),
        _ => {
            // SAFETY: all zeroes is a valid value, and `wait4` has filled it in.
            let usage = unsafe { usage.assume_init() };
            Ok(Some((ExitStatus::from_raw(status), duration(usage.ru_utime) + duration(usage.ru_stime))))
        }
    }
}

/// Ends all processes of the group that `leader` leads, if there are any left.
pub fn kill_group(leader: u32) {
    let _ = killpg(Pid::from_raw(leader.cast_signed()), Signal::SIGKILL);
}

/// Waits until the group that `leader` led is empty: killing takes a moment. Not for ever, because where nobody fetches
/// dead orphans they stay in it.
pub fn wait_for_group(leader: u32) {
    for _ in 0..1000 {
        if killpg(Pid::from_raw(leader.cast_signed()), None).is_err() {
            return;
        }
        thread::sleep(Duration::from_micros(100));
    }
}

fn duration(time: libc::timeval) -> Duration {
    // Times are never negative. Their types differ between systems.
    let (seconds, micros) = (u64::try_from(time.tv_sec), u64::try_from(time.tv_usec));
    Duration::from_secs(seconds.unwrap_or(0)) + Duration::from_micros(micros.unwrap_or(0))
}
