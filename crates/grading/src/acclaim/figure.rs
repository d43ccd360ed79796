//! Skeletons and postures that questions are about.

use skeleton::acclaim::{Bone, BoneData, BoneId, DegreeOfFreedom, LocalAxes, Posture, Root, Skeleton};
use skeleton::{Axis, Channel, RotationOrder};

use crate::dice::Dice;

use Axis::{X, Y, Z};

const ALL: &[Axis] = &[X, Y, Z];

/// The figure's bones: the name, the parent (0 is the root, 1 the first bone of this list), and about which of its axes
/// the bone turns. What hangs on a bone is not in one piece.
const BONES: [(&str, usize, &[Axis]); 17] = [
    ("lowerback", 0, ALL),
    ("lhipjoint", 0, &[]),
    ("rhipjoint", 0, &[]),
    ("upperback", 1, ALL),
    ("thorax", 4, &[X, Z]),
    ("neck", 5, ALL),
    ("lclavicle", 5, &[Z]),
    ("rclavicle", 5, &[Z]),
    ("head", 6, ALL),
    ("lhumerus", 7, ALL),
    ("rhumerus", 8, ALL),
    ("lradius", 10, &[Y]),
    ("rradius", 11, &[Y]),
    ("lfemur", 2, ALL),
    ("rfemur", 3, ALL),
    ("ltibia", 14, &[X]),
    ("rtibia", 15, &[X]),
];

/// These turn about several axes, which are the same as their parents'.
pub(super) const LIKE_PARENT: [&str; 4] = ["upperback", "thorax", "neck", "head"];

/// The end of this one can be moved.
const MOVED: &str = "lhumerus";

/// A figure with an orientation of its own, axes that are turned against the world's and mostly against the parent's,
/// directions along no axis, several bones on one, and bones that turn about all axes, some of them, or none.
pub(super) fn figure(dice: &mut Dice) -> Skeleton {
    let mut skeleton = root(dice);
    for (name, parent, turns) in BONES {
        let parent = BoneId(parent);
        let axis = if LIKE_PARENT.contains(&name) { skeleton[parent].axis } else { axes(dice) };
        let moves = ALL.iter().filter(|_| name == MOVED).copied().map(Channel::Position);
        let channels = moves.chain(turns.iter().copied().map(Channel::Rotation));
        hang(&mut skeleton, dice, parent, name.to_owned(), axis, channels);
    }
    skeleton
}

/// A root that turns about its own axes and is not at the origin.
pub(super) fn root(dice: &mut Dice) -> Skeleton {
    let root = Root { orientation: axes(dice), position: dice.vector(2.0, 9.0), ..Root::default() };
    Skeleton::new(root).expect("the usual dofs, and an orientation with an order")
}

/// Hangs a bone without dofs on `parent`, called by the next letter.
pub(super) fn hang_letter(skeleton: &mut Skeleton, dice: &mut Dice, parent: BoneId) -> BoneId {
    let letter = char::from_u32('a' as u32 + skeleton.len() as u32 - 1).unwrap_or('?');
    let axis = axes(dice);
    hang(skeleton, dice, parent, letter.to_string(), axis, [].into_iter())
}

fn hang(
    skeleton: &mut Skeleton,
    dice: &mut Dice,
    parent: BoneId,
    name: String,
    axis: LocalAxes,
    channels: impl Iterator<Item = Channel>,
) -> BoneId {
    let bone = BoneData {
        name,
        direction: dice.vector(0.3, 1.0).normalize(),
        length: dice.angle(2.0, 9.0).abs(),
        axis,
        dofs: channels.map(DegreeOfFreedom::unlimited).collect(),
    };
    skeleton.add_bone(parent, bone).expect("the parent is there, no name comes twice, and no dof")
}

/// Axes that are far from the world's.
fn axes(dice: &mut Dice) -> LocalAxes {
    let angles = std::array::from_fn(|_| dice.angle(20.0, 160.0));
    LocalAxes { angles, order: RotationOrder::Zyx }
}

/// Angles whose size is between `low` and `high`, about those axes about which the bone turns.
pub(super) fn angles(dice: &mut Dice, bone: &Bone, low: f32, high: f32) -> [f32; 3] {
    let turns = |axis| bone.dofs.iter().any(|dof| dof.channel == Channel::Rotation(axis));
    Axis::ALL.map(|axis| if turns(axis) { dice.angle(low, high) } else { 0.0 })
}

/// A posture in which everything moves that can.
pub(super) fn posture(dice: &mut Dice, skeleton: &Skeleton) -> Posture {
    let mut posture = Posture::rest(skeleton);
    for (bone, (turned, moved)) in
        skeleton.bones().iter().zip(posture.angles.iter_mut().zip(&mut posture.translations))
    {
        *turned = angles(dice, bone, 10.0, 100.0);
        if bone.dofs.iter().any(|dof| matches!(dof.channel, Channel::Position(_))) {
            *moved += dice.vector(2.0, 20.0);
        }
    }
    posture
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::angle_between;
    use glam::Quat;

    #[test]
    fn the_figure_has_all_that_is_hard() {
        for seed in 0..100 {
            let skeleton = figure(&mut Dice::new(seed, "figure"));
            for bone in &skeleton.bones()[1..] {
                let [direction, local] = [bone.direction, bone.local_direction];
                assert!(direction.abs().min_element() > 0.15 && direction.is_normalized(), "{bone:?}");
                assert!(direction.distance(local) > 1e-2, "{seed}: {bone:?}");
                assert!((bone.length - 1.0).abs() > 0.9);
                let rest = angle_between(bone.rot_parent_current, Quat::IDENTITY);
                assert_eq!(rest < 0.001, LIKE_PARENT.contains(&&*bone.name), "{seed}: {bone:?}");
                assert!(!(0.001..1.0).contains(&rest), "{seed}: {bone:?}");
                assert!(angle_between(bone.axis_rotation, Quat::IDENTITY) > 1.0, "{seed}: {bone:?}");
                assert!(angle_between(bone.axis_rotation, bone.rot_parent_current) > 1.0, "{seed}: {bone:?}");
                let is_usual = [RotationOrder::None, RotationOrder::Zyx].contains(&bone.rotation_order);
                assert!(is_usual, "the exercise knows one order only: {bone:?}");
            }
            assert!(angle_between(skeleton.root().rot_parent_current, Quat::IDENTITY) > 1.0);
        }
    }
}
