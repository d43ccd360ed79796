//! Ways to spoil a text.

use proptest::prelude::*;
use proptest::sample::Index;

/// One way to spoil a text.
#[derive(Clone, Debug)]
pub enum Damage {
    Flip(Index, u8),
    Truncate(Index),
    RemoveLine(Index),
    RepeatLine(Index),
    RemoveWord(Index),
    RepeatWord(Index),
    Insert(Index, &'static [u8]),
}

/// Any of them; what is put in is some of `junk`.
pub fn any_damage(junk: &'static [&'static [u8]]) -> impl Strategy<Value = Damage> {
    let place = any::<Index>;
    prop_oneof![
        (place(), any::<u8>()).prop_map(|(at, bits)| Damage::Flip(at, bits)),
        place().prop_map(Damage::Truncate),
        place().prop_map(Damage::RemoveLine),
        place().prop_map(Damage::RepeatLine),
        place().prop_map(Damage::RemoveWord),
        place().prop_map(Damage::RepeatWord),
        (place(), prop::sample::select(junk)).prop_map(|(at, junk)| Damage::Insert(at, junk)),
    ]
}

impl Damage {
    /// Spoils `text`.
    pub fn apply(&self, text: &mut Vec<u8>) {
        if text.is_empty() {
            return;
        }
        match self {
            Damage::Flip(at, bits) => *at.get_mut(text) ^= bits,
            Damage::Truncate(at) => text.truncate(at.index(text.len())),
            Damage::Insert(at, junk) => {
                let at = at.index(text.len());
                text.splice(at..at, junk.iter().copied());
            }
            Damage::RemoveLine(at) => *text = edit(text, b'\n', at.index(text.len()), 0),
            Damage::RepeatLine(at) => *text = edit(text, b'\n', at.index(text.len()), 2),
            Damage::RemoveWord(at) => *text = edit(text, b' ', at.index(text.len()), 0),
            Damage::RepeatWord(at) => *text = edit(text, b' ', at.index(text.len()), 2),
        }
    }
}

/// The text with the piece around byte `at`, between two `end`s, as often as said.
fn edit(text: &[u8], end: u8, at: usize, times: usize) -> Vec<u8> {
    let start = text[..at].iter().rposition(|&byte| byte == end).map_or(0, |last| last + 1);
    let stop = text[at..].iter().position(|&byte| byte == end).map_or(text.len(), |next| at + next + 1);
    [&text[..start], &text[start..stop].repeat(times), &text[stop..]].concat()
}
