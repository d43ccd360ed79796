//! The program, from outside.

use std::process::{Command, Output};

/// Runs the viewer where there is no display.
pub fn view(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

/// The viewer, to be run where there is no display.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_view"));
    command
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env("CARGO_MANIFEST_DIR", env!("CARGO_MANIFEST_DIR"));
    command.args(arguments);
    command
}
