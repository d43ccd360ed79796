//! The viewer in its window.

use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Arc, Mutex};
use std::thread;

use super::display::{Display, Picture, wait_for};

pub struct Viewer<'a> {
    display: &'a Display,
    process: Child,
    window: String,
    /// All that it has written to the terminal.
    terminal: Arc<Mutex<String>>,
}

impl Viewer<'_> {
    /// Opens the viewer of this workspace.
    pub fn open<'a>(display: &'a Display, arguments: &[&str]) -> Viewer<'a> {
        Viewer::open_in(display, Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").as_path(), arguments)
    }

    /// Opens the viewer in another workspace's folder.
    pub fn open_in<'a>(display: &'a Display, workspace: &Path, arguments: &[&str]) -> Viewer<'a> {
        let mut command = super::support::cargo(workspace);
        let cargo = command.get_program().to_owned();
        // The same surroundings, but the viewer instead of cargo.
        let mut viewer = Command::new(env!("CARGO_BIN_EXE_view"));
        for (name, value) in command.get_envs() {
            match value {
                Some(value) => viewer.env(name, value),
                None => viewer.env_remove(name),
            };
        }
        command = viewer;
        let mut process = command
            .args(arguments)
            .env("CARGO", cargo)
            .env("CARGO_MANIFEST_DIR", workspace.join("crates/viewer"))
            .env("DISPLAY", &display.name)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let terminal = Arc::new(Mutex::new(String::new()));
        listen(process.stdout.take().unwrap(), &terminal);
        listen(process.stderr.take().unwrap(), &terminal);
        let search = || {
            let found =
                display.xdotool(&["search", "--name", "[.](bvh|amc)"]).filter(|found| !found.is_empty());
            assert!(process.try_wait().unwrap().is_none(), "it has ended: {}", terminal.lock().unwrap());
            found
        };
        let window = wait_for("the window", search).lines().next().unwrap().to_owned();
        display.xdotool(&["windowfocus", "--sync", &window]);
        Viewer { display, process, window, terminal }
    }

    pub fn key(&self, key: &str) {
        self.display.xdotool(&["key", key]).expect("a key press");
    }

    /// Hands for the mouse: places are counted from the window's corner.
    pub fn mouse(&self, arguments: &[&str]) {
        self.display.xdotool(arguments).expect("a move of the mouse");
    }

    pub fn move_to(&self, x: i32, y: i32) {
        let (x, y) = (x.to_string(), y.to_string());
        self.mouse(&["mousemove", "--sync", "--window", &self.window, &x, &y]);
    }

    pub fn resize(&self, width: usize, height: usize) {
        let (width, height) = (width.to_string(), height.to_string());
        self.display.xdotool(&["windowsize", &self.window, &width, &height]).expect("a new size");
    }

    pub fn window(&self, what: &str) {
        self.display.xdotool(&[what, &self.window]).expect(what);
    }

    pub fn title(&self) -> String {
        self.display.xdotool(&["getwindowname", &self.window]).expect("the title")
    }

    /// The frame in the title bar.
    pub fn frame(&self) -> usize {
        let title = self.title();
        let number = title.split("frame ").nth(1).and_then(|rest| rest.split(' ').next());
        number.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no frame in {title:?}"))
    }

    pub fn wait_for_frame(&self, frame: usize) {
        wait_for(&format!("frame {frame}"), || (self.frame() == frame).then_some(()));
    }

    /// Waits until it has written this to the terminal.
    pub fn wait_for_words(&self, words: &str) {
        let said = || self.terminal.lock().unwrap().contains(words);
        wait_for(&format!("«{words}» in the terminal"), || said().then_some(()));
    }

    /// Waits until the screen is other than `before` in at least this share of its pixels.
    pub fn wait_for_change(&self, what: &str, before: &Picture, share: f64) -> Picture {
        wait_for(what, || Some(self.display.picture()).filter(|now| now.difference(before) >= share))
    }

    /// Takes back what was written to the terminal.
    pub fn forget_words(&self) {
        self.terminal.lock().unwrap().clear();
    }

    pub fn said(&self) -> String {
        self.terminal.lock().unwrap().clone()
    }

    /// Closes it by its key, and sees to it that it ends as it should.
    pub fn close(mut self) -> String {
        self.key("Escape");
        let status = self.wait_for_exit();
        assert!(status.success(), "{status}: {}", self.said());
        self.said()
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

/// Collects what comes from `source`.
fn listen(mut source: impl Read + Send + 'static, terminal: &Arc<Mutex<String>>) {
    let terminal = Arc::clone(terminal);
    thread::spawn(move || {
        let mut bytes = [0; 4096];
        while let Ok(count @ 1..) = source.read(&mut bytes) {
            terminal.lock().unwrap().push_str(&String::from_utf8_lossy(&bytes[..count]));
        }
    });
}
