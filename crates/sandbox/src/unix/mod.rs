//! The launcher: the process that becomes the jail and then the program.

use std::convert::Infallible;
use std::ffi::{OsStr, OsString};
use std::io::{self, Write};
use std::os::unix::process::CommandExt;
use std::process::{Command, exit};
use std::{env, fmt};

pub mod limits;
pub mod spec;
pub mod wait;

use spec::Spec;

/// The launcher's first argument when it is to confine. Then follow the token, the spec, and the program's arguments.
pub const ENTER: &str = "--enter-sandbox";

/// What the launcher ends with when the jail cannot be set up. The token says so beyond doubt.
pub const SETUP_FAILED: i32 = 125;

pub fn enter_if_asked() {
    let mut arguments = env::args_os().skip(1);
    let Some(first) = arguments.next() else { return };
    if first == ENTER {
        let token = arguments.next().unwrap_or_default();
        let Err(failure) = enter(&token, arguments);
        fail(&token, &failure);
    }
    #[cfg(target_os = "linux")]
    crate::linux::enter_if_asked(&first, arguments);
}

/// Says what went wrong, so that it cannot be mistaken for the program's own words, and ends.
pub fn fail(token: &OsStr, failure: &dyn fmt::Display) -> ! {
    // In one piece: who watches the amount of output may stop reading behind the first.
    let text = format!("\n{} {failure}\n", token.display());
    let _ = io::stderr().write_all(text.as_bytes());
    exit(SETUP_FAILED)
}

fn enter(token: &OsStr, mut arguments: impl Iterator<Item = OsString>) -> Result<Infallible, String> {
    let spec = arguments.next().unwrap_or_default();
    let spec = Spec::decode(&spec).ok_or("the launcher got arguments that it does not understand")?;
    let mut program = Command::new(spec.program());
    program.args(arguments);
    #[cfg(target_os = "linux")]
    return crate::linux::confine(token, &spec, program);
    #[cfg(not(target_os = "linux"))]
    {
        let _ = token;
        nix::unistd::setsid().context("start a session")?;
        if let Some(folder) = spec.folder() {
            env::set_current_dir(folder).context("enter the folder")?;
        }
        limits::apply(&spec).context("set the limits")?;
        Err(replace(&spec, &mut program))
    }
}

/// Starts `program` in place of this process.
pub fn replace(spec: &Spec, program: &mut Command) -> String {
    format!("start {}: {}", spec.program().display(), program.exec())
}

/// Says what was being done when an error came up.
pub trait Context<T> {
    /// The error, as "could not WHAT: WHY".
    fn context(self, what: &str) -> Result<T, String>;
}

impl<T, E: fmt::Display> Context<T> for Result<T, E> {
    fn context(self, what: &str) -> Result<T, String> {
        self.map_err(|error| format!("could not {what}: {error}"))
    }
}
