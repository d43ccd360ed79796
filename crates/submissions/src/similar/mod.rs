//! Which submissions are more alike than chance explains.
//!
//! This points a person to submissions that are worth comparing. It proves nothing: right solutions of short functions look alike,
//! and the template makes them more so.
//!
//! # Three degrees
//!
//! - [`Likeness::SameText`]: the same tokens, names and comments included, whatever the spaces.
//! - [`Likeness::SameButNames`]: the same tokens but for comments and the names that the student gave.
//! - [`Likeness::Partly`]: of the telling passages of the shorter one, at least so many percent are in the other one too.
//!
//! # What counts
//!
//! A passage is a run of [`PASSAGE`] tokens, in which all names that the student gave are one and the same. Names behind `.` and
//! `::` or before `::` are not the student's to choose, and stay. From every [`WINDOW`] passages in a row one is kept, the same
//! one wherever they stand (Schleimer, Wilkerson, Aiken: Winnowing, SIGMOD 2003): a copied stretch of `PASSAGE + WINDOW - 1`
//! tokens is never missed. Passages of the template do not count. Submissions with fewer than [`FEWEST`] passages of their own are
//! not compared: they have hardly begun.
//!
//! A passage is telling if few submissions have it: at most one in twenty, but three may always, and more than thirty never.
//! What many write is how one writes it. Submissions that are the same but for names count as one here, so that a copy makes
//! nothing common. With fewer than [`FEWEST`] telling passages in common, two submissions are not called alike, unless they are the
//! same text. Among fewer than [`CROWD`] submissions nobody can say what is usual: only whole texts are compared.

mod index;
mod tokens;

use std::collections::BTreeMap;

use index::Index;
use tokens::{tokens, without_names};

/// The length of a passage, in tokens.
pub const PASSAGE: usize = 12;

/// One of so many passages in a row is kept.
pub const WINDOW: usize = 4;

/// Fewer passages than these tell nothing.
pub const FEWEST: usize = 24;

/// Among fewer submissions than these nobody can say what is usual, and [`Likeness::Partly`] is not looked for.
pub const CROWD: usize = 40;

/// A share of telling passages in common from which on it is worth comparing two submissions, in percent.
pub const THRESHOLD: u8 = 60;

/// No source holds more passages than are kept of it; of more, the same ones are left out everywhere.
const MAX_KEPT: usize = 4096;

/// What is kept of a text to compare it with others.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Fingerprint {
    /// Of all tokens, names and comments included.
    text: u64,
    /// Of the tokens without comments and names.
    shape: u64,
    /// Of passages, in rising order.
    passages: Vec<u64>,
}

/// How alike submissions are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Likeness {
    /// The same but for spaces.
    SameText,
    /// The same but for names and comments.
    SameButNames,
    /// Telling passages in common.
    Partly,
}

/// Submissions that are worth comparing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// How alike they are.
    pub likeness: Likeness,
    /// Their ids, in rising order.
    pub ids: Vec<String>,
    /// How many percent of the telling passages are in common; 100 but for [`Likeness::Partly`]. Of more than two submissions, each is so
    /// much like at least one other.
    pub percent: u8,
    /// How many passages are in common that few others have. Zero, which only [`Likeness::SameText`] can have, means that everything
    /// in it is also in other submissions, or in the template.
    pub telling: usize,
}

/// The fingerprint of a source text. Any text has one.
pub fn fingerprint(text: &str) -> Fingerprint {
    let tokens = tokens(text);
    let words = |token: &tokens::Token<'_>| hash(token.text.split_whitespace().flat_map(str::bytes));
    let all: Vec<u64> = tokens.iter().map(words).collect();
    let shape: Vec<u64> = without_names(&tokens).map(|text| hash(text.bytes())).collect();
    Fingerprint { text: hash_all(&all), shape: hash_all(&shape), passages: winnow(&shape) }
}

/// Groups of submissions that are alike, the most alike first. A submission can be in several.
///
/// `submissions` are ids and fingerprints, `template` the fingerprint of what everyone was given, `threshold` in percent is for
/// [`Likeness::Partly`]. The time grows with the number of submissions, not with its square.
pub fn similar(submissions: &[(&str, &Fingerprint)], template: &Fingerprint, threshold: u8) -> Vec<Group> {
    let classes = classes(submissions, template);
    let index = Index::new(&classes);
    let mut groups = Vec::new();
    for (class, telling) in classes.iter().zip(&index.telling) {
        let mut texts: BTreeMap<u64, Vec<String>> = BTreeMap::new();
        for (id, print) in &class.members {
            texts.entry(print.text).or_default().push((*id).to_owned());
        }
        let is_one_text = texts.len() == 1;
        let same_text = texts.into_values().filter(|ids| ids.len() > 1);
        groups.extend(same_text.map(|ids| Group {
            likeness: Likeness::SameText,
            ids,
            percent: 100,
            telling: *telling,
        }));
        if !is_one_text && *telling >= FEWEST {
            let ids = class.ids().collect();
            groups.push(Group { likeness: Likeness::SameButNames, ids, percent: 100, telling: *telling });
        }
    }
    if classes.len() >= CROWD {
        groups.extend(index.partly(&classes, threshold));
    }
    for group in &mut groups {
        group.ids.sort();
    }
    groups.sort_by(|a, b| (a.likeness, &a.ids).cmp(&(b.likeness, &b.ids)));
    groups
}

/// Submissions that are the same but for names.
struct Class<'a> {
    members: Vec<(&'a str, &'a Fingerprint)>,
    /// Passages that the template does not have, in rising order.
    own: Vec<u64>,
}

impl Class<'_> {
    fn ids(&self) -> impl Iterator<Item = String> {
        self.members.iter().map(|(id, _)| (*id).to_owned())
    }
}

fn classes<'a>(submissions: &[(&'a str, &'a Fingerprint)], template: &Fingerprint) -> Vec<Class<'a>> {
    let mut by_shape: BTreeMap<u64, Class<'a>> = BTreeMap::new();
    for (id, print) in submissions {
        let own = || {
            let is_own = |passage: &u64| template.passages.binary_search(passage).is_err();
            print.passages.iter().copied().filter(is_own).collect()
        };
        let class = by_shape.entry(print.shape).or_insert_with(|| Class { members: Vec::new(), own: own() });
        class.members.push((id, print));
    }
    by_shape.into_values().filter(|class| class.own.len() >= FEWEST).collect()
}

/// The smallest hash of each window of passages, the last one of equals, sorted, each once.
fn winnow(tokens: &[u64]) -> Vec<u64> {
    let passages: Vec<u64> = tokens.windows(PASSAGE).map(hash_all).collect();
    let mut kept: Vec<u64> = if passages.len() < WINDOW {
        passages.iter().copied().min().into_iter().collect()
    } else {
        passages.windows(WINDOW).filter_map(|window| window.iter().copied().min()).collect()
    };
    kept.sort_unstable();
    kept.dedup();
    // The smallest ones: which ones these are depends on the passages alone.
    kept.truncate(MAX_KEPT);
    kept
}

/// FNV-1a. It stays the same for ever, and nothing depends on that nobody finds two texts of one hash.
fn hash(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Mixes the bits after each step (as SplitMix64 does), so that the smallest of several hashes is any of them.
fn hash_all(hashes: &[u64]) -> u64 {
    hashes.iter().fold(0, |all, one| {
        let mixed = (all ^ one).wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    })
}
