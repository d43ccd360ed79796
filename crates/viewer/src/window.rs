//! The window: hands keys and mouse to the app, and its pictures to the display.

use std::fmt;
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::Instant;

use minifb::{InputCallback, Key, MouseButton, MouseMode, Window, WindowOptions};

use crate::app::{App, Shown};
use crate::canvas::Canvas;
use crate::draw::Painter;
use crate::keys::{Action, Keyboard};
use crate::live::Live;

/// Pictures per second. The motion's own speed does not depend on it.
const PICTURES_PER_SECOND: usize = 60;

/// Shows `app` in a window of `size` pixels until it is closed. With `live`, the student's functions move the
/// figure; without, the reference's do.
///
/// # Errors
///
/// When no window can be opened.
pub fn open(mut app: App, size: (usize, usize), live: Option<impl FnOnce() -> Live>) -> Result<(), NoWindow> {
    let options = WindowOptions { resize: true, ..WindowOptions::default() };
    let mut window = Window::new(&app.window_title(), size.0, size.1, options)
        .map_err(|error| NoWindow { why: error.to_string() })?;
    window.set_target_fps(PICTURES_PER_SECOND);
    let (sender, keys) = mpsc::channel();
    window.set_input_callback(Box::new(KeyEvents(sender)));

    let mut live = live.map(|open| open());
    let mut input = Input { keys, keyboard: Keyboard::default(), grabbed: None };
    let mut painter = Painter::new();
    let mut canvas = Canvas::new(size.0, size.1);
    let mut drawn = None;
    let mut title = String::new();
    let mut last = Instant::now();
    while window.is_open() {
        if input.apply(&mut window, &mut app) {
            break;
        }
        app.advance(last.elapsed().as_secs_f64());
        last = Instant::now();

        let frame = app.frame();
        if let Some(live) = &mut live {
            live.update(&[frame]);
        }
        let standing = live.as_ref().map(|live| live.student().standing(0, frame));
        let shown = match (&live, &standing) {
            (Some(live), Some(standing)) => {
                Shown::Student { posed: live.student().pose(0, frame), status: &standing.status }
            }
            _ => Shown::Reference,
        };

        let size = Canvas::clamped(window.get_size());
        let scene = app.scene(shown, size);
        if canvas.size() != size || drawn.as_ref() != Some(&scene) {
            if canvas.size() != size {
                canvas = Canvas::new(size.0, size.1);
            }
            painter.draw(&scene, &mut canvas);
            drawn = Some(scene);
        }
        if title != app.window_title() {
            title = app.window_title();
            window.set_title(&title);
        }
        let presented = window.update_with_buffer(canvas.pixels(), size.0, size.1);
        presented.map_err(|error| NoWindow { why: error.to_string() })?;
    }
    // The window goes first: the student's functions may need a moment to be stopped.
    drop(window);
    drop(live);
    Ok(())
}

/// Key events as they happen: asking for the state of the keys once per picture would miss short taps.
struct KeyEvents(Sender<(Key, bool)>);

impl InputCallback for KeyEvents {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, down: bool) {
        // Nobody listens any more only when the window is about to go.
        let _ = self.0.send((key, down));
    }
}

struct Input {
    keys: Receiver<(Key, bool)>,
    keyboard: Keyboard,
    /// Where the mouse was when it was last seen with its button down.
    grabbed: Option<(f32, f32)>,
}

impl Input {
    /// Hands on what has happened since the last picture. Gives whether the window is to be closed.
    fn apply(&mut self, window: &mut Window, app: &mut App) -> bool {
        for (key, down) in self.keys.try_iter() {
            match self.keyboard.event(key, down) {
                Some(Action::Quit) => return true,
                Some(action) => app.act(action),
                None => {}
            }
        }
        if !window.is_active() {
            self.keyboard.forget();
        }
        if let Some((_, notches)) = window.get_scroll_wheel() {
            app.wheel(notches);
        }
        let mouse =
            window.get_mouse_pos(MouseMode::Pass).filter(|_| window.get_mouse_down(MouseButton::Left));
        if let (Some(before), Some(now)) = (self.grabbed, mouse)
            && before != now
        {
            app.drag(now.0 - before.0, now.1 - before.1);
        }
        self.grabbed = mouse;
        false
    }
}

/// No window can be opened here. `Display` says what to do instead.
#[derive(Debug)]
pub struct NoWindow {
    why: String,
}

impl fmt::Display for NoWindow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "No window can be opened here: {}.", self.why)?;
        writeln!(f, "A picture works without one: add --png picture.png --frame 0 to the command.")?;
        write!(f, "{}", advice())
    }
}

impl std::error::Error for NoWindow {}

fn advice() -> String {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return "For a window, run this in a session with a desktop, not in a remote shell or a service."
            .into();
    }
    let display = match std::env::var_os("DISPLAY") {
        None => "- DISPLAY is not set. In a desktop's own terminal it is; over ssh, use ssh -X.\n".to_owned(),
        Some(display) => format!("- DISPLAY is {}: is an X server running there?\n", display.display()),
    };
    format!(
        "For a window:\n{display}\
         - In a Wayland session, XWayland must be installed (package xwayland).\n\
         - The libraries libX11 and libXcursor are needed (packages libx11-6 and libxcursor1, or libX11 and libXcursor)."
    )
}
