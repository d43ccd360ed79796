//! Names of joints as names of bones.

use std::collections::HashMap;

use skeleton::acclaim::Skeleton;

/// The names given so far, in lower case, and by how many they have been asked for.
#[derive(Default)]
pub(super) struct Names {
    given: HashMap<String, usize>,
}

impl Names {
    /// A name for a bone like that of the joint: one word, and other than all before.
    pub fn give(&mut self, joint: &str) -> String {
        let mut name = word(joint);
        loop {
            let count = self.given.entry(name.to_ascii_lowercase()).or_default();
            *count += 1;
            match *count {
                1 => return name,
                count => name = format!("{}_{count}", word(joint)),
            }
        }
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

    #[test]
    fn many_joints_of_one_name_are_named_in_time() {
        let mut names = Names::default();
        let last = (0..200_000).map(|_| names.give("a")).last();
        assert_eq!(last.as_deref(), Some("a_200000"));
    }
}
