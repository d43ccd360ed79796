//! From what happens to the mouse to what is to be done.

/// The mouse as it is at a moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Where it is in the window, in pixels; it may be outside.
    pub place: (f32, f32),
    /// Whether its left button is down.
    pub left: bool,
    /// Whether its right or middle button is down.
    pub right: bool,
    /// Whether Shift is held.
    pub shift: bool,
}

/// What the mouse makes happen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gesture {
    /// Look from another side: dragged by so many pixels to the right and down.
    Orbit(f32, f32),
    /// Move the picture by so many pixels to the right and down.
    Pan(f32, f32),
    /// Go to the frame at this place of the bar on which the button was pressed at the other place.
    Scrub {
        /// Where the button was pressed.
        pressed: (f32, f32),
        /// Where the mouse is now.
        now: (f32, f32),
    },
    /// Pressed and let go in one place.
    Click(f32, f32),
}

/// A button that is down.
#[derive(Clone, Copy, Debug)]
struct Drag {
    kind: Kind,
    pressed: (f32, f32),
    last: (f32, f32),
    moved: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Orbit,
    Pan,
    Scrub,
}

/// How far a mouse may move, in pixels, while somebody means to hold it still.
const STILL: f32 = 3.0;

/// Follows the mouse.
#[derive(Debug, Default)]
pub struct Mouse {
    drag: Option<Drag>,
}

impl Mouse {
    /// What has happened since the mouse was last looked at. `on_bar` says whether a place is on a scrub bar.
    pub fn look(&mut self, state: State, on_bar: impl Fn((f32, f32)) -> bool) -> Option<Gesture> {
        let now = state.place;
        if !(state.left || state.right) {
            let drag = self.drag.take()?;
            return (drag.kind == Kind::Orbit && !drag.moved)
                .then_some(Gesture::Click(drag.pressed.0, drag.pressed.1));
        }
        let Some(drag) = &mut self.drag else {
            let kind = match () {
                () if state.left && on_bar(now) => Kind::Scrub,
                () if state.right || state.shift => Kind::Pan,
                () => Kind::Orbit,
            };
            self.drag = Some(Drag { kind, pressed: now, last: now, moved: false });
            return (kind == Kind::Scrub).then_some(Gesture::Scrub { pressed: now, now });
        };
        drag.moved |= (now.0 - drag.pressed.0).hypot(now.1 - drag.pressed.1) > STILL;
        if !drag.moved || now == drag.last {
            return None;
        }
        let (right, down) = (now.0 - drag.last.0, now.1 - drag.last.1);
        drag.last = now;
        Some(match drag.kind {
            Kind::Orbit => Gesture::Orbit(right, down),
            Kind::Pan => Gesture::Pan(right, down),
            Kind::Scrub => Gesture::Scrub { pressed: drag.pressed, now },
        })
    }

    /// Forgets the button that is down: the window is no longer told when it is let go.
    pub fn forget(&mut self) {
        self.drag = None;
    }
}

/// The wheel's turn in notches, whatever the system counts: 1 a notch under X11, 12 under Windows, and points on the
/// screen, with about 10 of them to a notch, on a Mac.
pub fn notches(turn: f32) -> f32 {
    let per_notch = match () {
        () if cfg!(windows) => 12.0,
        () if cfg!(target_os = "macos") => 10.0,
        () => 1.0,
    };
    turn / per_notch
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32) -> State {
        State { place: (x, y), ..State::default() }
    }

    fn left(x: f32, y: f32) -> State {
        State { left: true, ..at(x, y) }
    }

    #[test]
    fn a_drag_turns_by_all_that_the_mouse_moved_and_is_no_click() {
        let mut mouse = Mouse::default();
        assert_eq!(mouse.look(left(10.0, 10.0), |_| false), None);
        assert_eq!(mouse.look(left(12.0, 10.0), |_| false), None, "a hand is never quite still");
        assert_eq!(mouse.look(left(20.0, 15.0), |_| false), Some(Gesture::Orbit(10.0, 5.0)));
        assert_eq!(mouse.look(left(20.0, 15.0), |_| false), None);
        assert_eq!(mouse.look(at(20.0, 15.0), |_| false), None);
    }

    #[test]
    fn a_click_is_pressed_and_let_go_in_one_place() {
        let mut mouse = Mouse::default();
        mouse.look(left(10.0, 10.0), |_| false);
        assert_eq!(mouse.look(at(11.0, 10.0), |_| false), Some(Gesture::Click(10.0, 10.0)));
        assert_eq!(mouse.look(at(11.0, 10.0), |_| false), None);
    }

    #[test]
    fn the_right_button_and_shift_move_the_picture() {
        for start in [State { right: true, ..at(5.0, 5.0) }, State { shift: true, ..left(5.0, 5.0) }] {
            let mut mouse = Mouse::default();
            mouse.look(start, |_| false);
            let moved = State { place: (15.0, 5.0), ..start };
            assert_eq!(mouse.look(moved, |_| false), Some(Gesture::Pan(10.0, 0.0)));
            assert_eq!(mouse.look(at(15.0, 5.0), |_| false), None);
        }
    }

    #[test]
    fn the_bar_answers_at_once_and_goes_on_when_the_mouse_leaves_it() {
        let mut mouse = Mouse::default();
        let on_bar = |(_, y): (f32, f32)| y > 90.0;
        let pressed = (30.0, 95.0);
        assert_eq!(mouse.look(left(30.0, 95.0), on_bar), Some(Gesture::Scrub { pressed, now: pressed }));
        let now = (60.0, 20.0);
        assert_eq!(mouse.look(left(60.0, 20.0), on_bar), Some(Gesture::Scrub { pressed, now }));
        assert_eq!(mouse.look(at(60.0, 20.0), on_bar), None);
    }

    #[test]
    fn a_button_let_go_elsewhere_is_forgotten() {
        let mut mouse = Mouse::default();
        mouse.look(left(5.0, 5.0), |_| false);
        mouse.forget();
        assert_eq!(mouse.look(at(5.0, 5.0), |_| false), None);
    }
}
