//! What a hostile program tries, tried behind every set of layers that users meet.
//!
//! This one program is everything: the test runner, the judge that runs as some user on some machine ([`modes`]) and
//! starts the attacker ([`attacker`]), the launcher, and the attacker itself.
#![allow(clippy::unwrap_used)] // Tests.
#![cfg_attr(not(target_os = "linux"), allow(unused))]

use std::env;
use std::process::ExitCode;

#[cfg(target_os = "linux")]
mod attacker;
#[cfg(target_os = "linux")]
mod cases;
#[cfg(target_os = "linux")]
mod exhausted;
#[cfg(target_os = "linux")]
mod judge;
#[cfg(target_os = "linux")]
mod modes;
#[cfg(target_os = "linux")]
mod refused;

#[cfg(target_os = "linux")]
fn main() -> ExitCode {
    sandbox::enter_if_asked();
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        [attacker::ROLE, attack, ref rest @ ..] => attacker::run(attack, rest),
        [judge::ROLE, mode, case] => judge::run(mode, case),
        [judge::HARNESS, mode, folder] => judge::be_a_harness(mode, folder),
        _ => return modes::run_all(),
    }
    ExitCode::SUCCESS
}

#[cfg(not(target_os = "linux"))]
fn main() {
    sandbox::enter_if_asked();
    eprintln!("NOT RUN: there is no jail to attack on this system.");
}
