//! Bones and a summary of their motion.

use std::fmt::Write;

use parser::acclaim::depth_first;
use parser::printable;
use skeleton::RotationOrder;
use skeleton::acclaim::{AngleUnit, BoneId, DegreeOfFreedom, Motion, Skeleton};

use super::joints::{extent, extent_of};
use super::numbers::{length, number, shortened};
use super::tree::{branches, padded, width};
use super::{lines, numbering};
use crate::motion::source::Source;
use crate::view::texts::count;

/// So many bones that something is said about are listed.
const MOST_LISTED: usize = 10;

/// The skeleton as a tree: one line per bone with its length and its direction at rest (in the file's unit and the world's
/// axes), the angles of its own axes in degrees, and its degrees of freedom with their limits. `joints` are those that stand
/// for the bones.
pub fn tree(skeleton: &Skeleton, joints: &skeleton::Skeleton) -> String {
    let extent = extent(joints);
    let bones = depth_first(skeleton);
    let mut places = vec![0; skeleton.len()];
    bones.iter().enumerate().for_each(|(place, bone)| places[bone.id.0] = place);
    let branches =
        branches(bones.iter().map(|bone| (&*bone.name, bone.parent.map(|parent| places[parent.0]))));
    let width = width(&branches);
    // Most files have no other order than the usual one.
    let has_orders = bones.iter().any(|bone| bone.axis.order != RotationOrder::Zyx);
    let order = |word: &str| if has_orders { format!("{word:<5}  ") } else { String::new() };
    let mut text = format!(
        "{:width$}  {:>8}  {:>11} {:>6} {:>6}  {:>7} {:>7} {:>7}  {}dofs\n",
        "bone",
        "length",
        "direction x",
        "y",
        "z",
        "axis x",
        "y",
        "z",
        order("order")
    );
    for (bone, branch) in bones.iter().zip(&branches) {
        let long = if bone.is_root() { String::new() } else { length(bone.length.into(), extent) };
        let [x, y, z] = match bone.is_root() {
            true => [const { String::new() }; 3],
            false => bone.direction.to_array().map(part),
        };
        let [a, b, c] = bone.axis.angles.map(|angle| short(without_noise(angle)));
        let letters = bone.axis.letters();
        let order = order(if letters == "XYZ" { "" } else { &letters });
        let dofs: Vec<String> = bone.dofs.iter().map(dof).collect();
        let (branch, dofs) = (padded(branch, width), dofs.join(", "));
        let line = format!("{branch}  {long:>8}  {x:>11} {y:>6} {z:>6}  {a:>7} {b:>7} {c:>7}  {order}{dofs}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// A degree of freedom and its limits: `rx -120..30`, or `rx -5..` where there is only one.
fn dof(dof: &DegreeOfFreedom) -> String {
    let side = |limit: f32| if limit.is_infinite() { String::new() } else { short(limit) };
    match dof.is_limited() {
        true => format!("{dof} {}..{}", side(dof.low), side(dof.high)),
        false => dof.to_string(),
    }
}

/// A part of a direction, which is at most 1.
fn part(value: f32) -> String {
    number(without_noise(value).into(), 3)
}

/// What is next to nothing beside 1, or as an angle in degrees, is a zero: it comes of rounding.
fn without_noise(value: f32) -> f32 {
    if value.abs() < 5e-4 { 0.0 } else { value }
}

/// A number with as few digits behind the point as it takes, and no more than three.
fn short(value: f32) -> String {
    shortened(number(value.into(), 3))
}

/// What there is to know about a motion of bones, one fact per line. `joints` is the same motion, of joints.
pub fn summary(source: &Source, motion: &Motion, joints: &skeleton::Motion) -> String {
    let skeleton = motion.skeleton();
    let (root, bones) = (skeleton.root(), &skeleton.bones()[1..]);
    let free = bones.iter().filter(|bone| !bone.dofs.is_empty()).count();
    let of_bones: usize = bones.iter().map(|bone| bone.dofs.len()).sum();
    let fixed = match bones.len() - free {
        0 => String::new(),
        fixed => format!("; {fixed} without degrees of freedom"),
    };
    let units = skeleton.units;
    let angles = if units.angle == AngleUnit::Degrees { "degrees" } else { "radians" };
    let order: Vec<String> = root.dofs.iter().map(|dof| dof.to_string().to_uppercase()).collect();
    let three = |numbers: [f32; 3]| numbers.map(short).join(" ");
    let (position, orientation) = (three(skeleton.position().to_array()), three(root.axis.angles));
    let all_three = if motion.columns().has_three_angles() { ", all three angles of each bone" } else { "" };
    let frames = motion.frame_count();
    let mut facts = vec![
        ("skeleton", format!("{} and the root{fixed}", count(bones.len(), "bone", "bones"))),
        (
            "dofs",
            format!(
                "{}: {of_bones} of {} and {} of the root",
                count(of_bones + root.dofs.len(), "degree of freedom", "degrees of freedom"),
                count(free, "bone", "bones"),
                root.dofs.len()
            ),
        ),
        ("units", format!("length {}, mass {}, angles in {angles}", short(units.length), short(units.mass))),
        (
            "root",
            format!(
                "order {}, position {position}, orientation {orientation} {}",
                order.join(" "),
                root.axis.letters()
            ),
        ),
    ];
    if source.skeleton.is_some() {
        let numbers = count(motion.columns().len(), "number", "numbers");
        facts.extend([
            ("numbers", format!("{numbers} per frame{all_three}")),
            ("not moved", still(motion)),
            ("frames", format!("{frames} ({})", numbering(frames))),
            (
                "rate",
                format!(
                    "{} frames per second (the file does not say it: --rate)",
                    shortened(number(source.rate, 3))
                ),
            ),
            ("duration", format!("{} s", number(frames as f64 / source.rate, 2))),
        ]);
    } else {
        facts.push(("frames", "a skeleton alone, shown in its rest pose".into()));
    }
    facts.push(("extent", extent_of(joints.skeleton())));
    lines(&facts)
}

/// The bones that could move, and do not.
fn still(motion: &Motion) -> String {
    let still = motion.columns().still();
    let name = |id: &BoneId| motion.skeleton().get(*id).map(|bone| printable(&bone.name));
    let names: Vec<String> = still.iter().take(MOST_LISTED).filter_map(name).collect();
    match still.len() - names.len() {
        0 if names.is_empty() => "none: there are numbers for all bones with degrees of freedom".into(),
        0 => names.join(", "),
        more => format!("{}, and {more} more", names.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use skeleton::{Axis, Channel};

    use super::*;

    #[test]
    fn limits_are_told_on_the_sides_on_which_there_are_some() {
        let channel = Channel::Rotation(Axis::Y);
        let told = |low: f32, high: f32| dof(&DegreeOfFreedom { channel, low, high });
        assert_eq!(told(f32::NEG_INFINITY, f32::INFINITY), "ry");
        assert_eq!(told(-120.0, 28.6479), "ry -120..28.648");
        assert_eq!(told(f32::NEG_INFINITY, 0.0), "ry ..0");
        assert_eq!(told(-0.5, f32::INFINITY), "ry -0.5..");
    }

    #[test]
    fn rounding_errors_are_zeros_and_what_is_no_number_is_told() {
        assert_eq!([-4.5e-11, -0.0, 0.978_148, f32::NAN].map(part), ["0.000", "0.000", "0.978", "NaN"]);
        assert_eq!([30.0, 0.05, 1e9, -0.0].map(short), ["30", "0.05", "1e9", "0"]);
    }
}
