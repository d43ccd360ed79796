//! How thick bones are, so that a lit figure looks like a body.
//!
//! In a body of arms, legs and a trunk, names tell what a bone is, and its thickness goes by the body's height. In
//! anything else, and for bones whose names say nothing, it goes by the bone's own length.

use glam::Vec3;
use skeleton::{Joint, Skeleton};

/// The part of a body that a bone is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Trunk,
    Chest,
    Hip,
    Thigh,
    Shin,
    Foot,
    Toe,
    Collar,
    UpperArm,
    Forearm,
    Palm,
    Finger,
    Neck,
    Head,
    Unknown,
}

impl Part {
    /// What usual names of joints say. The first that fits counts: `forearm` contains `arm`.
    const WORDS: [(Part, &'static [&'static str]); 13] = [
        (Part::Finger, &["finger", "thumb", "metacarpal", "pinky", "handindex", "handmiddle", "handring"]),
        (Part::Toe, &["toe"]),
        (Part::Foot, &["foot", "ankle"]),
        (Part::Thigh, &["upleg", "upperleg", "upper_leg", "thigh", "femur"]),
        (Part::Hip, &["hipjoint"]),
        (Part::Shin, &["leg", "shin", "calf", "knee", "tibia"]),
        (Part::Forearm, &["forearm", "lowerarm", "lower_arm", "elbow", "ulna"]),
        (Part::Collar, &["shoulder", "clavicle", "collar", "scapula"]),
        (Part::UpperArm, &["arm", "humerus"]),
        (Part::Palm, &["hand", "wrist"]),
        (Part::Neck, &["neck"]),
        (Part::Head, &["head", "skull"]),
        (Part::Trunk, &["spine", "chest", "torso", "back", "abdomen", "thorax", "waist", "hip", "pelvis"]),
    ];

    /// The part that begins at the joint with this name.
    fn named(name: &str) -> Part {
        let name = name.to_lowercase();
        let fits = |(_, words): &&(Part, &[&str])| words.iter().any(|word| name.contains(word));
        Part::WORDS.iter().find(fits).map_or(Part::Unknown, |(part, _)| *part)
    }

    /// The bone between two joints that are named like this.
    fn between(parent: Part, child: Part) -> Part {
        match (parent, child) {
            (Part::Trunk, Part::Shin) => Part::Thigh,
            (Part::Trunk, Part::Thigh | Part::Hip) => Part::Hip,
            (Part::Trunk, Part::Collar | Part::UpperArm) => Part::Collar,
            (Part::Trunk, Part::Neck) => Part::Chest,
            (Part::Trunk, Part::Head) => Part::Neck,
            (Part::Collar, Part::Forearm) => Part::UpperArm,
            _ => parent,
        }
    }

    /// The radius as a share of the body's height, and the most that it may be of the bone's length.
    fn girth(self) -> (f32, f32) {
        match self {
            Part::Trunk => (0.054, f32::INFINITY),
            Part::Chest => (0.043, f32::INFINITY),
            Part::Hip => (0.044, f32::INFINITY),
            Part::Thigh => (0.041, f32::INFINITY),
            Part::Shin => (0.031, f32::INFINITY),
            Part::Foot => (0.022, f32::INFINITY),
            Part::Toe => (0.019, 0.5),
            Part::Collar => (0.034, f32::INFINITY),
            Part::UpperArm => (0.028, f32::INFINITY),
            Part::Forearm => (0.0225, f32::INFINITY),
            Part::Palm => (0.014, 0.5),
            Part::Finger => (0.0085, 0.4),
            Part::Neck => (0.028, f32::INFINITY),
            Part::Head => (0.044, f32::INFINITY),
            Part::Unknown => (0.022, 0.22),
        }
    }
}

/// The least radius, as a share of the size of the whole: what is thinner is hard to see.
const THINNEST: f32 = 0.003;

/// However far a bone is drawn out, it is as thin as one that is drawn out to the inverse of this.
const THINNEST_DRAWN_OUT: f32 = 0.05;

/// The share of its radius that a bone in a heap keeps.
const THINNEST_IN_A_HEAP: f32 = 0.25;

/// Where names tell nothing: the radius as a share of the bone's length, and the most that it is of the whole.
const SLENDER: f32 = 0.18;
const THICKEST: f32 = 0.032;

/// The radius of the bone that leads to each joint, in the file's unit: positive and finite. `size` is the size of the
/// whole figure.
pub fn radii(skeleton: &Skeleton, size: f32) -> Vec<f32> {
    let joints = skeleton.joints();
    let named: Vec<Part> = joints.iter().map(|joint| Part::named(&joint.name)).collect();
    let has = |parts: &[Part]| named.iter().any(|part| parts.contains(part));
    let is_body =
        has(&[Part::Thigh, Part::Shin, Part::Hip]) && has(&[Part::Trunk, Part::UpperArm, Part::Forearm]);
    let height = height(skeleton).min(size);
    let longest = longest(joints);
    joints
        .iter()
        .map(|joint| {
            let length = joint.offset.length();
            let radius = match joint.parent {
                Some(parent) if is_body => {
                    let child = if joint.is_end_site { Part::Unknown } else { named[joint.id.0] };
                    let mut part = Part::between(named[parent.0], child);
                    if part == Part::Head && length < longest[parent.0] {
                        // Eyes, jaws and lips hang on the head; one of its bones is the skull.
                        part = Part::Unknown;
                    }
                    let (share, most) = part.girth();
                    // A bone without a length may be a part of the body's outline, as hips are.
                    let most = if most.is_finite() { most * length } else { f32::INFINITY };
                    (share * height).min(most)
                }
                _ => (SLENDER * length).min(THICKEST * size),
            };
            // The larger of a number and NaN is the number.
            (THINNEST * size).max(f32::MIN_POSITIVE).max(radius.min(size))
        })
        .collect()
}

/// The radius of a bone of some `length`, of one that has this `radius` at its own length `own`. Unfinished functions put
/// joints far away from each other, or all in one heap. Where they do, bones are thin, so that joints and axes are seen.
pub fn misplaced(radius: f32, own: f32, length: f32) -> f32 {
    let share = if length > own {
        (own / length).max(THINNEST_DRAWN_OUT).sqrt()
    } else if own > 0.0 {
        // A little shorter is still a body.
        (1.25 * length / own).max(THINNEST_IN_A_HEAP)
    } else {
        1.0
    };
    if share < 1.0 { radius * share } else { radius }
}

/// The longest side of the box around the rest pose: how tall a body stands, or how far it holds out its arms, which is
/// about the same.
fn height(skeleton: &Skeleton) -> f32 {
    let places = skeleton.rest_positions();
    let low = places.iter().copied().reduce(Vec3::min).unwrap_or(Vec3::ZERO);
    let high = places.iter().copied().reduce(Vec3::max).unwrap_or(Vec3::ZERO);
    (high - low).max_element()
}

/// The length of the longest bone that starts at each joint.
fn longest(joints: &[Joint]) -> Vec<f32> {
    let mut longest = vec![0.0f32; joints.len()];
    for joint in joints {
        if let Some(parent) = joint.parent {
            longest[parent.0] = longest[parent.0].max(joint.offset.length());
        }
    }
    longest
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A skeleton of joints by name, parent and offset, and the radii of its bones by name.
    fn girths(joints: &[(&str, Option<usize>, Vec3)]) -> impl Fn(&str) -> f32 + use<> {
        let mut skeleton = Skeleton::new();
        let mut ids = Vec::new();
        for (name, parent, offset) in joints {
            ids.push(skeleton.add_joint(parent.map(|parent| ids[parent]), *name, *offset, []).unwrap());
        }
        let radii = radii(&skeleton, skeleton.extent());
        let names: Vec<String> = joints.iter().map(|(name, ..)| (*name).to_owned()).collect();
        move |name| radii[names.iter().position(|known| known == name).unwrap()]
    }

    fn person(unit: f32) -> impl Fn(&str) -> f32 + use<> {
        let joint = |name, parent, x: f32, y: f32| (name, parent, Vec3::new(x, y, 0.0) * unit);
        girths(&[
            joint("Hips", None, 0.0, 0.95),
            joint("LeftUpLeg", Some(0), 0.1, -0.05),
            joint("LeftLeg", Some(1), 0.0, -0.43),
            joint("LeftFoot", Some(2), 0.0, -0.43),
            joint("Spine", Some(0), 0.0, 0.12),
            joint("Neck", Some(4), 0.0, 0.4),
            joint("Head", Some(5), 0.0, 0.1),
            joint("HeadTop", Some(6), 0.0, 0.2),
            joint("Eye", Some(6), 0.03, 0.08),
            joint("LeftShoulder", Some(4), 0.05, 0.33),
            joint("LeftArm", Some(9), 0.15, 0.0),
            joint("LeftForeArm", Some(10), 0.3, 0.0),
            joint("LeftHand", Some(11), 0.26, 0.0),
            joint("LeftHandIndex1", Some(12), 0.1, 0.0),
            joint("LeftHandIndex2", Some(13), 0.04, 0.0),
        ])
    }

    #[test]
    fn a_body_is_thickest_in_the_middle_and_thinnest_at_its_fingers() {
        let person = person(1.0);
        // Each name is the joint at the end of a bone: `LeftLeg` ends the thigh.
        let order =
            ["Spine", "LeftLeg", "LeftFoot", "LeftForeArm", "LeftHand", "LeftHandIndex1", "LeftHandIndex2"];
        assert!(order.map(&person).is_sorted_by(|a, b| a > b), "{:?}", order.map(&person));
        assert!(person("HeadTop") > 1.3 * person("Head"), "the head is thicker than the neck");
        assert!(person("Eye") < 0.5 * person("HeadTop"), "what hangs on a head is no head");
    }

    #[test]
    fn thickness_follows_the_unit() {
        for unit in [1e-12f32, 0.01, 100.0, 1e12] {
            let (plain, scaled) = (person(1.0), person(unit));
            for name in ["Spine", "LeftForeArm", "LeftHandIndex2", "Eye"] {
                assert!((scaled(name) / (plain(name) * unit) - 1.0).abs() < 1e-3, "{name} at {unit}");
            }
        }
    }

    #[test]
    fn bones_without_known_names_are_slender() {
        let chain = girths(&[("base", None, Vec3::ZERO), ("tip", Some(0), Vec3::X * 2.0)]);
        assert!(chain("tip") > 0.01 && chain("tip") < 0.4);
        let hand = girths(&[
            ("LeftHand", None, Vec3::ZERO),
            ("LeftHandIndex1", Some(0), Vec3::new(0.09, 0.0, 0.02)),
            ("LeftHandIndex2", Some(1), Vec3::X * 0.04),
            ("LeftHandPinky1", Some(0), Vec3::new(0.08, 0.0, -0.03)),
            ("LeftHandPinky2", Some(3), Vec3::X * 0.03),
        ]);
        let apart = 0.05;
        assert!(hand("LeftHandIndex1") + hand("LeftHandPinky1") < 0.5 * apart, "a hand is no blot");
        assert!(hand("LeftHandIndex2") < 0.04 / 3.0);
    }

    #[test]
    fn bones_without_a_length_have_a_body_too() {
        let dog = girths(&[
            ("root", None, Vec3::ZERO),
            ("LHipJoint", Some(0), Vec3::ZERO),
            ("LThigh", Some(1), Vec3::new(0.1, 0.0, 0.0)),
            ("LKnee", Some(2), Vec3::Y * -0.3),
            ("Spine", Some(0), Vec3::Z * 0.4),
            ("tail", Some(0), Vec3::ZERO),
        ]);
        for name in ["root", "LHipJoint", "LThigh", "tail"] {
            assert!(dog(name) > 0.0 && dog(name).is_finite(), "{name}");
        }
    }

    #[test]
    fn a_bone_of_the_wrong_length_is_thin() {
        assert_eq!(misplaced(2.0, 5.0, 5.0), 2.0);
        assert_eq!(misplaced(2.0, 5.0, 4.5), 2.0);
        assert_eq!(misplaced(2.0, 5.0, 2.0), 1.0);
        assert_eq!(misplaced(2.0, 5.0, 0.0), 0.5);
        assert_eq!(misplaced(2.0, 5.0, 20.0), 1.0);
        assert!(misplaced(2.0, 0.0, 1e9) > 0.1 && misplaced(2.0, 5.0, f32::NAN) > 0.1);
        assert_eq!(misplaced(2.0, 0.0, 0.0), 2.0);
    }

    proptest! {
        #[test]
        fn every_radius_is_a_positive_number(raw in any::<[[f32; 3]; 6]>(), size in any::<f32>()) {
            let names = ["Hips", "Spine", "LeftLeg", "x", "Head", "LeftHandIndex1"];
            let mut skeleton = Skeleton::new();
            let mut parent = None;
            for (name, offset) in names.iter().zip(raw) {
                parent = Some(skeleton.add_joint(parent, *name, Vec3::from(offset), []).unwrap());
            }
            let size = if size.is_normal() { size.abs() } else { 1.0 };
            for radius in radii(&skeleton, size) {
                prop_assert!(radius > 0.0 && radius.is_finite() && radius <= size.max(f32::MIN_POSITIVE), "{radius}");
            }
        }
    }
}
