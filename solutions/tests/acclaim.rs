//! The reference solution of Acclaim forward kinematics: the examples of its own text, and a second formula that gives the
//! same positions.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use approx::assert_abs_diff_eq;
use glam::{Mat3, Quat, Vec3};
use proptest::prelude::*;
use skeleton::acclaim::{
    Bone, BoneData, BoneId, BonePlace, DegreeOfFreedom, LocalAxes, Posture, Root, Skeleton, Visitor,
};
use skeleton::{Axis, Channel, RotationOrder};
use solutions::acclaim::{bone_ends, bone_rotation, visit_bones};

fn quarter_about_z() -> Quat {
    Quat::from_rotation_z(90_f32.to_radians())
}

fn bone(name: &str) -> BoneData {
    BoneData { name: name.into(), direction: Vec3::X, length: 2.0, ..BoneData::default() }
}

fn root() -> Skeleton {
    Skeleton::new(Root::default()).unwrap()
}

/// A root, and one bone of these axes on it.
fn one_bone(axis: LocalAxes) -> Bone {
    let mut skeleton = root();
    let id = skeleton.add_bone(BoneId::ROOT, BoneData { axis, ..bone("a") }).unwrap();
    skeleton[id].clone()
}

mod examples {
    use super::*;

    #[test]
    fn of_part_1_are_right() {
        let bone = one_bone(LocalAxes::WORLD);
        let rotation = bone_rotation(&bone, [90.0, 0.0, 0.0], quarter_about_z());
        assert_abs_diff_eq!(rotation, Quat::from_xyzw(0.5, 0.5, 0.5, 0.5), epsilon = 1e-6);
        assert_abs_diff_eq!(rotation * Vec3::X, Vec3::Y, epsilon = 1e-6);
        assert_abs_diff_eq!(rotation * Vec3::Y, Vec3::Z, epsilon = 1e-6);
    }

    #[test]
    fn of_part_2_are_right() {
        let bone = one_bone(LocalAxes::WORLD);
        let (start, end) = bone_ends(&bone, quarter_about_z(), Vec3::new(10.0, 0.0, 0.0), Vec3::ZERO);
        assert_eq!(start, Vec3::new(10.0, 0.0, 0.0));
        assert_abs_diff_eq!(end, Vec3::new(10.0, 2.0, 0.0), epsilon = 1e-5);
    }

    #[test]
    fn of_part_3_are_right() {
        let mut skeleton = root();
        let femur = skeleton.add_bone(BoneId::ROOT, bone("lfemur")).unwrap();
        skeleton.add_bone(BoneId::ROOT, bone("lowerback")).unwrap();
        skeleton.add_bone(femur, bone("ltibia")).unwrap();
        assert_eq!(visited(&skeleton, BoneId::ROOT), ["root", "lfemur", "ltibia", "lowerback"]);
        assert_eq!(visited(&skeleton, femur), ["lfemur", "ltibia"]);
    }

    fn visited(skeleton: &Skeleton, start: BoneId) -> Vec<String> {
        let mut names = Vec::new();
        let mut see = |bone: &Bone| names.push(bone.name.clone());
        visit_bones(skeleton, &skeleton[start], &mut Visitor::new(&mut see));
        names
    }
}

mod a_rotation {
    use super::*;

    #[test]
    fn turns_about_x_first() {
        // A quarter about X takes Y to Z. A quarter about Z then leaves it there.
        let rotation = bone_rotation(&one_bone(LocalAxes::WORLD), [90.0, 0.0, 90.0], Quat::IDENTITY);
        assert_abs_diff_eq!(rotation * Vec3::Y, Vec3::Z, epsilon = 1e-6);
    }

    /// An angle about a bone's own X axis leaves that axis where it is at rest.
    #[test]
    fn is_about_the_bones_own_axes() {
        let axis = LocalAxes { angles: [20.0, 50.0, -70.0], order: RotationOrder::Zyx };
        let bone = one_bone(axis);
        let rotation = bone_rotation(&bone, [33.0, 0.0, 0.0], Quat::IDENTITY);
        assert_abs_diff_eq!(rotation * Vec3::X, bone.axis_rotation * Vec3::X, epsilon = 1e-6);
    }

    /// The root's file calls it `orientation`.
    #[test]
    fn of_a_root_begins_at_its_own_axes() {
        let orientation = LocalAxes { angles: [0.0, 0.0, 90.0], order: RotationOrder::Zyx };
        let skeleton = Skeleton::new(Root { orientation, ..Root::default() }).unwrap();
        let rotation = bone_rotation(skeleton.root(), [0.0; 3], Quat::IDENTITY);
        assert_abs_diff_eq!(rotation, quarter_about_z(), epsilon = 1e-6);
    }
}

mod ends {
    use super::*;

    #[test]
    fn move_with_the_translation_and_starts_do_not() {
        let (from, moved) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.0, 10.0, 0.0));
        let (start, end) = bone_ends(&one_bone(LocalAxes::WORLD), quarter_about_z(), from, moved);
        assert_eq!(start, from);
        assert_abs_diff_eq!(end, Vec3::new(1.0, 14.0, 3.0), epsilon = 1e-5);
    }

    #[test]
    fn of_a_root_are_in_one_place() {
        let place = Vec3::new(4.0, 5.0, 6.0);
        let ends = bone_ends(root().root(), quarter_about_z(), place, Vec3::ZERO);
        assert_eq!(ends, (place, place));
    }
}

fn places(skeleton: &Skeleton, posture: &Posture) -> Vec<BonePlace> {
    let mut places = vec![BonePlace::ORIGIN; skeleton.len()];
    let mut see = |bone: &Bone| {
        let id = bone.id.0;
        let (parent, from, moved) = match bone.parent {
            Some(parent) => (places[parent.0].rotation, places[parent.0].end, posture.translations[id]),
            None => (Quat::IDENTITY, posture.translations[0], Vec3::ZERO),
        };
        let rotation = bone_rotation(bone, posture.angles[id], parent);
        let (start, end) = bone_ends(bone, rotation, from, moved);
        places[id] = BonePlace { rotation, start, end };
    };
    visit_bones(skeleton, skeleton.root(), &mut Visitor::new(&mut see));
    places
}

/// Start and end of all bones, with matrices, and with G for how a bone is turned against its rest pose:
/// G = G(parent) C M C⁻¹, and end = start + G (length × direction) + translation.
fn by_conjugation(skeleton: &Skeleton, posture: &Posture) -> Vec<[Vec3; 2]> {
    let mut turned: Vec<Mat3> = Vec::new();
    let mut ends: Vec<[Vec3; 2]> = Vec::new();
    for bone in skeleton.bones() {
        let axes = product(bone.axis.order, bone.axis.angles);
        let moved = product(RotationOrder::Zyx, posture.angles[bone.id.0]);
        let above = bone.parent.map_or(Mat3::IDENTITY, |parent| turned[parent.0]);
        let turn = above * axes * moved * axes.transpose();
        let translation = posture.translations[bone.id.0];
        ends.push(match bone.parent {
            None => [translation; 2],
            Some(parent) => {
                let [_, start] = ends[parent.0];
                [start, start + turn * (bone.length * bone.direction) + translation]
            }
        });
        turned.push(turn);
    }
    ends
}

fn product(order: RotationOrder, degrees: [f32; 3]) -> Mat3 {
    let turn = |axis: Axis| Mat3::from_axis_angle(axis.unit(), degrees[axis.index()].to_radians());
    order.axes().into_iter().flatten().map(turn).product()
}

prop_compose! {
    fn any_bone()(
        parent in any::<prop::sample::Index>(),
        direction in prop::array::uniform3(-1.0_f32..1.0),
        length in 0.0_f32..9.0,
        angles in prop::array::uniform3(-180.0_f32..180.0),
        order in prop::sample::select(&RotationOrder::ROTATING[..]),
    ) -> (prop::sample::Index, BoneData) {
        let direction = Vec3::from(direction).try_normalize().unwrap_or(Vec3::Z);
        let dofs = Axis::ALL.map(Channel::Rotation).map(DegreeOfFreedom::unlimited).into();
        (parent, BoneData { name: String::new(), direction, length, axis: LocalAxes { angles, order }, dofs })
    }
}

prop_compose! {
    /// A skeleton and a posture of it.
    fn any_posture()(
        bones in prop::collection::vec(any_bone(), 0..20),
        orientation in prop::array::uniform3(-180.0_f32..180.0),
        angles in prop::collection::vec(prop::array::uniform3(-400.0_f32..400.0), 21),
        translations in prop::collection::vec(prop::array::uniform3(-20.0_f32..20.0), 21),
    ) -> (Skeleton, Posture) {
        let orientation = LocalAxes { angles: orientation, order: RotationOrder::Zyx };
        let mut skeleton = Skeleton::new(Root { orientation, ..Root::default() }).unwrap();
        for (index, (parent, data)) in bones.into_iter().enumerate() {
            let parent = BoneId(parent.index(skeleton.len()));
            skeleton.add_bone(parent, BoneData { name: format!("bone{index}"), ..data }).unwrap();
        }
        let translations = translations.into_iter().map(Vec3::from);
        let posture = Posture {
            angles: angles.into_iter().take(skeleton.len()).collect(),
            translations: translations.take(skeleton.len()).collect(),
        };
        (skeleton, posture)
    }
}

proptest! {
    #[test]
    fn two_formulas_put_all_bones_in_the_same_places((skeleton, posture) in any_posture()) {
        let places = places(&skeleton, &posture);
        let others = by_conjugation(&skeleton, &posture);
        // As far as the farthest bone can be from the root, and the root from the origin.
        let reach = |bone: &Bone| posture.translations[bone.id.0].length() + bone.length;
        let size = skeleton.bones().iter().map(reach).sum::<f32>();
        for (place, [start, end]) in places.iter().zip(others) {
            prop_assert!(place.start.distance(start) <= 1e-5 * size, "{place:?}, {start}");
            prop_assert!(place.end.distance(end) <= 1e-5 * size, "{place:?}, {end}");
            prop_assert!(place.rotation.is_normalized());
        }
    }

    #[test]
    fn the_rest_pose_is_the_skeletons_own((skeleton, _) in any_posture()) {
        let places = places(&skeleton, &Posture::rest(&skeleton));
        for (bone, (place, end)) in skeleton.bones().iter().zip(places.iter().zip(skeleton.rest_ends())) {
            assert_abs_diff_eq!(place.end, end, epsilon = 1e-3);
            let turned = place.rotation * bone.axis_rotation.inverse();
            prop_assert!(turned.w.abs() > 1.0 - 1e-5, "{} is turned by {turned}", bone.name);
        }
    }

    #[test]
    fn every_bone_is_visited_once_and_parents_first((skeleton, _) in any_posture()) {
        for start in skeleton.bones() {
            let mut visited = Vec::new();
            let mut see = |bone: &Bone| visited.push(bone.id);
            visit_bones(&skeleton, start, &mut Visitor::new(&mut see));
            let hangs = |bone: &&Bone| {
                let above = |bone: &Bone| bone.parent.map(|parent| &skeleton[parent]);
                std::iter::successors(Some(*bone), |bone| above(bone)).any(|bone| bone.id == start.id)
            };
            let is_late = |id: &BoneId| visited.iter().position(|visited| visited == id);
            for bone in skeleton.bones().iter().filter(hangs).filter(|bone| bone.id != start.id) {
                prop_assert!(is_late(&bone.parent.unwrap()) < is_late(&bone.id));
            }
            let mut sorted = visited.clone();
            sorted.sort_unstable();
            let all: Vec<BoneId> = skeleton.bones().iter().filter(hangs).map(|bone| bone.id).collect();
            prop_assert_eq!(sorted, all);
        }
    }
}
