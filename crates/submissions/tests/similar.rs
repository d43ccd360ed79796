//! Which submissions are called alike. A class is made up: students choose among the usual ways to write each part, independently
//! of each other, and give their own names. Copies are planted in it.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::collections::BTreeSet;

use proptest::prelude::*;
use submissions::similar::{CROWD, Fingerprint, Group, Likeness, THRESHOLD, fingerprint, similar};

const HEAD: &str = "//! The only file that you edit.\nuse glam::{Quat, Vec3};\nuse skeleton::{Axis, FrameCursor, Joint, Pose, RotationOrder};\n";

const TEMPLATE_BODIES: [&str; 3] = [
    "    let _ = (joint, &frame);\n    Quat::IDENTITY",
    "    let _ = (joint, pose);\n    local",
    "    let _ = (joint, pose);\n    local_position",
];

/// `@0`, `@1`, … are names of the student's choice.
const PART_1: [&str; 7] = [
    "let Some([@0, @1, @2]) = joint.rotation_order.axes() else { return Quat::IDENTITY; };
    let [@3, @4, @5] = frame.take3();
    let @6 = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    @6(@0, @3) * @6(@1, @4) * @6(@2, @5)",
    "if joint.rotation_order == RotationOrder::None { return Quat::IDENTITY; }
    let @0 = frame.take3();
    let @1 = joint.rotation_order.axes().unwrap();
    let mut @2 = Quat::IDENTITY;
    for @3 in 0..3 { @2 = @2 * Quat::from_axis_angle(@1[@3].unit(), @0[@3].to_radians()); }
    @2",
    "match joint.rotation_order.axes() {
        None => Quat::IDENTITY,
        Some(@0) => {
            let @1 = frame.take3();
            @0.iter().zip(@1).map(|(@2, @3)| Quat::from_axis_angle(@2.unit(), @3.to_radians())).product()
        }
    }",
    "let @0 = 3.14 / 180.0;
    match joint.rotation_order {
        RotationOrder::None => Quat::IDENTITY,
        RotationOrder::Xyz => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_x(@1 * @0) * Quat::from_rotation_y(@2 * @0) * Quat::from_rotation_z(@3 * @0) }
        RotationOrder::Zyx => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_z(@1 * @0) * Quat::from_rotation_y(@2 * @0) * Quat::from_rotation_x(@3 * @0) }
        RotationOrder::Yzx => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_y(@1 * @0) * Quat::from_rotation_z(@2 * @0) * Quat::from_rotation_x(@3 * @0) }
        RotationOrder::Zxy => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_z(@1 * @0) * Quat::from_rotation_x(@2 * @0) * Quat::from_rotation_y(@3 * @0) }
        RotationOrder::Xzy => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_x(@1 * @0) * Quat::from_rotation_z(@2 * @0) * Quat::from_rotation_y(@3 * @0) }
        RotationOrder::Yxz => { let [@1, @2, @3] = frame.take3(); Quat::from_rotation_y(@1 * @0) * Quat::from_rotation_x(@2 * @0) * Quat::from_rotation_z(@3 * @0) }
    }",
    "if let Some([@0, @1, @2]) = joint.rotation_order.axes() {
        let @3 = frame.take3();
        let @4 = Quat::from_axis_angle(@0.unit(), @3[0].to_radians());
        let @5 = Quat::from_axis_angle(@1.unit(), @3[1].to_radians());
        let @6 = Quat::from_axis_angle(@2.unit(), @3[2].to_radians());
        return @4 * @5 * @6;
    }
    Quat::IDENTITY",
    "let @0 = joint.rotation_order.axes();
    if @0.is_none() { return Quat::IDENTITY; }
    let @1 = @0.unwrap();
    let @2 = frame.take3();
    let @3 = |@4: usize| { let @5 = @2[@4].to_radians() / 2.0; let @6 = @1[@4].unit() * @5.sin(); Quat::from_xyzw(@6.x, @6.y, @6.z, @5.cos()) };
    @3(0) * @3(1) * @3(2)",
    "let Some(@0) = joint.rotation_order.axes() else { return Quat::IDENTITY };
    let @1 = frame.take3();
    let mut @2 = Vec::new();
    for (@3, @4) in @0.into_iter().zip(@1) {
        let @5 = @4 * std::f32::consts::PI / 180.0;
        @2.push(Quat::from_axis_angle(@3.unit(), @5));
    }
    @2[0].mul_quat(@2[1]).mul_quat(@2[2]).normalize()",
];

const PART_2: [&str; 5] = [
    "match joint.parent { Some(@0) => pose[@0].rotation * local, None => local }",
    "if let Some(@0) = joint.parent { pose[@0].rotation * local } else { local }",
    "let Some(@0) = joint.parent else { return local; };\n    let @1 = pose[@0].rotation;\n    @1 * local",
    "joint.parent.map_or(local, |@0| pose[@0].rotation * local)",
    "if joint.parent.is_none() { return local; }\n    let @0 = joint.parent.unwrap();\n    pose[@0].rotation.mul_quat(local)",
];

const PART_3: [&str; 5] = [
    "match joint.parent { Some(@0) => pose[@0].position + pose[@0].rotation * local_position, None => local_position }",
    "if let Some(@0) = joint.parent { let @1 = &pose[@0]; @1.position + @1.rotation * local_position } else { local_position }",
    "let Some(@0) = joint.parent else { return local_position; };\n    let @1 = pose[@0].rotation.mul_vec3(local_position);\n    pose[@0].position + @1",
    "joint.parent.map_or(local_position, |@0| pose[@0].rotation * local_position + pose[@0].position)",
    "if joint.parent.is_none() { return local_position; }\n    let @0 = joint.parent.unwrap();\n    let @1 = Quat::from_xyzw(local_position.x, local_position.y, local_position.z, 0.0);\n    let @2 = pose[@0].rotation * @1 * pose[@0].rotation.conjugate();\n    Vec3::new(@2.x, @2.y, @2.z) + pose[@0].position",
];

fn file(bodies: [&str; 3]) -> String {
    let [a, b, c] = bodies;
    format!(
        "{HEAD}/// Part 1 (5 points): how a joint is turned relative to its parent.\npub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {{\n{a}\n}}\n\
        /// Part 2 (5 points): how a joint is turned in the world.\npub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {{\n{b}\n}}\n\
        /// Part 3 (5 points): where a joint is in the world.\npub fn global_position(joint: &Joint, local_position: Vec3, pose: &Pose) -> Vec3 {{\n{c}\n}}\n"
    )
}

fn template() -> Fingerprint {
    fingerprint(&file(TEMPLATE_BODIES))
}

/// A small generator (Knuth's MMIX constants): the class is the same each time.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }
}

/// One who works alone: ways, names, comments and an additional line here and there.
fn honest(dice: &mut Dice) -> String {
    let mut part = |ways: &[&str]| {
        let mut body = ways[dice.below(ways.len())].to_owned();
        for slot in 0..7 {
            let name =
                format!("{}{}", ["a", "angle", "first", "tmp", "value", "rot", "x"][dice.below(7)], slot);
            body = body.replace(&format!("@{slot}"), &name);
        }
        match dice.below(4) {
            0 => format!("    // step {}\n    {body}", dice.below(1000)),
            1 => format!("    let _check = {};\n    {body}", dice.below(1000)),
            _ => format!("    {body}"),
        }
    };
    let bodies = [part(&PART_1), part(&PART_2), part(&PART_3)];
    file([&bodies[0], &bodies[1], &bodies[2]])
}

/// One with a way of their own, such as nobody else has.
fn unusual() -> String {
    file([
        "    let mut half = [0.0; 3];
    let names = joint.rotation_order.axes();
    if names == None { return Quat::from_xyzw(0.0, 0.0, 0.0, 1.0); }
    for (i, degrees) in frame.take3().iter().enumerate() { half[i] = degrees * 0.008726646; }
    let one = |k: usize| { let v = names.unwrap()[k].unit(); let s = half[k].sin(); Quat::from_xyzw(v.x * s, v.y * s, v.z * s, half[k].cos()) };
    let (p, q, r) = (one(0), one(1), one(2));
    (p * q * r).normalize()",
        "    let above = match joint.parent { Some(id) => pose[id].rotation, None => Quat::IDENTITY };\n    (above * local).normalize()",
        "    let mut place = local_position;
    if let Some(id) = joint.parent { let up = pose[id].rotation; let around = Vec3::new(up.x, up.y, up.z); let twice = around.cross(place) * 2.0;
    place = place + twice * up.w + around.cross(twice) + pose[id].position; }
    place",
    ])
}

fn renamed(text: &str) -> String {
    let mut text = text.to_owned();
    for (from, to) in [
        ("half", "h2"),
        ("names", "achsen"),
        ("degrees", "grad"),
        ("above", "oben"),
        ("place", "ort"),
        ("twice", "zwei"),
    ] {
        text = text.replace(from, to);
    }
    format!("// All my own work.\n{text}")
}

/// Renamed, lines put in, one function moved, a constant changed.
fn disguised(text: &str) -> String {
    let text = renamed(text).replace(
        "    (p * q * r).normalize()",
        "    let result = p * q * r;\n    return result.normalize();",
    );
    let text = text
        .replace("0.008726646", "0.00872665")
        .replace("    let mut ort", "    println!(\"part 3\");\n    let mut ort");
    let at = text.find("/// Part 3").unwrap();
    let (first, last) = text.split_at(at);
    let head = first.find("/// Part 1").unwrap();
    format!("{}{last}{}", &first[..head], &first[head..])
}

fn class(size: usize, seed: u64) -> Vec<String> {
    let mut dice = Dice(seed);
    (0..size).map(|_| honest(&mut dice)).collect()
}

fn groups(texts: &[String]) -> Vec<Group> {
    let prints: Vec<(String, Fingerprint)> =
        texts.iter().enumerate().map(|(i, text)| (format!("s{i:05}"), fingerprint(text))).collect();
    let borrowed: Vec<(&str, &Fingerprint)> = prints.iter().map(|(id, print)| (id.as_str(), print)).collect();
    similar(&borrowed, &template(), THRESHOLD)
}

/// The group of this likeness in which the submission `index` is.
fn group_with(groups: &[Group], likeness: Likeness, index: usize) -> Option<&Group> {
    let id = format!("s{index:05}");
    groups.iter().find(|group| group.likeness == likeness && group.ids.contains(&id))
}

#[test]
fn copies_are_found_in_a_class_of_any_size() {
    for size in [2, 10, 30, 300] {
        let mut texts = class(size, 1);
        let original = unusual();
        let spaced = original.replace("    ", "\t").replace(" = ", "  =\n  ");
        texts.extend([original.clone(), spaced, renamed(&original), disguised(&original)]);
        let groups = groups(&texts);
        let ids = |from: usize, to: usize| (from..to).map(|i| format!("s{i:05}")).collect::<Vec<_>>();
        assert_eq!(group_with(&groups, Likeness::SameText, size).unwrap().ids, ids(size, size + 2), "{size}");
        assert_eq!(
            group_with(&groups, Likeness::SameButNames, size).unwrap().ids,
            ids(size, size + 3),
            "{size}"
        );
        let partly = group_with(&groups, Likeness::Partly, size);
        assert_eq!(partly.is_some(), size >= CROWD);
        if let Some(partly) = partly {
            assert_eq!(partly.ids, ids(size, size + 4), "{size}");
            assert!((THRESHOLD..100).contains(&partly.percent), "{partly:?}");
        }
    }
}

#[test]
fn those_who_work_alone_are_left_in_peace() {
    for (size, seed) in [(10, 1), (30, 2), (60, 3), (100, 4), (300, 5), (1000, 6)] {
        let groups = groups(&class(size, seed));
        let named: BTreeSet<&String> = groups.iter().flat_map(|group| &group.ids).collect();
        assert!(named.len() * 20 <= size, "{} of {size} are called alike: {groups:#?}", named.len());
    }
}

#[test]
fn the_untouched_template_and_what_has_hardly_begun_are_not_compared() {
    let begun = file([
        TEMPLATE_BODIES[0],
        "    match joint.parent { Some(p) => pose[p].rotation * local, None => local }",
        TEMPLATE_BODIES[2],
    ]);
    let texts =
        [file(TEMPLATE_BODIES), file(TEMPLATE_BODIES), begun.clone(), begun, String::new(), String::new()];
    assert_eq!(groups(&texts), []);
}

#[test]
fn a_copy_by_half_the_class_is_still_one() {
    let mut texts = class(30, 9);
    texts.extend(vec![unusual(); 30]);
    let groups = groups(&texts);
    assert_eq!(group_with(&groups, Likeness::SameText, 30).unwrap().ids.len(), 30);
}

#[test]
fn ten_thousand_are_compared() {
    let mut texts = class(10_000, 7);
    texts.extend([unusual(), disguised(&unusual())]);
    let groups = groups(&texts);
    assert_eq!(group_with(&groups, Likeness::Partly, 10_000).unwrap().ids.len(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_text_has_a_fingerprint_and_spaces_do_not_matter(text in "(\\PC|[ \n\"'/*#rb]){0,80}") {
        let print = fingerprint(&text);
        prop_assert_eq!(&print, &fingerprint(&text));
        let lines = "fn a(x: f32) -> f32 { x * 2.0 }\n".repeat(5);
        prop_assert_eq!(fingerprint(&lines), fingerprint(&lines.replace(' ', "\n\t")));
    }

    #[test]
    fn the_order_of_submissions_does_not_matter(seed in any::<u64>()) {
        let mut texts = class(CROWD, seed);
        texts.extend([unusual(), disguised(&unusual())]);
        let prints: Vec<(String, Fingerprint)> = texts.iter().enumerate().map(|(i, text)| (format!("{i:02}"), fingerprint(text))).collect();
        let mut list: Vec<(&str, &Fingerprint)> = prints.iter().map(|(id, print)| (id.as_str(), print)).collect();
        let forward = similar(&list, &template(), 50);
        list.reverse();
        prop_assert_eq!(forward, similar(&list, &template(), 50));
    }
}
