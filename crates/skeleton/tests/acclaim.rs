//! The vocabulary of bones.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use glam::{Quat, Vec3};
use proptest::prelude::*;
use skeleton::acclaim::{
    BoneData, BoneId, Columns, DegreeOfFreedom, LocalAxes, Motion, Posture, Root, Skeleton, SkeletonError,
};
use skeleton::{Axis, Channel, RotationOrder};

use Axis::{X, Y, Z};
use Channel::{Position, Rotation};

fn dofs(channels: &[Channel]) -> Vec<DegreeOfFreedom> {
    channels.iter().copied().map(DegreeOfFreedom::unlimited).collect()
}

fn bone(name: &str, channels: &[Channel]) -> BoneData {
    BoneData {
        name: name.into(),
        direction: Vec3::Y,
        length: 2.0,
        dofs: dofs(channels),
        ..BoneData::default()
    }
}

/// root — a — b
///      ╲   ╲ c
///       d
fn small() -> Skeleton {
    let mut skeleton = Skeleton::new(Root { position: Vec3::X, ..Root::default() }).unwrap();
    let a = skeleton.add_bone(BoneId::ROOT, bone("a", &[Rotation(X), Rotation(Z)])).unwrap();
    skeleton.add_bone(a, bone("b", &[])).unwrap();
    skeleton.add_bone(a, bone("c", &[Rotation(Y)])).unwrap();
    skeleton.add_bone(BoneId::ROOT, BoneData { direction: Vec3::X, ..bone("d", &[Position(Z)]) }).unwrap();
    skeleton
}

fn motion(columns: Columns, frames: usize) -> Motion {
    let values = (1..=frames * columns.len()).map(|value| value as f32).collect();
    Motion::new(columns, frames, values).unwrap()
}

mod skeleton_of_bones {
    use super::*;

    #[test]
    fn is_a_tree_of_first_children_and_next_siblings() {
        let skeleton = small();
        let links = |id: usize| {
            let bone = skeleton.get(BoneId(id)).unwrap();
            (bone.id.0, bone.parent.map(|id| id.0), bone.child.map(|id| id.0), bone.sibling.map(|id| id.0))
        };
        assert_eq!(links(0), (0, None, Some(1), None));
        assert_eq!(links(1), (1, Some(0), Some(2), Some(4)));
        assert_eq!(links(2), (2, Some(1), None, Some(3)));
        assert_eq!(links(3), (3, Some(1), None, None));
        assert_eq!(links(4), (4, Some(0), None, None));
        let children = |id| skeleton.children(BoneId(id)).map(|bone| bone.name.as_str()).collect::<Vec<_>>();
        assert_eq!(children(0), ["a", "d"]);
        assert_eq!(children(1), ["b", "c"]);
        assert_eq!(children(4), [""; 0]);
        assert_eq!(children(99), [""; 0]);
    }

    #[test]
    fn knows_its_bones_by_name_in_any_case() {
        let skeleton = small();
        assert_eq!(skeleton.find("C").unwrap().id, BoneId(3));
        assert_eq!(skeleton.find("root").unwrap(), skeleton.root());
        assert_eq!(skeleton.find("e"), None);
    }

    #[test]
    fn refuses_what_a_file_could_not_refer_to() {
        let mut skeleton = small();
        let mut refusal = |data| skeleton.add_bone(BoneId::ROOT, data).unwrap_err();
        for name in ["", "two words", "tab\t", "a\nb", ":a", "#a", "end", "Begin", "ROOT", &"x".repeat(4097)]
        {
            assert_eq!(refusal(bone(name, &[])), SkeletonError::Name(name.into()));
        }
        assert_eq!(refusal(bone("B", &[])), SkeletonError::RepeatedName("B".into()));
        let twice = bone("e", &[Rotation(X), Rotation(X)]);
        assert_eq!(refusal(twice), SkeletonError::RepeatedDof(Rotation(X)));
        let axis = LocalAxes { order: RotationOrder::None, ..LocalAxes::WORLD };
        assert_eq!(refusal(BoneData { axis, ..bone("e", &[]) }), SkeletonError::NoOrder("e".into()));
        let unknown = skeleton.add_bone(BoneId(5), bone("e", &[])).unwrap_err();
        assert_eq!(unknown, SkeletonError::UnknownParent(BoneId(5)));
        assert_eq!(skeleton, small(), "what was refused has left no trace");
    }

    #[test]
    fn rests_where_directions_and_lengths_put_it() {
        let skeleton = small();
        let ends = [(1, 0), (1, 2), (1, 4), (1, 4), (3, 0)].map(|(x, y)| Vec3::new(x as f32, y as f32, 0.0));
        assert_eq!(skeleton.rest_ends(), ends);
        assert_eq!(skeleton.extent(), 20_f32.sqrt());
        assert_eq!(Skeleton::new(Root::default()).unwrap().extent(), 0.0);
    }

    #[test]
    fn is_the_same_after_a_journey() {
        let mut skeleton = small();
        skeleton.name = "figure".into();
        skeleton.units.length = 0.45;
        let bytes = postcard::to_stdvec(&skeleton).unwrap();
        assert_eq!(postcard::from_bytes::<Skeleton>(&bytes).unwrap(), skeleton);
        let at = bytes.windows(2).position(|pair| pair == b"\x01c").unwrap();
        let broken = [&bytes[..=at], b"a", &bytes[at + 2..]].concat();
        assert!(postcard::from_bytes::<Skeleton>(&broken).is_err(), "two bones of one name");
    }
}

mod rotation_order {
    use super::*;

    fn of(channels: &[Channel]) -> RotationOrder {
        let mut skeleton = Skeleton::new(Root::default()).unwrap();
        let id = skeleton.add_bone(BoneId::ROOT, bone("a", channels)).unwrap();
        skeleton.get(id).unwrap().rotation_order
    }

    #[test]
    fn is_the_list_of_dofs_from_last_to_first() {
        assert_eq!(of(&[Rotation(X), Rotation(Y), Rotation(Z)]), RotationOrder::Zyx);
        assert_eq!(of(&[Rotation(Y), Rotation(Z), Rotation(X)]), RotationOrder::Xzy);
        assert_eq!(
            of(&[Position(X), Rotation(Z), Position(Y), Rotation(X), Rotation(Y)]),
            RotationOrder::Yxz
        );
        assert_eq!(of(&[]), RotationOrder::None);
    }

    #[test]
    fn puts_missing_axes_where_the_usual_order_has_them() {
        assert_eq!(of(&[Rotation(X), Rotation(Z)]), RotationOrder::Zyx);
        assert_eq!(of(&[Rotation(Y)]), RotationOrder::Zyx);
        assert_eq!(of(&[Rotation(Z), Rotation(X)]), RotationOrder::Yxz);
        assert_eq!(of(&[Position(X)]), RotationOrder::Zyx, "a motion may turn it all the same");
    }
}

mod local_axes {
    use super::*;

    #[test]
    fn are_turned_about_x_first_in_the_usual_order() {
        let mut skeleton = Skeleton::new(Root::default()).unwrap();
        let axis = LocalAxes { angles: [90.0, 0.0, 90.0], order: RotationOrder::Zyx };
        let data = BoneData { direction: Vec3::Z, axis, ..bone("a", &[]) };
        let id = skeleton.add_bone(BoneId::ROOT, data).unwrap();
        let a = skeleton.get(id).unwrap();
        // X turns Y to Z, and then Z turns X to Y.
        assert!((a.axis_rotation * Vec3::X).abs_diff_eq(Vec3::Y, 1e-6));
        assert!((a.axis_rotation * Vec3::Y).abs_diff_eq(Vec3::Z, 1e-6));
        assert!(a.local_direction.abs_diff_eq(Vec3::Y, 1e-6));
        assert_eq!(a.rot_parent_current, a.axis_rotation);

        let axis = LocalAxes { angles: [90.0, 0.0, 180.0], ..axis };
        let b = skeleton.add_bone(id, BoneData { axis, ..bone("b", &[]) }).unwrap();
        let b = skeleton.get(b).unwrap();
        // Seen from the axes of `a`, those of `b` are turned a quarter about the world's Z, which is the Y of `a`.
        let quarter = Quat::from_rotation_y(90_f32.to_radians());
        assert!(b.rot_parent_current.abs_diff_eq(quarter, 1e-6), "{}", b.rot_parent_current);
    }

    #[test]
    fn are_written_from_the_right_of_the_product() {
        for (order, letters) in [
            (RotationOrder::Zyx, "XYZ"),
            (RotationOrder::Yzx, "XZY"),
            (RotationOrder::Xzy, "YZX"),
            (RotationOrder::None, ""),
        ] {
            assert_eq!(LocalAxes { order, ..LocalAxes::WORLD }.letters(), letters);
        }
    }
}

mod dof {
    use super::*;

    #[test]
    fn is_read_by_its_word_in_any_case() {
        for channel in Axis::ALL.into_iter().flat_map(|axis| [Position(axis), Rotation(axis)]) {
            let word = DegreeOfFreedom::unlimited(channel).to_string();
            assert_eq!(DegreeOfFreedom::channel_of(&word.to_uppercase()), Some(channel));
        }
        assert_eq!(DegreeOfFreedom::word(Position(Z)), "tz");
        assert_eq!(DegreeOfFreedom::channel_of("l"), None);
    }
}

mod motion_of_bones {
    use super::*;

    #[test]
    fn gives_every_bone_its_own_numbers() {
        let motion = motion(Columns::new(small()), 2);
        assert_eq!(motion.columns().len(), 6 + 2 + 1 + 1);
        let Posture { angles, translations } = motion.posture(1);
        assert_eq!(angles, [[14.0, 15.0, 16.0], [17.0, 0.0, 18.0], [0.0; 3], [0.0, 19.0, 0.0], [0.0; 3]]);
        let root = Vec3::new(11.0 + 1.0, 12.0, 13.0); // The root's position is added.
        assert_eq!(translations, [root, Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, Vec3::Z * 20.0]);
        assert_eq!(motion.row(2), None);
        assert_eq!(motion.posture(2), Posture::rest(&small()));
        assert_eq!(Posture::rest(&small()).translations[0], Vec3::X);
    }

    #[test]
    fn may_leave_bones_still() {
        let columns = Columns::new(small()).without(&[BoneId(3), BoneId(1), BoneId(2), BoneId(3)]);
        assert_eq!(columns.still(), [BoneId(1), BoneId(3)], "the second bone has no dofs anyway");
        assert_eq!((columns.range(BoneId(1)), columns.range(BoneId(4))), (6..6, 6..7));
        assert_eq!(columns.channels(BoneId(4)), [Position(Z)]);
        assert_eq!((columns.range(BoneId(5)), columns.range(BoneId(99))), (0..0, 0..0));
        let moved = motion(columns.clone(), 1).posture(0);
        assert_eq!((moved.angles[1], moved.angles[3]), ([0.0; 3], [0.0; 3]));
        assert_eq!(moved.translations[4], Vec3::Z * 7.0);
        assert_eq!(motion(Columns::new(small()).without(&[]), 0).columns(), &Columns::new(small()));
        assert_eq!(Motion::new(columns, 0, vec![]).unwrap().columns(), &Columns::new(small()));
    }

    #[test]
    fn may_turn_every_moving_bone_about_all_axes() {
        let columns = Columns::new(small()).with_three_angles();
        assert_eq!(columns.channels(BoneId(0)), Columns::new(small()).channels(BoneId(0)));
        assert_eq!(columns.channels(BoneId(1)), [Rotation(X), Rotation(Z), Rotation(Y)]);
        assert_eq!(columns.channels(BoneId(2)), []);
        assert_eq!(columns.channels(BoneId(4)), [Position(Z), Rotation(X), Rotation(Y), Rotation(Z)]);
        assert_eq!(motion(columns, 1).posture(0).angles[1], [7.0, 9.0, 8.0]);
    }

    #[test]
    fn must_have_as_many_numbers_as_frames_times_columns() {
        let error = Motion::new(Columns::new(small()), 2, vec![0.0; 19]).unwrap_err();
        assert_eq!((error.frames, error.channels, error.values), (2, 10, 19));
    }
}

/// The product of the rotations about a bone's own axes.
fn own_rotation(order: RotationOrder, angles: [f32; 3]) -> Quat {
    let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), angles[axis.index()].to_radians());
    order.axes().map_or(Quat::IDENTITY, |[a, b, c]| turn(a) * turn(b) * turn(c))
}

/// Where the bones end: each turned about the world's axes against its rest pose.
fn ends_by_axes(skeleton: &Skeleton, posture: &Posture) -> Vec<Vec3> {
    let mut placed: Vec<(Quat, Vec3)> = Vec::new();
    for bone in skeleton.bones() {
        let (above, start) = bone.parent.map_or((Quat::IDENTITY, Vec3::ZERO), |parent| placed[parent.0]);
        let c = bone.axis_rotation;
        let turned = above * c * own_rotation(bone.rotation_order, posture.angles[bone.id.0]) * c.inverse();
        placed.push((turned, start + turned * bone.rest_vector() + posture.translations[bone.id.0]));
    }
    placed.into_iter().map(|(_, end)| end).collect()
}

/// Where the bones end: each in its own axes.
fn ends_by_frames(skeleton: &Skeleton, posture: &Posture) -> Vec<Vec3> {
    let mut placed: Vec<(Quat, Vec3)> = Vec::new();
    for bone in skeleton.bones() {
        let (above, start) = bone.parent.map_or((Quat::IDENTITY, Vec3::ZERO), |parent| placed[parent.0]);
        let own = own_rotation(bone.rotation_order, posture.angles[bone.id.0]);
        let turned = above * bone.rot_parent_current * own;
        let along = bone.length * bone.local_direction;
        placed.push((turned, start + turned * along + posture.translations[bone.id.0]));
    }
    placed.into_iter().map(|(_, end)| end).collect()
}

fn any_axes() -> impl Strategy<Value = LocalAxes> {
    (prop::array::uniform3(-200f32..200.0), prop::sample::select(RotationOrder::ROTATING.to_vec()))
        .prop_map(|(angles, order)| LocalAxes { angles, order })
}

/// A bone, and on which of those before it hangs.
fn any_bone() -> impl Strategy<Value = (prop::sample::Index, BoneData)> {
    let channels: Vec<Channel> =
        Axis::ALL.into_iter().flat_map(|axis| [Rotation(axis), Position(axis)]).collect();
    let dofs = (Just(channels).prop_shuffle(), 0usize..=6).prop_map(|(all, count)| dofs(&all[..count]));
    (any::<prop::sample::Index>(), prop::array::uniform3(-1f32..1.0), 0f32..5.0, any_axes(), dofs).prop_map(
        |(parent, direction, length, axis, dofs)| {
            let direction = Vec3::from_array(direction).normalize_or(Vec3::Y);
            (parent, BoneData { name: String::new(), direction, length, axis, dofs })
        },
    )
}

proptest! {
    #[test]
    fn both_ways_of_placing_bones_agree(
        orientation in any_axes(),
        plan in prop::collection::vec(any_bone(), 1..10),
        values in prop::collection::vec(-200f32..200.0, 66),
    ) {
        let mut skeleton = Skeleton::new(Root { orientation, ..Root::default() }).unwrap();
        for (parent, data) in plan {
            let name = format!("bone{}", skeleton.len());
            let parent = BoneId(parent.index(skeleton.len()));
            skeleton.add_bone(parent, BoneData { name, ..data }).unwrap();
        }
        let columns = Columns::new(skeleton.clone());
        let values = values[..columns.len()].to_vec();
        let motion = Motion::new(columns, 1, values).unwrap();
        let posture = motion.posture(0);
        let (one, other) = (ends_by_axes(&skeleton, &posture), ends_by_frames(&skeleton, &posture));
        for (one, other) in one.into_iter().zip(other) {
            prop_assert!(one.abs_diff_eq(other, 1e-3), "{one} {other}");
        }
        // At rest the bones are where their directions put them, whatever their axes.
        let rest = ends_by_axes(&skeleton, &Posture::rest(&skeleton));
        for (one, other) in rest.into_iter().zip(skeleton.rest_ends()) {
            prop_assert!(one.abs_diff_eq(other, 1e-4), "{one} {other}");
        }
    }
}
