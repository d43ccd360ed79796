//! The exercise on Acclaim forward kinematics: what can be asked of its three functions.

use glam::{Quat, Vec3};
use serde::{Deserialize, Serialize};
use skeleton::acclaim::{AcclaimFunctions, Bone, BoneId, BonePlace, Posture, Skeleton, Visitor};

/// A question to one of the three functions, or to all of them together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Part 1, asked for one bone.
    Rotation {
        /// The skeleton of the bone.
        skeleton: Skeleton,
        /// The bone.
        bone: BoneId,
        /// Its angles about its own X, Y and Z axis, in degrees.
        angles: [f32; 3],
        /// How its parent is turned in the world.
        parent: Quat,
    },
    /// Part 2, asked for one bone.
    Ends {
        /// The skeleton of the bone.
        skeleton: Skeleton,
        /// The bone.
        bone: BoneId,
        /// How it is turned in the world.
        rotation: Quat,
        /// Where its parent ends, in the world.
        parent_end: Vec3,
        /// By how much its end is moved.
        translation: Vec3,
    },
    /// Part 3.
    Visits {
        /// The skeleton whose bones are visited.
        skeleton: Skeleton,
        /// The bone to begin with.
        bone: BoneId,
    },
    /// All three parts together, over several frames.
    Places {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// The frames.
        postures: Vec<Posture>,
    },
}

/// The answer to a [`Question`] of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// The rotation in the world.
    Rotation(Quat),
    /// Start and end in the world.
    Ends(Vec3, Vec3),
    /// The bones in the order of their visits, up to twice as many as there are and one more.
    Visits(Vec<BoneId>),
    /// For every frame the places of all bones; nothing for a bone that was not visited.
    Places(Vec<Vec<Option<BonePlace>>>),
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &AcclaimFunctions) -> Answer {
        match self {
            Question::Rotation { skeleton, bone, angles, parent } => {
                Answer::Rotation((functions.bone_rotation)(known(skeleton, *bone), *angles, *parent))
            }
            Question::Ends { skeleton, bone, rotation, parent_end, translation } => {
                let bone = known(skeleton, *bone);
                let (start, end) = (functions.bone_ends)(bone, *rotation, *parent_end, *translation);
                Answer::Ends(start, end)
            }
            Question::Visits { skeleton, bone } => {
                let mut visited = Vec::new();
                let mut see = |bone: &Bone| {
                    if visited.len() <= 2 * skeleton.len() {
                        visited.push(bone.id);
                    }
                };
                (functions.visit_bones)(skeleton, known(skeleton, *bone), &mut Visitor::new(&mut see));
                Answer::Visits(visited)
            }
            Question::Places { skeleton, postures } => {
                Answer::Places(postures.iter().map(|posture| places(skeleton, posture, functions)).collect())
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire.
    pub(crate) fn answer_limit(&self) -> usize {
        // Whether there is anything, a rotation and two positions.
        const PER_BONE: usize = 41;
        let bones = match self {
            Question::Rotation { .. } | Question::Ends { .. } => 1,
            Question::Visits { skeleton, .. } => 2 * skeleton.len() + 1,
            Question::Places { skeleton, postures } => (skeleton.len() + 1) * postures.len(),
        };
        1024 + PER_BONE * bones
    }
}

/// The bone, or the root where a question names none that is there.
fn known(skeleton: &Skeleton, bone: BoneId) -> &Bone {
    skeleton.get(bone).unwrap_or(skeleton.root())
}

/// What parts 1 and 2 are given for a bone while a posture is worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given {
    /// Its angles about its own X, Y and Z axis, in degrees.
    pub angles: [f32; 3],
    /// How its parent is turned in the world.
    pub parent: Quat,
    /// Where its parent ends, in the world.
    pub parent_end: Vec3,
    /// By how much its end is moved.
    pub translation: Vec3,
}

impl Given {
    /// For `bone` in `posture`, when `parent` is the place of its parent; nothing for one that was not visited before, so
    /// that the bone hangs on the origin.
    pub fn new(bone: &Bone, posture: &Posture, parent: Option<BonePlace>) -> Given {
        let id = bone.id.0;
        let angles = posture.angles.get(id).copied().unwrap_or_default();
        let translation = posture.translations.get(id).copied().unwrap_or_default();
        // The root starts and ends where its translation says. Everything else hangs on its parent.
        let (parent, parent_end, translation) = match bone.parent {
            Some(_) => {
                let parent = parent.unwrap_or(BonePlace::ORIGIN);
                (parent.rotation, parent.end, translation)
            }
            None => (Quat::IDENTITY, translation, Vec3::ZERO),
        };
        Given { angles, parent, parent_end, translation }
    }
}

/// Where `functions` put all bones in `posture`: `visit_bones` decides which ones are worked out, and when. Nothing for a bone
/// that is not visited; what hangs on one that was not visited before hangs on the origin. A panic of theirs goes through.
pub fn places(
    skeleton: &Skeleton,
    posture: &Posture,
    functions: &AcclaimFunctions,
) -> Vec<Option<BonePlace>> {
    let mut places = Vec::new();
    read_places(skeleton, posture, functions, &mut places);
    places
}

/// The same, into `places`, whose memory is used again.
pub fn read_places(
    skeleton: &Skeleton,
    posture: &Posture,
    functions: &AcclaimFunctions,
    places: &mut Vec<Option<BonePlace>>,
) {
    places.clear();
    places.resize(skeleton.len(), None);
    let mut see = |bone: &Bone| {
        // A bone that somebody has made up can have any parent.
        let parent = bone.parent.and_then(|parent| places.get(parent.0).copied().flatten());
        let Given { angles, parent, parent_end, translation } = Given::new(bone, posture, parent);
        let rotation = (functions.bone_rotation)(bone, angles, parent);
        let (start, end) = (functions.bone_ends)(bone, rotation, parent_end, translation);
        if let Some(place) = places.get_mut(bone.id.0) {
            *place = Some(BonePlace { rotation, start, end });
        }
    };
    (functions.visit_bones)(skeleton, skeleton.root(), &mut Visitor::new(&mut see));
}
