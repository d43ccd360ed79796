//! Runs a program confined: it reads what it is given, writes one folder or nothing, and ends with its limits.
//!
//! On Linux these layers stand one behind the other, each with a hole that another one closes:
//!
//! | layer | what it is | what it leaves open |
//! |---|---|---|
//! | namespaces | a root of its own that holds just the given files, read-only; own processes, network, IPC | memory, time |
//! | own user | a user of its own per slot (when started as root): no rights over other files and processes | what all may read |
//! | cgroup | memory and tasks of the whole slot are counted (when started as root) | files, network |
//! | landlock | the kernel refuses all other files, TCP, and signals to others | whether a file exists, `chmod`, UDP |
//! | seccomp | the kernel refuses all system calls but those of a program with threads: no processes, no sockets | file names |
//! | limits | processor time, address space, size of files, open files, no core dumps | sleeping |
//!
//! What no layer limits is watched from outside: time by the clock and the amount of output ([`Sandbox::run`]). On other
//! systems there is no jail; [`Sandbox::unsandboxed`] says so in its [`Layers`].
//!
//! # The launcher
//!
//! A process with threads must not set all this up between `fork` and `exec`. A fresh process does: the program that
//! uses this crate starts itself once more (or any other program that calls [`enter_if_asked`]), with arguments that
//! tell it to become the jail and then the confined program.
//!
//! ```no_run
//! use std::time::Duration;
//! use sandbox::{Confinement, Limits, Sandbox};
//!
//! sandbox::enter_if_asked(); // The first thing in `main`.
//!
//! let libraries = sandbox::system_libraries();
//! let sandbox = Sandbox::strongest(std::env::current_exe()?, &libraries)?;
//! let limits = Limits {
//!     cpu: Duration::from_secs(2),
//!     wall: Duration::from_secs(5),
//!     memory: 1 << 30,
//!     threads: 8,
//!     output: 1 << 20,
//!     file_size: 0,
//! };
//! let mut read = libraries.clone();
//! read.push("/bin/true".into());
//! let confinement = Confinement { read, folder: None, environment: Vec::new(), limits };
//! let finished = sandbox.run(0, &confinement, "/bin/true".as_ref(), &[])?;
//! assert!(finished.status.is_some_and(|status| status.success()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![deny(missing_docs)]

mod confinement;
mod findings;
mod layers;
mod run;
mod sandbox;
#[cfg(unix)]
mod unix;

#[cfg(not(target_os = "linux"))]
mod elsewhere;
#[cfg(target_os = "linux")]
mod linux;
#[cfg(not(target_os = "linux"))]
use elsewhere as platform;
#[cfg(target_os = "linux")]
use linux as platform;

pub use confinement::{Confinement, Limits, system_libraries};
pub use findings::{Finding, findings};
pub use layers::{Layer, Layers};
pub use run::{Finished, Limit};
pub use sandbox::{Sandbox, Unavailable};

/// What the launcher calls first in its `main`. When the command line asks for it, this process becomes the jail and
/// then the confined program, and this function does not return. Otherwise it returns at once.
///
/// Call it while the process has one thread.
pub fn enter_if_asked() {
    #[cfg(unix)]
    unix::enter_if_asked();
}
