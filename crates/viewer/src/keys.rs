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
    /// Play from this frame on.
    RangeStart,
    /// Play up to this frame.
    RangeEnd,
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

/// Keys and what they do.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// Any of these.
    pub keys: &'static [Key],
    /// Whether Shift must be held with it (`Some(true)`), must not be, or does not matter.
    pub shift: Option<bool>,
    /// What happens.
    pub action: Action,
    /// Whether it happens again and again while the key is held.
    pub repeats: bool,
    /// The keys' names for people.
    pub name: &'static str,
    /// What happens, for people.
    pub help: &'static str,
}

const NEXT: &[Key] = &[Key::W, Key::Right, Key::Period];
const PREVIOUS: &[Key] = &[Key::Left, Key::Comma];

/// All keys, in the order of the help.
pub const BINDINGS: [Binding; 25] = [
    binding(&[Key::Space], "Space", Action::Play, "play, or pause"),
    binding(NEXT, "w → .", Action::Step(1), "next frame (hold it to go on)").repeating().shift(false),
    binding(PREVIOUS, "← ,", Action::Step(-1), "frame before").repeating().shift(false),
    binding(NEXT, "Shift →", Action::Step(10), "ten frames further").repeating().shift(true),
    binding(PREVIOUS, "Shift ←", Action::Step(-10), "ten frames back").repeating().shift(true),
    binding(&[Key::Home], "Home", Action::First, "first frame"),
    binding(&[Key::End], "End", Action::Last, "last frame"),
    binding(&[Key::R], "r", Action::Reverse, "play in the other direction"),
    binding(&[Key::Minus, Key::NumPadMinus], "-", Action::Slower, "slower, down to 0.1×"),
    binding(&[Key::Equal, Key::NumPadPlus], "=", Action::Faster, "faster, up to 4×"),
    binding(&[Key::LeftBracket], "[", Action::RangeStart, "play from this frame on (again: from the first)"),
    binding(&[Key::RightBracket], "]", Action::RangeEnd, "play up to this frame (again: to the last)"),
    binding(&[Key::O], "o", Action::Loop, "begin again at the end, or stop there"),
    binding(&[Key::F], "f", Action::Frame, "bring everything into the picture"),
    binding(&[Key::C], "c", Action::Follow, "move along with the figure, or stay"),
    binding(&[Key::Tab], "Tab", Action::NextJoint, "look at the next joint").repeating().shift(false),
    binding(&[Key::Tab], "Shift Tab", Action::PreviousJoint, "look at the joint before")
        .repeating()
        .shift(true),
    binding(&[Key::Backspace], "Backspace", Action::NoJoint, "look at no joint any more"),
    binding(&[Key::G], "g", Action::Ghost, "show or hide the goal"),
    binding(&[Key::A], "a", Action::Axes, "show or hide the joints' axes"),
    binding(&[Key::T], "t", Action::Traces, "show or hide the traces of the tips"),
    binding(&[Key::L], "l", Action::Look, "bodies in the light, or plain lines"),
    binding(&[Key::S], "s", Action::Points, "show or hide your points"),
    binding(&[Key::H, Key::F1], "h F1", Action::Help, "show or hide this help"),
    binding(&[Key::Escape], "Esc", Action::Quit, "close the window"),
];

/// What is bound only where several motions are shown.
pub const WITH_SEVERAL_MOTIONS: Binding =
    binding(&[Key::M], "m", Action::NextMotion, "each motion by itself, or all side by side");

/// What the mouse does: its name and its effect, for people.
const MOUSE: [(&str, &str); 4] = [
    ("drag", "look from another side"),
    ("right drag", "move the picture (or Shift and drag)"),
    ("wheel", "closer or farther away"),
    ("bar below", "drag it to go to a frame"),
];

/// Keys that belong to other exercises: interpolation, keyframes, error vectors and their plot.
#[cfg(test)]
const KEPT: [Key; 4] = [Key::I, Key::K, Key::E, Key::P];

/// Keys and mouse, name and effect for people: what the help in the window, `--help` and the book say.
pub fn help() -> impl Iterator<Item = (&'static str, &'static str)> {
    all().map(|binding| (binding.name, binding.help)).chain(MOUSE)
}

fn all() -> impl Iterator<Item = &'static Binding> {
    let (last, others) = (BINDINGS.len() - 2, &BINDINGS);
    others[..last].iter().chain([&WITH_SEVERAL_MOTIONS]).chain(&others[last..])
}

/// What belongs to a key, with or without Shift.
pub fn of_key(key: Key, shift: bool) -> Option<&'static Binding> {
    all().find(|binding| binding.keys.contains(&key) && binding.shift.is_none_or(|wanted| wanted == shift))
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

const fn binding(keys: &'static [Key], name: &'static str, action: Action, help: &'static str) -> Binding {
    Binding { keys, shift: None, action, repeats: false, name, help }
}

impl Binding {
    const fn repeating(self) -> Binding {
        Binding { repeats: true, ..self }
    }

    const fn shift(self, held: bool) -> Binding {
        Binding { shift: Some(held), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_has_two_meanings_and_every_key_has_words() {
        let bindings: Vec<&Binding> = all().collect();
        assert_eq!(bindings.len(), BINDINGS.len() + 1);
        for (i, a) in bindings.iter().enumerate() {
            assert!(!a.name.is_empty() && !a.help.is_empty() && !a.keys.is_empty());
            for b in &bindings[i + 1..] {
                let both = a.shift.is_none() || b.shift.is_none() || a.shift == b.shift;
                assert!(!both || a.keys.iter().all(|key| !b.keys.contains(key)), "{} and {}", a.name, b.name);
                assert!(a.name != b.name && a.help != b.help && a.action != b.action);
            }
        }
    }

    #[test]
    fn keys_of_other_exercises_are_free() {
        for key in KEPT {
            assert!([false, true].iter().all(|shift| of_key(key, *shift).is_none()), "{key:?}");
        }
    }

    #[test]
    fn every_character_leads_to_a_key_that_does_something() {
        for character in ('\0'..'\u{2000}').filter(|character| of_character(*character).is_some()) {
            let key = of_character(character).unwrap();
            assert!(of_key(key, false).is_some(), "{character}");
        }
    }
}
