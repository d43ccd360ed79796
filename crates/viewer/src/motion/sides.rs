//! Left and right, told by the joints' names.

use skeleton::Joint;

use crate::scene::Side;

/// The side of the body for every joint: by its own name, or else its parent's.
pub fn sides(joints: &[Joint]) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::with_capacity(joints.len());
    for joint in joints {
        let parents = joint.parent.map_or(Side::Middle, |parent| sides[parent.0]);
        sides.push(if joint.is_end_site { parents } else { side_of(&joint.name).unwrap_or(parents) });
    }
    sides
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
