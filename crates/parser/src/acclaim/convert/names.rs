//! Names of joints as names of bones.

use std::collections::HashMap;

use skeleton::acclaim::Skeleton;

/// Gives each bone a name of its own.
#[derive(Default)]
pub(super) struct Names {
    /// The names given so far, in lower case, and the number to be put next behind each. It only grows: a number that is
    /// taken is met once, however many joints have one name.
    given: HashMap<String, usize>,
}

impl Names {
    /// A name for a bone like that of the joint: one word, and other than all before.
    pub fn give(&mut self, joint: &str) -> String {
        let word = word(joint);
        let key = word.to_ascii_lowercase();
        let Some(&first) = self.given.get(&key) else {
            self.given.insert(key, 2);
            return word;
        };
        let mut number = first;
        let name = loop {
            let name = format!("{word}_{number}");
            number += 1;
            if !self.given.contains_key(&name.to_ascii_lowercase()) {
                break name;
            }
        };
        self.given.insert(key, number);
        self.given.insert(name.to_ascii_lowercase(), 2);
        name
    }
}

/// `joint` as one word that can be a bone's name.
fn word(joint: &str) -> String {
    /// Shorter than the longest name, so that a number can be put behind.
    const LONGEST: usize = 4000;
    let end = (0..=joint.len().min(LONGEST)).rev().find(|&end| joint.is_char_boundary(end)).unwrap_or(0);
    let is_blank = |c: char| c.is_ascii_whitespace() || c == '\x0b';
    let word = joint[..end].replace(is_blank, "_");
    if Skeleton::accepts_name(&word) { word } else { format!("_{word}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_and_differ() {
        let mut names = Names::default();
        for (joint, bone) in [
            ("LeftUpLeg", "LeftUpLeg"),
            ("leftupleg", "leftupleg_2"),
            ("LeftUpLeg_2", "LeftUpLeg_2_2"),
            ("LeftUpLeg", "LeftUpLeg_3"),
            ("Left Up\tLeg", "Left_Up_Leg"),
            ("root", "_root"),
            ("End", "_End"),
            (":a", "_:a"),
            ("#", "_#"),
            ("", "_"),
            ("Hüfte 腰", "Hüfte_腰"),
        ] {
            assert_eq!(names.give(joint), bone);
        }
        let long = names.give(&"ü".repeat(5000));
        assert!(Skeleton::accepts_name(&long) && Skeleton::accepts_name(&names.give(&long)));
    }

    /// If every number were tried again for every joint, the second half would take hours.
    #[test]
    fn many_joints_of_one_name_are_named_in_time() {
        const COUNT: usize = 200_000;
        let mut names = Names::default();
        let last = (0..COUNT).map(|_| names.give("a")).last();
        assert_eq!(last.as_deref(), Some("a_200000"));

        let mut names = Names::default();
        for number in 2..=COUNT {
            let name = format!("a_{number}");
            assert_eq!(names.give(&name), name);
        }
        let last = (0..COUNT).map(|_| names.give("a")).last();
        assert_eq!(last.as_deref(), Some("a_399999"));
    }
}
