//! A display without a screen, whose picture can be read, and hands for it.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Far longer than anything here takes, on any machine.
pub const PATIENCE: Duration = Duration::from_secs(120);

/// Asks again until there is something.
pub fn wait_for<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(result) = ask() {
            return result;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain for {what}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// Whether this machine has what the tests need.
pub fn is_possible() -> bool {
    let there = |program: &str, argument: &str| {
        let command =
            Command::new(program).arg(argument).stdout(Stdio::null()).stderr(Stdio::null()).status();
        command.is_ok()
    };
    there("Xvfb", "-help") && there("xdotool", "version")
}

/// An X server whose screen is a file.
pub struct Display {
    server: Child,
    pub name: String,
    screen: tempfile::TempDir,
}

impl Display {
    pub fn start() -> Display {
        let screen = tempfile::tempdir().unwrap();
        // Without -noreset the server starts anew when its last client goes: a search for the window may be that client,
        // and the viewer, which connects just then, is turned away.
        // The server chooses a free number and writes it to its standard output.
        let mut server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-screen",
                "0",
                "1280x800x24",
                "-nolisten",
                "tcp",
                "-noreset",
                "-fbdir",
            ])
            .arg(screen.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is needed for this test (package xvfb)");
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap()).read_line(&mut number).unwrap();
        assert!(!number.trim().is_empty(), "Xvfb has not started");
        Display { server, name: format!(":{}", number.trim()), screen }
    }

    pub fn xdotool(&self, arguments: &[&str]) -> Option<String> {
        let output = Command::new("xdotool")
            .args(arguments)
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool is needed for this test (package xdotool)");
        let text = String::from_utf8(output.stdout).unwrap().trim().to_owned();
        output.status.success().then_some(text)
    }

    /// What is on the screen now.
    pub fn picture(&self) -> Picture {
        Picture::read(self.screen.path().join("Xvfb_screen0"))
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// The pixels of a screen.
#[derive(Clone, PartialEq)]
pub struct Picture {
    width: usize,
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// Reads an X window dump (X11/XWDFile.h): a header of 32-bit numbers, most significant byte first, colours of 12
    /// bytes each, and rows of pixels.
    fn read(path: PathBuf) -> Picture {
        let bytes = fs::read(path).unwrap();
        let number = |index: usize| {
            let four: [u8; 4] = bytes[4 * index..4 * index + 4].try_into().unwrap();
            u32::from_be_bytes(four) as usize
        };
        let (header, width, height, per_row, colors) =
            (number(0), number(4), number(5), number(12), number(19));
        let data = &bytes[header + 12 * colors..];
        let pixel = |at: usize| [data[at + 2], data[at + 1], data[at]];
        let row = |y: usize| (0..width).map(move |x| pixel(y * per_row + 4 * x));
        Picture { width, pixels: (0..height).flat_map(row).collect() }
    }

    /// How many pixels have this colour.
    pub fn count(&self, color: [u8; 3]) -> usize {
        self.pixels.iter().filter(|pixel| **pixel == color).count()
    }

    /// The share of the pixels in which two pictures are clearly different.
    pub fn difference(&self, other: &Picture) -> f64 {
        assert_eq!((self.width, self.pixels.len()), (other.width, other.pixels.len()));
        let differ = |(a, b): &(&[u8; 3], &[u8; 3])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 16);
        self.pixels.iter().zip(&other.pixels).filter(differ).count() as f64 / self.pixels.len() as f64
    }
}
