//! The three functions of the exercise on Acclaim forward kinematics, asked by themselves and together.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::time::Duration;

use exam::acclaim::{Answer, Question};
use exam::{Functions, InProcess, Subject};
use glam::{Quat, Vec3};
use skeleton::acclaim::{
    AcclaimFunctions, Bone, BoneData, BoneId, BonePlace, Posture, Root, Skeleton, Visitor,
};

/// Functions whose answers depend on all that they are given. Right answers have no place beside a worker.
const PLAIN: AcclaimFunctions = AcclaimFunctions {
    bone_rotation: |bone, [x, y, z], parent| Quat::from_xyzw(x, y, z, bone.length) + parent,
    bone_ends: |bone, rotation, parent_end, translation| {
        let way = Vec3::new(rotation.x, rotation.w, bone.length);
        (parent_end - translation, parent_end + way + 2.0 * translation)
    },
    visit_bones,
};

fn visit_bones(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
    visitor.visit(bone);
    skeleton.children(bone.id).for_each(|child| visit_bones(skeleton, child, visitor));
}

/// root — a — b
///      ╲ c
fn small() -> Skeleton {
    let mut skeleton = Skeleton::new(Root { position: Vec3::X, ..Root::default() }).unwrap();
    for (name, parent, length) in [("a", 0, 2.0), ("b", 1, 3.0), ("c", 0, 5.0)] {
        let bone = BoneData { name: name.into(), direction: Vec3::Y, length, ..BoneData::default() };
        skeleton.add_bone(BoneId(parent), bone).unwrap();
    }
    skeleton
}

/// Every number is another one.
fn posture(frame: usize) -> Posture {
    let number = |id: usize, at: usize| (100 * frame + 10 * id + at) as f32;
    Posture {
        angles: (0..4).map(|id| [0, 1, 2].map(|axis| number(id, axis))).collect(),
        translations: (0..4).map(|id| Vec3::from([3, 4, 5].map(|axis| number(id, axis)))).collect(),
    }
}

fn all_questions() -> [Question; 4] {
    let rotation = Quat::from_xyzw(0.5, -0.5, 0.5, 0.5);
    [
        Question::Rotation {
            skeleton: small(),
            bone: BoneId(2),
            angles: [10.0, -20.0, 30.0],
            parent: rotation,
        },
        Question::Ends {
            skeleton: small(),
            bone: BoneId(3),
            rotation,
            parent_end: Vec3::new(1.0, 2.0, 3.0),
            translation: Vec3::new(0.5, 0.25, 0.0),
        },
        Question::Visits { skeleton: small(), bone: BoneId(1) },
        Question::Places { skeleton: small(), postures: vec![posture(0), posture(1)] },
    ]
}

fn ids(ids: &[usize]) -> Answer {
    Answer::Visits(ids.iter().copied().map(BoneId).collect())
}

fn places(visit_bones: fn(&Skeleton, &Bone, &mut Visitor)) -> Vec<Vec<Option<BonePlace>>> {
    let question = Question::Places { skeleton: small(), postures: vec![posture(0), posture(1)] };
    match question.ask(&AcclaimFunctions { visit_bones, ..PLAIN }) {
        Answer::Places(places) => places,
        other => panic!("{other:?}"),
    }
}

#[test]
fn each_function_is_given_what_was_asked() {
    let [rotation, ends, visits, _] = all_questions().map(|question| question.ask(&PLAIN));
    assert_eq!(rotation, Answer::Rotation(Quat::from_xyzw(10.5, -20.5, 30.5, 3.5)));
    assert_eq!(ends, Answer::Ends(Vec3::new(0.5, 1.75, 3.0), Vec3::new(2.5, 3.0, 8.0)));
    assert_eq!(visits, ids(&[1, 2]));
}

#[test]
fn together_they_are_chained_from_the_root_on() {
    let (skeleton, all) = (small(), places(visit_bones));
    assert_eq!(all.len(), 2);
    for (frame, places) in all.iter().enumerate() {
        let Posture { angles, translations } = posture(frame);
        assert_eq!(places.len(), skeleton.len());
        for bone in skeleton.bones() {
            let id = bone.id.0;
            // The root stands where its translation says; all others begin at their parents.
            let (parent, from, moved) = match bone.parent {
                None => (Quat::IDENTITY, translations[0], Vec3::ZERO),
                Some(parent) => {
                    let parent = places[parent.0].unwrap();
                    (parent.rotation, parent.end, translations[id])
                }
            };
            let rotation = (PLAIN.bone_rotation)(bone, angles[id], parent);
            let (start, end) = (PLAIN.bone_ends)(bone, rotation, from, moved);
            assert_eq!(places[id], Some(BonePlace { rotation, start, end }), "{frame}, {}", bone.name);
        }
    }
}

#[test]
fn who_is_not_visited_has_no_place_and_who_comes_too_early_finds_the_parent_at_the_origin() {
    let places = places(|skeleton, _, visitor| {
        visitor.visit(&skeleton[BoneId(2)]);
        visitor.visit(&skeleton[BoneId(1)]);
    });
    let frame = &places[0];
    assert_eq!([frame[0], frame[3]], [None; 2]);
    let rotation = Quat::from_xyzw(20.0, 21.0, 22.0, 4.0);
    let place = frame[2].unwrap();
    assert_eq!(place.rotation, rotation);
    assert_eq!(place.start, -Vec3::new(23.0, 24.0, 25.0));
    assert!(frame[1].is_some());
}

#[test]
fn a_posture_without_some_bones_leaves_them_as_they_are() {
    let postures = vec![Posture::default()];
    let Answer::Places(places) = Question::Places { skeleton: small(), postures }.ask(&PLAIN) else {
        panic!()
    };
    let place = BonePlace { rotation: Quat::IDENTITY, start: Vec3::ZERO, end: Vec3::Y };
    assert_eq!(places[0][0], Some(place));
}

/// What is kept of visits has a limit, whatever the function does.
#[test]
fn a_million_visits_take_no_more_memory_than_a_few() {
    fn often(_: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        (0..1_000_000).for_each(|_| visitor.visit(bone));
    }
    let functions = AcclaimFunctions { visit_bones: often, ..PLAIN };
    let question = Question::Visits { skeleton: small(), bone: BoneId(1) };
    // Twice as many as there are bones, and one more.
    assert_eq!(question.ask(&functions), ids(&[1; 9]));
    let Answer::Visits(visits) = question.ask(&functions) else { panic!() };
    assert!(visits.capacity() <= 16, "{}", visits.capacity());
    assert_eq!(places(often).len(), 2);
}

#[test]
fn a_bone_that_is_not_in_the_skeleton_is_the_root_in_a_question() {
    let skeleton = small();
    let visits = Question::Visits { skeleton: skeleton.clone(), bone: BoneId(4) };
    assert_eq!(visits.ask(&PLAIN), ids(&[0, 1, 2, 3]));
    let bone = BoneId(usize::MAX);
    let rotation = Question::Rotation { skeleton, bone, angles: [1.0; 3], parent: Quat::IDENTITY };
    assert_eq!(rotation.ask(&PLAIN), Answer::Rotation(Quat::from_xyzw(1.0, 1.0, 1.0, 1.0)));
}

#[test]
fn a_visit_of_a_bone_that_is_not_in_the_skeleton_does_no_harm() {
    fn made_up(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        let beyond = Some(BoneId(usize::MAX));
        visitor.visit(&Bone { id: BoneId(usize::MAX), parent: beyond, ..bone.clone() });
        visitor.visit(&Bone { id: BoneId(3), parent: beyond, ..bone.clone() });
        visitor.visit(skeleton.root());
    }
    let functions = AcclaimFunctions { visit_bones: made_up, ..PLAIN };
    let visits = Question::Visits { skeleton: small(), bone: BoneId(1) };
    assert_eq!(visits.ask(&functions), ids(&[usize::MAX, 3, 0]));
    let frame = &places(made_up)[0];
    assert_eq!(frame.len(), 4);
    assert!(frame[0].is_some_and(|root| root != BonePlace::ORIGIN));
    assert!(frame[3].is_some() && frame[1].is_none());
}

#[test]
fn questions_and_answers_are_the_same_after_a_journey() {
    for question in all_questions() {
        let bytes = postcard::to_stdvec(&question).unwrap();
        let arrived: Question = postcard::from_bytes(&bytes).unwrap();
        assert_eq!(arrived, question);
        let answer = arrived.ask(&PLAIN);
        let bytes = postcard::to_stdvec(&answer).unwrap();
        assert_eq!(postcard::from_bytes::<Answer>(&bytes).unwrap(), answer);
    }
}

#[test]
fn a_subject_answers_like_the_functions_and_knows_no_other_exercise() {
    let mut subject = InProcess(Functions::Acclaim(PLAIN));
    for question in all_questions() {
        let asked = exam::Question::Acclaim(question.clone());
        let answer = subject.ask(&asked, Duration::ZERO);
        assert_eq!(answer, Ok(exam::Answer::Acclaim(question.ask(&PLAIN))));
    }
    let other = exam::interpolation::Question::Slerp { from: Quat::IDENTITY, to: Quat::IDENTITY, t: 0.5 };
    let answer = subject.ask(&exam::Question::Interpolation(other), Duration::ZERO);
    assert_eq!(answer, Ok(exam::Answer::NotMine));
}
