//! From what happens on the keyboard to what is to be done.
//!
//! Events come in the order in which they happened, so that even the shortest tap counts. How often a system repeats a
//! held key differs from one to the next: its repeats are passed over, and held keys repeat by a clock of our own.

use std::time::Duration;

use minifb::Key;

use crate::window::keys::{self, Action};

/// How long a key is held before it repeats, and how much time lies between two repeats.
const DELAY: Duration = Duration::from_millis(350);
const INTERVAL: Duration = Duration::from_millis(40);

/// The most repeats at once: after a pause of the whole system nobody wants to have all of them.
const MOST_REPEATS: u32 = 5;

/// Something that happened on the keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// A key is down now, or the system says again that it is.
    Down(Key),
    /// A key was let go.
    Up(Key),
    /// A character was typed. It comes behind the event of its key, if that key is known at all.
    Typed(char),
}

/// The state of the keyboard.
#[derive(Debug, Default)]
pub struct Keyboard {
    held: Vec<Key>,
    /// What the last key event has to say about the character behind it.
    last: Last,
    repeating: Option<Repeating>,
}

/// What is known of the last key event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Last {
    /// Nothing: the character that follows comes from a key that is not known.
    #[default]
    Unknown,
    /// The key has no meaning of its own: the character on it may have one.
    Open,
    /// The key had a meaning, or the system repeats it.
    Done,
}

/// A key that is held.
#[derive(Clone, Copy, Debug)]
struct Repeating {
    key: Key,
    action: Action,
    /// Until it happens again.
    left: Duration,
}

impl Keyboard {
    /// What an event makes happen, if anything.
    pub fn event(&mut self, event: Event) -> Option<Action> {
        match event {
            Event::Down(key) => {
                let again = self.held.contains(&key);
                if !again {
                    self.held.push(key);
                }
                let binding = keys::of_key(key, self.shift()).filter(|_| !self.commands());
                self.last = if again || binding.is_some() { Last::Done } else { Last::Open };
                if again {
                    return None;
                }
                let binding = binding?;
                self.repeating =
                    binding.repeats.then_some(Repeating { key, action: binding.action, left: DELAY });
                Some(binding.action)
            }
            Event::Up(key) => {
                self.held.retain(|held| *held != key);
                if self.repeating.is_some_and(|repeating| repeating.key == key) {
                    self.repeating = None;
                }
                None
            }
            Event::Typed(character) => {
                if std::mem::take(&mut self.last) == Last::Done || self.commands() {
                    return None;
                }
                keys::of_key(keys::of_character(character)?, false).map(|binding| binding.action)
            }
        }
    }

    /// Lets time pass: what a held key makes happen in it, and how many times.
    pub fn pass(&mut self, time: Duration) -> Option<(Action, u32)> {
        let repeating = self.repeating.as_mut()?;
        if time < repeating.left {
            repeating.left -= time;
            return None;
        }
        let over = (time - repeating.left).as_nanos();
        let more = u32::try_from(over / INTERVAL.as_nanos()).unwrap_or(u32::MAX);
        repeating.left = INTERVAL - Duration::from_nanos((over % INTERVAL.as_nanos()) as u64);
        Some((repeating.action, more.saturating_add(1).min(MOST_REPEATS)))
    }

    /// Whether Shift is held.
    pub fn shift(&self) -> bool {
        self.held.contains(&Key::LeftShift) || self.held.contains(&Key::RightShift)
    }

    /// Whether keys that are pressed now are meant for the system, or for another program: Ctrl S is no S. The Alt key on
    /// the right makes characters.
    fn commands(&self) -> bool {
        [Key::LeftCtrl, Key::LeftAlt, Key::LeftSuper, Key::RightSuper]
            .iter()
            .any(|key| self.held.contains(key))
    }

    /// Forgets which keys are held: the window is no longer told when they are let go.
    pub fn forget(&mut self) {
        self.held.clear();
        self.repeating = None;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn down(keyboard: &mut Keyboard, key: Key) -> Option<Action> {
        keyboard.event(Event::Down(key))
    }

    #[test]
    fn every_tap_counts_and_the_systems_repeats_do_not() {
        let mut keyboard = Keyboard::default();
        for _ in 0..20 {
            assert_eq!(down(&mut keyboard, Key::W), Some(Action::Step(1)));
            assert_eq!(down(&mut keyboard, Key::W), None, "the system repeats");
            assert_eq!(keyboard.event(Event::Up(Key::W)), None);
        }
        assert_eq!(down(&mut keyboard, Key::Q), None);
    }

    #[test]
    fn a_held_key_repeats_by_our_own_clock_only_where_that_is_wanted() {
        let mut keyboard = Keyboard::default();
        down(&mut keyboard, Key::Right);
        assert_eq!(keyboard.pass(DELAY - Duration::from_millis(1)), None);
        assert_eq!(keyboard.pass(Duration::from_millis(1)), Some((Action::Step(1), 1)));
        assert_eq!(keyboard.pass(INTERVAL * 2), Some((Action::Step(1), 2)));
        assert_eq!(keyboard.pass(Duration::from_secs(3600)), Some((Action::Step(1), MOST_REPEATS)));
        down(&mut keyboard, Key::Space);
        assert_eq!(
            keyboard.pass(Duration::from_secs(9)),
            None,
            "the last key counts, and it does not repeat"
        );
        down(&mut keyboard, Key::Left);
        keyboard.event(Event::Up(Key::Left));
        assert_eq!(keyboard.pass(Duration::from_secs(9)), None);
    }

    #[test]
    fn shift_matters_for_keys_that_use_it() {
        let mut keyboard = Keyboard::default();
        down(&mut keyboard, Key::RightShift);
        assert_eq!(down(&mut keyboard, Key::Left), Some(Action::Step(-10)));
        assert_eq!(down(&mut keyboard, Key::F), Some(Action::Frame));
        keyboard.event(Event::Up(Key::RightShift));
        assert_eq!(down(&mut keyboard, Key::Comma), Some(Action::Step(-1)));
    }

    #[test]
    fn characters_count_where_their_key_is_another_one() {
        let mut keyboard = Keyboard::default();
        // A keyboard with [ on the key of 8.
        down(&mut keyboard, Key::Key8);
        assert_eq!(keyboard.event(Event::Typed('[')), Some(Action::RangeStart));
        // One with [ on a key of its own.
        assert_eq!(down(&mut keyboard, Key::LeftBracket), Some(Action::RangeStart));
        assert_eq!(keyboard.event(Event::Typed('[')), None, "once is enough");
        // One with + on a key that is not known.
        assert_eq!(keyboard.event(Event::Typed('+')), Some(Action::Faster));
        assert_eq!(keyboard.event(Event::Typed('x')), None);
        // The system repeats the key, and so its character.
        down(&mut keyboard, Key::Key8);
        assert_eq!(keyboard.event(Event::Typed('[')), None);
    }

    #[test]
    fn what_is_meant_for_other_programs_is_left_to_them() {
        let mut keyboard = Keyboard::default();
        down(&mut keyboard, Key::LeftCtrl);
        assert_eq!(down(&mut keyboard, Key::S), None);
        assert_eq!(keyboard.event(Event::Typed('-')), None);
        keyboard.event(Event::Up(Key::LeftCtrl));
        keyboard.event(Event::Up(Key::S));
        assert_eq!(down(&mut keyboard, Key::S), Some(Action::Points));
    }

    #[test]
    fn a_key_let_go_elsewhere_works_again_afterwards() {
        let mut keyboard = Keyboard::default();
        down(&mut keyboard, Key::W);
        keyboard.forget();
        assert_eq!(keyboard.pass(Duration::from_secs(9)), None);
        assert_eq!(down(&mut keyboard, Key::W), Some(Action::Step(1)));
    }

    proptest! {
        #[test]
        fn as_many_repeats_come_whatever_the_display(steps in prop::collection::vec(1u64..60, 1..300)) {
            let mut keyboard = Keyboard::default();
            down(&mut keyboard, Key::W);
            let mut count = 0;
            for step in &steps {
                count += keyboard.pass(Duration::from_millis(*step)).map_or(0, |(_, times)| times);
            }
            let passed = Duration::from_millis(steps.iter().sum());
            // Never more than five at once, and with these steps there never are.
            let expected = passed.checked_sub(DELAY).map_or(0, |over| 1 + over.as_millis() / INTERVAL.as_millis());
            prop_assert_eq!(u128::from(count), expected);
        }
    }
}
