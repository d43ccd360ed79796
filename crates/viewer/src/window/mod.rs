//! The window: hands keys and mouse to the gallery, and its picture to the display.

pub(crate) mod input;
pub mod keyboard;
pub mod keys;
mod no_window;

use std::sync::mpsc::{self, Receiver, Sender};
use std::time::{Duration, Instant};

use minifb::{InputCallback, Key, MouseButton, MouseMode, Window, WindowOptions};

use crate::draw::canvas::Canvas;
use crate::view::screen::Screen;
use crate::view::session::Session;
use input::{Mouse, State, notches};
use keyboard::{Event, Keyboard};
use keys::Action;

pub use no_window::NoWindow;

/// Pictures per second. The motion's own speed does not depend on it.
const PICTURES_PER_SECOND: usize = 60;

/// Opens a window of `size` pixels, and in it shows the session that `begin` gives, until it is closed.
///
/// # Errors
///
/// When no window can be opened, or when it is lost.
pub fn open(begin: impl FnOnce() -> Session, size: (usize, usize)) -> Result<(), NoWindow> {
    let no_window = |lost: bool| move |error: minifb::Error| NoWindow { why: error.to_string(), lost };
    let options = WindowOptions { resize: true, ..WindowOptions::default() };
    let mut window = Window::new("cargo view", size.0, size.1, options).map_err(no_window(false))?;
    // Nothing is built where there is no window to show it in.
    let mut session = begin();
    let mut title = String::new();
    window.set_target_fps(PICTURES_PER_SECOND);
    let (sender, events) = mpsc::channel();
    window.set_input_callback(Box::new(KeyEvents(sender)));

    let mut input = Input { events, keyboard: Keyboard::default(), mouse: Mouse::default() };
    let mut screen = Screen::new(size);
    let mut last = Instant::now();
    while window.is_open() {
        let passed = last.elapsed();
        last = Instant::now();
        if input.apply(&mut window, &mut session, passed) {
            break;
        }
        session.gallery.advance(passed.as_secs_f64());
        session.update();

        let size = Canvas::clamped(window.get_size());
        session.draw(&mut screen, size);
        let now = session.gallery.window_title();
        if title != now {
            window.set_title(&now);
            title = now;
        }
        // Always with the picture, changed or not: some systems paint from it while they look for events.
        let presented = window.update_with_buffer(screen.canvas().pixels(), size.0, size.1);
        presented.map_err(no_window(true))?;
    }
    // The window goes first: the student's functions may need a moment to be stopped.
    drop(window);
    drop(session);
    Ok(())
}

/// Key events as they happen: asking for the state of the keys once per picture would miss short taps.
struct KeyEvents(Sender<Event>);

impl InputCallback for KeyEvents {
    fn add_char(&mut self, character: u32) {
        if let Some(character) = char::from_u32(character) {
            // Nobody listens any more only when the window is about to go.
            let _ = self.0.send(Event::Typed(character));
        }
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        let _ = self.0.send(if down { Event::Down(key) } else { Event::Up(key) });
    }
}

struct Input {
    events: Receiver<Event>,
    keyboard: Keyboard,
    mouse: Mouse,
}

impl Input {
    /// Hands on what has happened since the last time, `passed` ago. Gives whether the window is to be closed.
    fn apply(&mut self, window: &mut Window, session: &mut Session, passed: Duration) -> bool {
        if !window.is_active() {
            self.keyboard.forget();
            self.mouse.forget();
        }
        if let Some((action, times)) = self.keyboard.pass(passed) {
            (0..times).for_each(|_| session.gallery.act(action));
        }
        for event in self.events.try_iter() {
            match self.keyboard.event(event) {
                Some(Action::Quit) => return true,
                Some(action) => session.gallery.act(action),
                None => {}
            }
        }
        if let Some((_, turn)) = window.get_scroll_wheel() {
            session.gallery.apps_mut().iter_mut().for_each(|app| app.wheel(notches(turn)));
        }
        if let Some(place) = window.get_mouse_pos(MouseMode::Pass) {
            let down = |button| window.get_mouse_down(button);
            let state = State {
                place,
                left: down(MouseButton::Left),
                right: down(MouseButton::Right) || down(MouseButton::Middle),
                shift: self.keyboard.shift(),
            };
            let size = Canvas::clamped(window.get_size());
            let gesture = self.mouse.look(state, |place| session.gallery.on_bar(place, size));
            if let Some(gesture) = gesture {
                session.gesture(gesture, size);
            }
        }
        false
    }
}
