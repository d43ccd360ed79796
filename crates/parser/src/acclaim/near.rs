//! Names that may have been meant.

/// How many bones are looked at, and how much of a name: enough for any figure, and little enough for any file.
const MOST_NAMES: usize = 1000;
const LONGEST: usize = 64;

/// Those of `names` that differ from `word` in few letters, as ` (…)`: at most three, the nearest first. Nothing, if
/// there are none.
pub(super) fn near<'a>(word: &str, names: impl Iterator<Item = &'a str>) -> String {
    let word = letters(word);
    let allowed = 1 + word.len() / 5;
    let mut found: Vec<(usize, &str)> = names
        .take(MOST_NAMES)
        .map(|name| (distance(&word, &letters(name)), name))
        .filter(|(distance, _)| *distance <= allowed)
        .collect();
    found.sort_by_key(|(distance, _)| *distance);
    found.truncate(3);
    let quoted: Vec<String> = found
        .iter()
        .map(|(_, name)| format!("`{}`", crate::snippet::printable_start(name.as_bytes())))
        .collect();
    match &quoted[..] {
        [] => String::new(),
        [one] => format!(" (is {one} meant?)"),
        [first @ .., last] => format!(" (is {} or {last} meant?)", first.join(", ")),
    }
}

fn letters(word: &str) -> Vec<char> {
    word.chars().take(LONGEST).flat_map(char::to_lowercase).collect()
}

/// How many letters have to be put in, taken out or replaced to turn one word into the other (Levenshtein's distance).
fn distance(one: &[char], other: &[char]) -> usize {
    // The distances from the beginning of `one` looked at so far to every beginning of `other`.
    let mut distances: Vec<usize> = (0..=other.len()).collect();
    for (i, a) in one.iter().enumerate() {
        let mut diagonal = std::mem::replace(&mut distances[0], i + 1);
        for (j, b) in other.iter().enumerate() {
            let replaced = diagonal + usize::from(a != b);
            diagonal = distances[j + 1];
            distances[j + 1] = replaced.min(distances[j] + 1).min(diagonal + 1);
        }
    }
    distances[other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 6] = ["pelvis", "lfoot", "rfoot", "ltoes", "LeftUpLeg", "head"];

    #[test]
    fn the_nearest_name_comes_first() {
        assert_eq!(near("lfot", NAMES.into_iter()), " (is `lfoot` meant?)");
        assert_eq!(near("rfoot1", NAMES.into_iter()), " (is `rfoot` or `lfoot` meant?)");
        assert_eq!(near("left_up_leg", NAMES.into_iter()), " (is `LeftUpLeg` meant?)");
        assert_eq!(near("thumb", NAMES.into_iter()), "");
    }

    #[test]
    fn distances_are_counted_in_letters() {
        let between = |one: &str, other: &str| distance(&letters(one), &letters(other));
        assert_eq!(between("kitten", "sitting"), 3);
        assert_eq!(between("", "abc"), 3);
        assert_eq!(between("Fuß", "fus"), 1);
        assert_eq!(between("abc", "ABC"), 0);
    }

    #[test]
    fn endless_words_and_lists_are_looked_at_only_so_far() {
        let long = "x".repeat(1_000_000);
        let names = std::iter::repeat_n(long.as_str(), 100_000);
        assert!(near(&long, names).starts_with(" (is `xxxx"));
    }
}
