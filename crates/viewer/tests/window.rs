//! The window, opened on a display of its own and used as a student would.
//!
//! These tests need Xvfb and xdotool: `cargo test -p viewer --test window -- --ignored`. Without them they fail and
//! say what is missing.
#![cfg(all(unix, not(target_os = "macos")))]
#![allow(clippy::unwrap_used)]

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Far longer than anything here takes, on any machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// Asks again until there is something.
fn wait_for<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(result) = ask() {
            return result;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain for {what}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// An X server without a screen.
struct Display {
    server: Child,
    name: String,
}

impl Display {
    fn start() -> Display {
        // Without -noreset the server starts anew when its last client goes: a search for the window may be that client,
        // and the viewer, which connects just then, is turned away.
        // The server chooses a free number and writes it to its standard output.
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp", "-noreset"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is needed for this test (package xvfb)");
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap()).read_line(&mut number).unwrap();
        assert!(!number.trim().is_empty(), "Xvfb has not started");
        Display { server, name: format!(":{}", number.trim()) }
    }

    fn xdotool(&self, arguments: &[&str]) -> Option<String> {
        let output = Command::new("xdotool")
            .args(arguments)
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool is needed for this test (package xdotool)");
        let text = String::from_utf8(output.stdout).unwrap().trim().to_owned();
        output.status.success().then_some(text)
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// The viewer in its window.
struct Viewer<'a> {
    display: &'a Display,
    process: Child,
    window: String,
}

impl Viewer<'_> {
    fn open<'a>(display: &'a Display, arguments: &[&str]) -> Viewer<'a> {
        let process = Command::new(env!("CARGO_BIN_EXE_view"))
            .args(arguments)
            .env("DISPLAY", &display.name)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let search =
            || display.xdotool(&["search", "--name", "running.bvh"]).filter(|found| !found.is_empty());
        let window = wait_for("the window", search).lines().next().unwrap().to_owned();
        display.xdotool(&["windowfocus", "--sync", &window]);
        Viewer { display, process, window }
    }

    fn key(&self, key: &str) {
        self.display.xdotool(&["key", key]).expect("a key press");
    }

    fn title(&self) -> String {
        self.display.xdotool(&["getwindowname", &self.window]).expect("the title")
    }

    /// The frame in the title bar.
    fn frame(&self) -> usize {
        let title = self.title();
        let number = title.split("frame ").nth(1).and_then(|rest| rest.split(' ').next());
        number.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no frame in {title:?}"))
    }

    fn wait_for_exit(&mut self) -> ExitStatus {
        let process = &mut self.process;
        wait_for("the end of the viewer", || process.try_wait().unwrap())
    }
}

impl Drop for Viewer<'_> {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

#[test]
#[ignore = "needs Xvfb and xdotool; .ci/run runs it"]
fn keys_step_play_and_close() {
    let display = Display::start();
    let mut viewer = Viewer::open(&display, &["--solution"]);
    assert_eq!(viewer.frame(), 0);

    for expected in 1..=3 {
        viewer.key("w");
        wait_for("the next frame", || (viewer.frame() == expected).then_some(()));
    }
    viewer.key("comma");
    wait_for("the frame before", || (viewer.frame() == 2).then_some(()));

    viewer.key("space");
    wait_for("the motion to play", || {
        (viewer.frame() > 30 && viewer.title().ends_with("playing")).then_some(())
    });
    viewer.key("space");
    wait_for("the pause", || (!viewer.title().ends_with("playing")).then_some(()));
    let paused = viewer.frame();
    viewer.key("w");
    wait_for("one more frame", || (viewer.frame() == paused + 1).then_some(()));

    viewer.key("Escape");
    assert!(viewer.wait_for_exit().success());
    let mut printed = String::new();
    viewer.process.stdout.take().unwrap().read_to_string(&mut printed).unwrap();
    assert!(printed.contains("Hips") && printed.contains("frame time"), "the skeleton is printed: {printed}");
}

#[test]
#[ignore = "needs Xvfb and xdotool; .ci/run runs it"]
fn many_fast_taps_all_count() {
    let display = Display::start();
    let mut viewer = Viewer::open(&display, &["--solution"]);
    viewer.display.xdotool(&["key", "--delay", "1", "--repeat", "25", "w"]).unwrap();
    wait_for("all 25 frames", || (viewer.frame() == 25).then_some(()));
    viewer.key("Escape");
    assert!(viewer.wait_for_exit().success());
}

#[test]
#[ignore = "needs Xvfb and xdotool; .ci/run runs it"]
fn it_survives_another_size_and_works_on_with_the_students_functions() {
    let display = Display::start();
    let mut viewer = Viewer::open(&display, &[]);
    for (width, height) in [("640", "360"), ("1100", "700"), ("40", "30"), ("800", "600")] {
        viewer.display.xdotool(&["windowsize", "--sync", &viewer.window, width, height]).expect("a new size");
        let before = viewer.frame();
        viewer.key("w");
        wait_for("a frame at the new size", || (viewer.frame() == before + 1).then_some(()));
    }
    viewer.key("Escape");
    assert!(viewer.wait_for_exit().success());
}
