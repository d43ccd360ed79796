//! Acclaim forward kinematics: a bone, and the three parts.

#[cfg(test)]
mod tests;

use exam::acclaim::Given;
use glam::{Quat, Vec3};
use grading::fk::POSITION_TOLERANCE;
use parser::angles::rotation_of;
use skeleton::acclaim::{Bone, BoneId, BonePlace, Posture, Skeleton};

use super::same;

/// What a student's functions made of one frame, and what they were given.
#[derive(Clone, Copy)]
pub struct Case<'a> {
    /// The skeleton.
    pub skeleton: &'a Skeleton,
    /// The frame's angles and translations.
    pub posture: &'a Posture,
    /// Where the functions put each bone; nothing where it was not visited.
    pub given: &'a [Option<BonePlace>],
    /// Where the right functions put it.
    pub expected: &'a [Option<BonePlace>],
    /// The bones in the order in which part 3 visits them; `None` until it is known.
    pub visits: Option<&'a [BoneId]>,
    /// The size of the skeleton, by which distances are judged.
    pub size: f32,
}

/// Whose fault it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blame {
    /// Nobody's: the bone is right.
    Nobody,
    /// Nobody's: the bone has a length and is in its place, and so are all above it, but its rotation is another than
    /// expected. It is counted from the rest pose, or it is not.
    InPlace {
        /// Whether it is.
        from_rest: bool,
    },
    /// Nobody's: the bone and all above it are turned in the order that the file lists, which is another than the
    /// exercise's.
    OtherOrder,
    /// The bone's own.
    Own(Wrong),
    /// Part 3's, which does not visit the bone.
    NotVisited,
    /// Part 3's, which visits the bone and not its parent.
    WithoutParent(BoneId),
    /// Part 3's, which visits the bone before its parent.
    BeforeParent(BoneId),
    /// That of parts 1 and 2, or of part 3: which of them is known when part 3 has been asked by itself.
    Unclear,
    /// That of a bone above it; the nearest one that is itself to blame.
    Above(BoneId),
}

/// What of a bone is wrong, given what its parts were given. Part 1 makes its rotation, part 2 its start and its end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wrong {
    /// Its rotation.
    pub rotation: bool,
    /// Its start.
    pub start: bool,
    /// Its end.
    pub end: bool,
}

impl Wrong {
    fn is_any(self) -> bool {
        self != Wrong::default()
    }

    fn count(self) -> usize {
        [self.rotation, self.start, self.end].map(usize::from).iter().sum()
    }
}

/// A way to write parts 1 and 2 that puts all bones in their places.
struct Way {
    rotation: fn(&Bone, [f32; 3], Quat) -> Quat,
    ends: fn(&Bone, Quat, Vec3, Vec3) -> (Vec3, Vec3),
}

/// The one that the exercise is about.
const USUAL: Way = Way { rotation: solutions::ACCLAIM.bone_rotation, ends: solutions::ACCLAIM.bone_ends };

/// The same for files that list degrees of freedom in another order.
const OTHER_ORDER: Way = Way {
    rotation: |bone, angles, parent| parent * bone.rot_parent_current * in_order(bone, angles),
    ..USUAL
};

/// Rotations are counted from the rest pose, and not from the bone's own axes: the handout's other formula.
const FROM_REST: Way = Way {
    rotation: |bone, angles, parent| {
        let turn = (solutions::ACCLAIM.bone_rotation)(bone, angles, bone.rot_parent_current.inverse());
        parent * bone.axis_rotation * turn * bone.axis_rotation.inverse()
    },
    ends: |bone, rotation, parent_end, translation| {
        (parent_end, parent_end + rotation * bone.rest_vector() + translation)
    },
};

/// The usual one comes first: where several explain an answer as well, it is meant.
const WAYS: [Way; 3] = [USUAL, OTHER_ORDER, FROM_REST];

/// The three rotations about the bone's axes, in the order of its file.
fn in_order(bone: &Bone, angles: [f32; 3]) -> Quat {
    let Some(axes) = bone.rotation_order.axes() else { return Quat::IDENTITY };
    rotation_of(&axes, axes.map(|axis| angles[axis.index()]))
}

/// Who is to blame for where `bone` is and how it is turned.
pub fn blame(case: &Case, bone: BoneId) -> Blame {
    let chain = || std::iter::successors(case.skeleton.get(bone), |bone| case.skeleton.get(bone.parent?));
    if chain().all(|bone| case.is_in_place(bone.id)) {
        let found = case.rotation_of_one_in_place(bone);
        // A bone without length, such as the root, is in its place however it is turned.
        let has_length = case.skeleton.get(bone).is_some_and(|bone| bone.length > 0.0);
        if has_length || found != (Blame::InPlace { from_rest: false }) {
            return found;
        }
    }
    for judged in chain() {
        match case.own(judged) {
            None => {}
            Some(own) if judged.id == bone => return own,
            Some(_) => return Blame::Above(judged.id),
        }
    }
    if chain().all(|bone| case.wrong(bone, &OTHER_ORDER).is_some_and(|wrong| !wrong.is_any())) {
        return Blame::OtherOrder;
    }
    // Each bone would be right by some way, but not all of them by the same one.
    for judged in chain() {
        match case.wrong(judged, &USUAL) {
            Some(wrong) if wrong.is_any() && judged.id == bone => return Blame::Own(wrong),
            Some(wrong) if wrong.is_any() => return Blame::Above(judged.id),
            _ => {}
        }
    }
    Blame::Nobody
}

impl Case<'_> {
    fn place(&self, bone: BoneId) -> Option<BonePlace> {
        self.given.get(bone.0).copied().flatten()
    }

    /// Whether the bone starts and ends where it should.
    fn is_in_place(&self, bone: BoneId) -> bool {
        let expected = self.expected.get(bone.0).copied().flatten();
        self.place(bone).zip(expected).is_some_and(|(given, expected)| {
            self.is_near(given.start, expected.start) && self.is_near(given.end, expected.end)
        })
    }

    fn is_near(&self, given: Vec3, right: Vec3) -> bool {
        given.distance(right) <= POSITION_TOLERANCE * self.size
    }

    fn rotation_of_one_in_place(&self, bone: BoneId) -> Blame {
        let expected = self.expected.get(bone.0).copied().flatten();
        let (Some(given), Some(expected)) = (self.place(bone), expected) else { return Blame::Nobody };
        if same(given.rotation, expected.rotation) {
            return Blame::Nobody;
        }
        let from_rest = |bone: &Bone| same(given.rotation, expected.rotation * bone.axis_rotation.inverse());
        Blame::InPlace { from_rest: self.skeleton.get(bone).is_some_and(from_rest) }
    }

    /// What is wrong with a bone by itself, given what its parts were given.
    fn own(&self, bone: &Bone) -> Option<Blame> {
        if self.place(bone.id).is_none() {
            return Some(Blame::NotVisited);
        }
        if let Some(parent) = bone.parent {
            if self.place(parent).is_none() {
                return Some(Blame::WithoutParent(parent));
            }
            if self.visits.is_some_and(|visits| is_early(visits, bone.id, parent)) {
                return Some(Blame::BeforeParent(parent));
            }
        }
        let wrong = WAYS.iter().filter_map(|way| self.wrong(bone, way)).min_by_key(|wrong| wrong.count())?;
        // Without its parent it would have been on the origin.
        let on_origin = || self.wrong_on(bone, None, &USUAL).is_some_and(|wrong| !wrong.is_any());
        match wrong.is_any() {
            false => None,
            true if self.visits.is_none() && on_origin() => Some(Blame::Unclear),
            true => Some(Blame::Own(wrong)),
        }
    }

    /// What is wrong with a bone by one way to write the parts. Nothing for one that has no place.
    fn wrong(&self, bone: &Bone, way: &Way) -> Option<Wrong> {
        self.wrong_on(bone, bone.parent.and_then(|parent| self.place(parent)), way)
    }

    fn wrong_on(&self, bone: &Bone, parent: Option<BonePlace>, way: &Way) -> Option<Wrong> {
        let place = self.place(bone.id)?;
        let Given { angles, parent, parent_end, translation } = Given::new(bone, self.posture, parent);
        let (start, end) = (way.ends)(bone, place.rotation, parent_end, translation);
        // What is made of no numbers is handed on, and not made here.
        let is_off = |given: Vec3, right: Vec3| {
            !self.is_near(given, right) && (given.is_finite() || right.is_finite())
        };
        Some(Wrong {
            rotation: !same(place.rotation, (way.rotation)(bone, angles, parent)),
            start: is_off(place.start, start),
            end: is_off(place.end, end),
        })
    }
}

/// Whether `bone` was last visited before its parent was for the first time.
fn is_early(visits: &[BoneId], bone: BoneId, parent: BoneId) -> bool {
    let last = visits.iter().rposition(|visit| *visit == bone);
    let first = visits.iter().position(|visit| *visit == parent);
    last.zip(first).is_some_and(|(bone, parent)| bone < parent)
}
