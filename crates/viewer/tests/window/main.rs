//! The window, opened on a display of its own and used as a student would.
//!
//! These tests need Xvfb and xdotool, and say aloud when they do not run because something is missing. Those that compile an
//! exercise take longer: `cargo test -p viewer --test window -- --include-ignored`.
#![allow(clippy::unwrap_used)]

#[cfg(all(unix, not(target_os = "macos")))]
mod acclaim;
#[cfg(all(unix, not(target_os = "macos")))]
mod display;
#[cfg(all(unix, not(target_os = "macos")))]
mod files;
#[cfg(all(unix, not(target_os = "macos")))]
mod input;
#[cfg(all(unix, not(target_os = "macos")))]
mod live;
#[cfg(all(unix, not(target_os = "macos")))]
mod sister;
#[cfg(all(unix, not(target_os = "macos")))]
#[path = "../../../grading/tests/support/mod.rs"]
mod support;
#[cfg(all(unix, not(target_os = "macos")))]
mod time_warp;
#[cfg(all(unix, not(target_os = "macos")))]
mod viewer;
#[cfg(all(unix, not(target_os = "macos")))]
mod warp;

/// Tests that edit the same copy of the workspace take turns.
#[cfg(all(unix, not(target_os = "macos")))]
static TURN: std::sync::Mutex<()> = std::sync::Mutex::new(());

#[cfg(all(unix, not(target_os = "macos")))]
fn main() {
    use libtest_mimic::{Arguments, Trial};

    let mut arguments = Arguments::from_args();
    // Windows of one display take the keys from each other, and each test has a display: but there are few processors.
    arguments.test_threads = arguments.test_threads.or(Some(2));
    let possible = display::is_possible();
    if !possible {
        println!("NOT RUN: the tests of the window need Xvfb and xdotool (packages xvfb and xdotool).");
    }
    let quick = input::TESTS.iter().chain(files::TESTS).chain(warp::TESTS).map(|test| (test, false));
    let slow = live::TESTS
        .iter()
        .chain(sister::TESTS)
        .chain(acclaim::TESTS)
        .chain(time_warp::TESTS)
        .map(|test| (test, true));
    let trials = quick.chain(slow).map(|((name, test), slow)| {
        Trial::test(*name, move || {
            test();
            Ok(())
        })
        .with_ignored_flag(slow || !possible)
    });
    libtest_mimic::run(&arguments, trials.collect()).exit();
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn main() {
    println!("NOT RUN: the tests of the window need X11.");
}
