//! The keys: one table for what they do, for the help in the window and for `--help`.

use minifb::Key;

/// Something that a key makes happen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Go to the next frame.
    Next,
    /// Go to the frame before.
    Previous,
    /// Go to frame 0.
    First,
    /// Play or pause.
    Play,
    /// Move the camera so that everything is in the picture.
    Frame,
    /// Show or hide the goal.
    Ghost,
    /// Show or hide the joints' axes.
    Axes,
    /// Show or hide the help.
    Help,
    /// Close the window.
    Quit,
}

/// A key and what it does.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// The key.
    pub key: Key,
    /// Whether Shift is held with it.
    pub shift: bool,
    /// What happens.
    pub action: Action,
    /// Whether it happens again and again while the key is held.
    pub repeats: bool,
    /// The key's name for people.
    pub name: &'static str,
    /// What happens, for people.
    pub help: &'static str,
}

/// All keys, in the order of the help.
pub const BINDINGS: [Binding; 9] = [
    binding(Key::W, "w", Action::Next, "next frame (hold it to go on)").repeating(),
    binding(Key::W, "Shift w", Action::Previous, "frame before").repeating().with_shift(),
    binding(Key::Space, "Space", Action::Play, "play at the file's own speed, or pause"),
    binding(Key::Home, "Home", Action::First, "back to frame 0"),
    binding(Key::F, "f", Action::Frame, "bring everything into the picture"),
    binding(Key::G, "g", Action::Ghost, "show or hide the goal"),
    binding(Key::A, "a", Action::Axes, "show or hide the joints' axes"),
    binding(Key::H, "h", Action::Help, "show or hide this help"),
    binding(Key::Escape, "Esc", Action::Quit, "close the window"),
];

/// What the mouse does: its name and its effect, for people.
const MOUSE: [(&str, &str); 2] = [("drag", "look from another side"), ("wheel", "closer or farther away")];

/// Keys and mouse, name and effect for people: what the help in the window, `--help` and the book say.
pub fn help() -> impl Iterator<Item = (&'static str, &'static str)> {
    BINDINGS.iter().map(|binding| (binding.name, binding.help)).chain(MOUSE)
}

const fn binding(key: Key, name: &'static str, action: Action, help: &'static str) -> Binding {
    Binding { key, shift: false, action, repeats: false, name, help }
}

impl Binding {
    const fn repeating(self) -> Binding {
        Binding { repeats: true, ..self }
    }

    const fn with_shift(self) -> Binding {
        Binding { shift: true, ..self }
    }
}

/// Turns key events into actions. Events come in the order in which they happened, so that even the shortest tap
/// counts; a key that is held sends its event again and again, as often as the system says.
#[derive(Debug, Default)]
pub struct Keyboard {
    held: Vec<Key>,
}

impl Keyboard {
    /// What the event "`key` is now down" (or up) makes happen, if anything.
    pub fn event(&mut self, key: Key, down: bool) -> Option<Action> {
        let repeated = self.held.contains(&key);
        self.held.retain(|held| *held != key);
        if !down {
            return None;
        }
        self.held.push(key);
        let shift = self.held.contains(&Key::LeftShift) || self.held.contains(&Key::RightShift);
        let fits = |binding: &&Binding| {
            binding.key == key
                && (binding.shift == shift || !uses_shift(key))
                && (binding.repeats || !repeated)
        };
        BINDINGS.iter().find(fits).map(|binding| binding.action)
    }

    /// Forgets which keys are held: the window is no longer told when they are let go.
    pub fn forget(&mut self) {
        self.held.clear();
    }
}

fn uses_shift(key: Key) -> bool {
    BINDINGS.iter().any(|binding| binding.key == key && binding.shift)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_has_two_meanings_and_every_key_has_words() {
        for (i, a) in BINDINGS.iter().enumerate() {
            assert!(!a.name.is_empty() && !a.help.is_empty());
            assert!(BINDINGS[i + 1..].iter().all(|b| (a.key, a.shift) != (b.key, b.shift)));
        }
    }

    #[test]
    fn a_held_key_repeats_only_where_that_is_wanted() {
        let mut keyboard = Keyboard::default();
        assert_eq!(keyboard.event(Key::W, true), Some(Action::Next));
        assert_eq!(keyboard.event(Key::W, true), Some(Action::Next));
        assert_eq!(keyboard.event(Key::W, false), None);
        assert_eq!(keyboard.event(Key::Space, true), Some(Action::Play));
        assert_eq!(keyboard.event(Key::Space, true), None);
        assert_eq!(keyboard.event(Key::Space, false), None);
        assert_eq!(keyboard.event(Key::Space, true), Some(Action::Play));
        assert_eq!(keyboard.event(Key::Q, true), None);
    }

    #[test]
    fn shift_matters_for_keys_that_use_it() {
        let mut keyboard = Keyboard::default();
        keyboard.event(Key::RightShift, true);
        assert_eq!(keyboard.event(Key::W, true), Some(Action::Previous));
        assert_eq!(keyboard.event(Key::F, true), Some(Action::Frame));
        keyboard.event(Key::RightShift, false);
        assert_eq!(keyboard.event(Key::W, true), Some(Action::Next));
    }

    #[test]
    fn a_key_let_go_elsewhere_works_again_afterwards() {
        let mut keyboard = Keyboard::default();
        keyboard.event(Key::H, true);
        keyboard.forget();
        assert_eq!(keyboard.event(Key::H, true), Some(Action::Help));
    }
}
