//! The keys: one table for what they do, for the help in the window, for `--help` and for the book.

use minifb::Key;

/// Something that a key makes happen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Go this many frames further, or back when it is negative.
    Step(isize),
    /// Play or pause.
    Play,
    /// Play in the other direction.
    Reverse,
    /// Play more slowly.
    Slower,
    /// Play faster.
    Faster,
    /// Begin again at the end, or stop there.
    Loop,
    /// Go to frame 0.
    First,
    /// Go to the last frame.
    Last,
    /// Play from this frame on, or warp from it on.
    RangeStart,
    /// Play up to this frame, or warp up to it.
    RangeEnd,
    /// Interpolate the stretch that is played, or in another way, or not any more.
    Interpolate,
    /// Choose keyframes automatically, or do not.
    Automatic,
    /// Take so many more automatic keyframes, or fewer when it is negative; or more or fewer frames of a warped motion.
    Keyframes(isize),
    /// Show the original over the interpolated figure, or beside it.
    Beside,
    /// Show or hide error vectors.
    Errors,
    /// Show or hide the plot of errors, or the curve of a warp.
    Plot,
    /// Move the camera so that everything is in the picture.
    Frame,
    /// Move the camera with the figure, or leave it where it is.
    Follow,
    /// Show or hide the goal.
    Ghost,
    /// Show or hide motion traces.
    Traces,
    /// Show or hide the joints' axes.
    Axes,
    /// Draw bodies with light and shadow, or plain lines.
    Look,
    /// Look at the next joint.
    NextJoint,
    /// Look at the joint before.
    PreviousJoint,
    /// Look at no joint.
    NoJoint,
    /// Show or hide the points.
    Points,
    /// Show the next motion by itself, or all side by side.
    NextMotion,
    /// Show or hide the help.
    Help,
    /// Close the window.
    Quit,
}

/// One line of the help: some keys that belong together.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The keys' names, for people.
    pub name: &'static str,
    /// What they do, for people.
    pub help: &'static str,
    /// The keys.
    pub bindings: &'static [Binding],
}

/// A key and what it does.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// The key.
    pub key: Key,
    /// Whether Shift must be held with it (`Some(true)`), must not be, or does not matter.
    pub shift: Option<bool>,
    /// What happens.
    pub action: Action,
    /// Whether it happens again and again while the key is held.
    pub repeats: bool,
}

/// All keys, in the order of the help.
pub const ROWS: &[Row] = &[
    row("Space", "play, or pause", &[binding(Key::Space, Action::Play)]),
    row(
        "w → .",
        "next frame (hold it to go on)",
        &[step(Key::W, 1), step(Key::Right, 1), step(Key::Period, 1)],
    ),
    row("← ,", "frame before", &[step(Key::Left, -1), step(Key::Comma, -1)]),
    row(
        "Shift → ←",
        "ten frames at once",
        &[
            leap(Key::W, 10),
            leap(Key::Right, 10),
            leap(Key::Period, 10),
            leap(Key::Left, -10),
            leap(Key::Comma, -10),
        ],
    ),
    row(
        "Home End",
        "first frame, last frame",
        &[binding(Key::Home, Action::First), binding(Key::End, Action::Last)],
    ),
    row("r", "play in the other direction", &[binding(Key::R, Action::Reverse)]),
    row(
        "- =",
        "slower, faster: from 0.1× to 4×",
        &[
            binding(Key::Minus, Action::Slower),
            binding(Key::NumPadMinus, Action::Slower),
            binding(Key::Equal, Action::Faster),
            binding(Key::NumPadPlus, Action::Faster),
        ],
    ),
    row(
        "[ ]",
        "play, or warp, from here, up to here (again: all)",
        &[binding(Key::LeftBracket, Action::RangeStart), binding(Key::RightBracket, Action::RangeEnd)],
    ),
    row("o", "begin again at the end, or stop there", &[binding(Key::O, Action::Loop)]),
    row("i", "interpolate: Euler angles, quaternions, off", &[binding(Key::I, Action::Interpolate)]),
    row("k", "choose keyframes automatically, or not", &[binding(Key::K, Action::Automatic)]),
    row(
        "↑ ↓",
        "more keyframes, fewer (Shift: ten); new frames (Shift: one)",
        &[keyframes(Key::Up, 1), keyframes(Key::Down, -1), tenfold(Key::Up, 10), tenfold(Key::Down, -10)],
    ),
    row("b", "the original over the figure, or beside it", &[binding(Key::B, Action::Beside)]),
    row("e", "show or hide error vectors", &[binding(Key::E, Action::Errors)]),
    row("p", "show or hide the plot of errors, or of a warp", &[binding(Key::P, Action::Plot)]),
    row("f", "bring everything into the picture", &[binding(Key::F, Action::Frame)]),
    row("c", "move along with the figure, or stay", &[binding(Key::C, Action::Follow)]),
    row(
        "Tab",
        "look at the next joint (Shift: back)",
        &[
            Binding { shift: Some(false), repeats: true, ..binding(Key::Tab, Action::NextJoint) },
            Binding { shift: Some(true), repeats: true, ..binding(Key::Tab, Action::PreviousJoint) },
        ],
    ),
    row("Backspace", "look at no joint any more", &[binding(Key::Backspace, Action::NoJoint)]),
    row("g", "show or hide the goal, or the original", &[binding(Key::G, Action::Ghost)]),
    row("a", "show or hide the joints' axes", &[binding(Key::A, Action::Axes)]),
    row("t", "show or hide the traces of the tips", &[binding(Key::T, Action::Traces)]),
    row("l", "bodies in the light, or plain lines", &[binding(Key::L, Action::Look)]),
    row("s", "show or hide your points", &[binding(Key::S, Action::Points)]),
    row("m", "of several motions: one by itself, or all", &[binding(Key::M, Action::NextMotion)]),
    row("h F1", "show or hide this help", &[binding(Key::H, Action::Help), binding(Key::F1, Action::Help)]),
    row("Esc", "close the window", &[binding(Key::Escape, Action::Quit)]),
];

/// What the mouse does: its name and its effect, for people.
const MOUSE: [(&str, &str); 5] = [
    ("drag", "look from another side"),
    ("right drag", "move the picture (or Shift and drag)"),
    ("wheel", "closer or farther away"),
    ("click", "look at a joint"),
    ("bar below", "drag it to go to a frame"),
];

/// Keys and mouse, name and effect for people: what the help in the window, `--help` and the book say.
pub fn help() -> impl Iterator<Item = (&'static str, &'static str)> {
    ROWS.iter().map(|row| (row.name, row.help)).chain(MOUSE)
}

/// What belongs to a key, with or without Shift.
pub fn of_key(key: Key, shift: bool) -> Option<&'static Binding> {
    let fits = |binding: &&Binding| binding.key == key && binding.shift.is_none_or(|wanted| wanted == shift);
    ROWS.iter().flat_map(|row| row.bindings).find(fits)
}

/// The key that a character stands on where keyboards differ: on many there is no key that has it by itself.
pub fn of_character(character: char) -> Option<Key> {
    match character {
        '[' => Some(Key::LeftBracket),
        ']' => Some(Key::RightBracket),
        '-' => Some(Key::Minus),
        '=' | '+' => Some(Key::Equal),
        '.' => Some(Key::Period),
        ',' => Some(Key::Comma),
        _ => None,
    }
}

const fn row(name: &'static str, help: &'static str, bindings: &'static [Binding]) -> Row {
    Row { name, help, bindings }
}

const fn binding(key: Key, action: Action) -> Binding {
    Binding { key, shift: None, action, repeats: false }
}

const fn step(key: Key, frames: isize) -> Binding {
    Binding { shift: Some(false), repeats: true, ..binding(key, Action::Step(frames)) }
}

const fn leap(key: Key, frames: isize) -> Binding {
    Binding { shift: Some(true), ..step(key, frames) }
}

const fn keyframes(key: Key, by: isize) -> Binding {
    Binding { shift: Some(false), repeats: true, ..binding(key, Action::Keyframes(by)) }
}

const fn tenfold(key: Key, by: isize) -> Binding {
    Binding { shift: Some(true), ..keyframes(key, by) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_has_two_meanings_and_every_key_has_words() {
        let bindings: Vec<&Binding> = ROWS.iter().flat_map(|row| row.bindings).collect();
        for (i, a) in bindings.iter().enumerate() {
            for b in &bindings[i + 1..] {
                let both = a.shift.is_none() || b.shift.is_none() || a.shift == b.shift;
                assert!(!both || a.key != b.key, "{a:?} and {b:?}");
            }
        }
        for (i, a) in ROWS.iter().enumerate() {
            assert!(!a.name.is_empty() && !a.help.is_empty() && !a.bindings.is_empty());
            assert!(ROWS[i + 1..].iter().all(|b| a.name != b.name && a.help != b.help));
        }
    }

    #[test]
    fn every_character_leads_to_a_key_that_does_something() {
        let characters = ('\0'..'\u{2000}').filter_map(of_character);
        assert_eq!(characters.inspect(|key| assert!(of_key(*key, false).is_some(), "{key:?}")).count(), 7);
    }
}
