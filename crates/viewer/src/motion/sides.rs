//! Left and right, told by the joints' names.

use std::collections::HashSet;

use skeleton::Joint;

use crate::scene::Side;

/// The side of the body for every joint: by its own name, or else its parent's.
pub fn sides(joints: &[Joint]) -> Vec<Side> {
    let names: HashSet<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
    let mut sides: Vec<Side> = Vec::with_capacity(joints.len());
    for joint in joints {
        let parents = joint.parent.map_or(Side::Middle, |parent| sides[parent.0]);
        let own = || side_of(&joint.name).or_else(|| one_of_a_pair(&joint.name, &names));
        sides.push(if joint.is_end_site { parents } else { own().unwrap_or(parents) });
    }
    sides
}

/// The side of `lfemur` where there is an `rfemur`, and the other way round: the names of bones in many Acclaim files.
fn one_of_a_pair(name: &str, names: &HashSet<&str>) -> Option<Side> {
    let (first, rest) = (name.get(..1)?, name.get(1..)?);
    let (side, other) = match first {
        "l" => (Side::Left, "r"),
        "r" => (Side::Right, "l"),
        _ => return None,
    };
    names.contains(format!("{other}{rest}").as_str()).then_some(side)
}

/// The side that a name tells, in any of the usual spellings: `LeftArm`, `left_arm`, `LArm`, `arm.L`, `Bip01 L Arm`.
fn side_of(name: &str) -> Option<Side> {
    let lower = name.to_lowercase();
    let letters: Vec<char> = name.chars().collect();
    let alone = |letter: char| {
        letters.iter().enumerate().any(|(i, char)| {
            let before = i.checked_sub(1).map(|i| letters[i]);
            let after = letters.get(i + 1);
            char.eq_ignore_ascii_case(&letter)
                && before.is_none_or(|before| !before.is_alphanumeric())
                && match after {
                    None => true,
                    // A word of its own behind it: LArm, and not LUMBAR.
                    Some(after) if after.is_uppercase() => {
                        letters.get(i + 2).is_some_and(|next| next.is_lowercase())
                    }
                    Some(after) => !after.is_alphanumeric(),
                }
        })
    };
    match () {
        () if lower.contains("left") || alone('l') => Some(Side::Left),
        () if lower.contains("right") || alone('r') => Some(Side::Right),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_pairs_tell_sides_by_their_first_letters() {
        let names = HashSet::from(["root", "lfemur", "rfemur", "lowerback", "rib"]);
        let sides = ["lfemur", "rfemur", "lowerback", "rib", "root", "", "ä"];
        let told = sides.map(|name| one_of_a_pair(name, &names));
        assert_eq!(told, [Some(Side::Left), Some(Side::Right), None, None, None, None, None]);
    }

    #[test]
    fn names_tell_sides() {
        for name in
            ["LeftArm", "left_arm", "LArm", "lArm", "arm.L", "Bip01 L Arm", "mixamorig:LeftArm", "hand-l"]
        {
            assert_eq!(side_of(name), Some(Side::Left), "{name}");
        }
        for name in ["RightArm", "rArm", "R", "leg_R"] {
            assert_eq!(side_of(name), Some(Side::Right), "{name}");
        }
        for name in [
            "ROOT",
            "LUMBAR",
            "RIB",
            "LEGS",
            "Hips",
            "Larynx",
            "LowerBack",
            "Neck1",
            "Rib",
            "Head",
            "",
            "Pelvis.001",
        ] {
            assert_eq!(side_of(name), None, "{name}");
        }
    }
}
