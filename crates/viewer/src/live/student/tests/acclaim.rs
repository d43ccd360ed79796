//! Functions that move bones.

use skeleton::acclaim::{AcclaimFunctions, Bone, Skeleton, Visitor};

use super::*;

fn walk() -> Arc<Stage> {
    samples::walk()
}

fn student(functions: AcclaimFunctions) -> Student {
    let open = move |_: &Version| Ok(InProcess(Functions::Acclaim(functions)));
    Student::start(Mover::Acclaim, vec![walk()], open, quiet)
}

/// Waits until frame `frame` is known to fail, and where.
fn told(student: &mut Student, frame: usize) -> Arc<Trouble> {
    let with_place =
        |student: &Student| trouble(student, 0, frame).filter(|trouble| trouble.details.len() > 1);
    update_until(student, &[frame], |student| with_place(student).is_some());
    with_place(student).unwrap()
}

#[test]
fn the_answers_are_those_of_the_functions_in_every_frame() {
    let (stage, mut student) = (walk(), student(solutions::ACCLAIM));
    for frame in (0..480).step_by(37) {
        update_until(&mut student, &[5], is_current(0, frame));
        let posed = student.pose(0, frame).unwrap();
        let bones = stage.bones().unwrap();
        assert_eq!(posed.places().unwrap(), bones.reference(&stage.posture(frame)));
        for (own, right) in posed.pose.transforms().iter().zip(stage.reference(frame).transforms()) {
            assert!(own.position.distance(right.position) < 1e-3);
        }
    }
    update_until(&mut student, &[5], |student| student.standing(0, 5).board.is_some());
    assert_eq!(student.standing(0, 5).board.unwrap().title, "Acclaim forward kinematics: 15 of 15 points.");
}

#[test]
fn the_template_visits_the_root() {
    let mut student = student(grading::acclaim::TEMPLATE);
    update_until(&mut student, &[0], is_current(0, 0));
    let posed = student.pose(0, 0).unwrap();
    assert_eq!(posed.places().unwrap().iter().flatten().count(), 1);
    assert!(posed.pose.transforms()[0].position.is_finite());
    // It is asked for when it is wanted.
    assert_eq!(student.details(0, 0), None);
    update_until(&mut student, &[0], |student| student.known_details(0, 0).is_some());
    assert_eq!(student.details(0, 0), Some(&Details::Visits(vec![skeleton::acclaim::BoneId::ROOT])));
}

#[test]
fn a_batch_of_frames_with_bones_takes_no_more_memory_than_one_with_joints() {
    let stage = walk();
    let size = |frames: usize, posed: usize| frames * posed;
    let joints = stage.motion().skeleton().len();
    let of_joints = size_of::<skeleton::Transform>() * joints;
    let bones = stage.bones().unwrap().motion().skeleton().len();
    let of_bones = of_joints + size_of::<Option<skeleton::acclaim::BonePlace>>() * bones;
    let frames = |mover: Mover| plan::JOINTS_PER_BATCH / mover.frame_size(&stage);
    assert!(size(frames(Mover::Acclaim), of_bones) <= size(frames(Mover::Fk), of_joints) + of_bones);
}

/// The one bone at which the functions below fail.
const BAD: &str = "rtibia";

#[test]
fn a_panic_is_told_with_its_bone_and_its_part() {
    fn part1(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
        assert!(bone.name != BAD, "not this one");
        (solutions::ACCLAIM.bone_rotation)(bone, angles, parent)
    }
    fn part2(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
        assert!(bone.name != BAD, "not this one");
        (solutions::ACCLAIM.bone_ends)(bone, rotation, parent_end, translation)
    }
    fn part3(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        assert!(bone.name != BAD, "not this one");
        visitor.visit(bone);
        skeleton.children(bone.id).for_each(|child| part3(skeleton, child, visitor));
    }
    let right = solutions::ACCLAIM;
    for (functions, part) in [
        (AcclaimFunctions { bone_rotation: part1, ..right }, "in part1, bone_rotation"),
        (AcclaimFunctions { bone_ends: part2, ..right }, "in part2, bone_ends"),
        (AcclaimFunctions { visit_bones: part3, ..right }, "in part3, visit_bones"),
    ] {
        let trouble = told(&mut student(functions), 7);
        assert!(trouble.headline.contains("not this one"), "{trouble:?}");
        assert_eq!(trouble.details, ["at bone rtibia, in frame 7", part]);
    }
}

#[test]
fn a_panic_in_one_frame_leaves_all_others() {
    fn part1(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
        // In frame 118, and in no other, the knee is bent like this.
        assert!(bone.name != BAD || angles[0] != 8.0938, "bent like this?");
        (solutions::ACCLAIM.bone_rotation)(bone, angles, parent)
    }
    let mut student = student(AcclaimFunctions { bone_rotation: part1, ..solutions::ACCLAIM });
    for frame in (0..480).filter(|frame| *frame != 118) {
        update_until(&mut student, &[5], is_current(0, frame));
    }
    assert_eq!(told(&mut student, 118).details, ["at bone rtibia, in frame 118", "in part1, bone_rotation"]);
}

#[test]
fn where_part_3_fails_for_every_bone_none_is_told() {
    fn unfinished(_: &Skeleton, _: &Bone, _: &mut Visitor) {
        panic!("later");
    }
    let functions = AcclaimFunctions { visit_bones: unfinished, ..solutions::ACCLAIM };
    let trouble = told(&mut student(functions), 0);
    assert_eq!(trouble.details, ["in frame 0", "in part3, visit_bones"]);
}

/// The solution, but fails as a process does that is ended when part 3 begins with one of some bones.
struct Loops {
    failure: Failure,
    is_bad: fn(&Bone) -> bool,
}

impl Subject for Loops {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        use exam::acclaim::Question::{Places, Visits};
        let fails = match question {
            Question::Acclaim(Visits { skeleton, bone }) => {
                // What hangs on the bone is met on the way.
                let is_below = |id: skeleton::acclaim::BoneId| {
                    std::iter::successors(Some(id), |id| skeleton[*id].parent).any(|above| above == *bone)
                };
                skeleton.bones().iter().any(|other| is_below(other.id) && (self.is_bad)(other))
            }
            Question::Acclaim(Places { postures, .. }) => !postures.is_empty(),
            _ => false,
        };
        match fails {
            true => Err(self.failure.clone()),
            false => InProcess(Functions::Acclaim(solutions::ACCLAIM)).ask(question, limit),
        }
    }
}

#[test]
fn an_endless_loop_or_recursion_in_part_3_is_told_with_its_bone_where_that_is_clear() {
    let timed_out = Failure::TimedOut { limit: Duration::from_secs(2) };
    let crashed = Failure::Crashed { how: "signal 6".into() };
    for failure in [timed_out, crashed] {
        for (is_bad, at) in [
            // It never goes on from this bone,
            ((|bone| bone.name == "rfoot") as fn(&Bone) -> bool, "at bone rfoot, in frame 3"),
            // or from one on which nothing hangs.
            (|bone| bone.name == "rtoes", "at bone rtoes, in frame 3"),
            (|bone| bone.is_root(), "at bone root, in frame 3"),
            // It calls itself for the same bone,
            (|_| true, "in frame 3"),
            // or for every bone on which others hang.
            (|bone| bone.child.is_some(), "in frame 3"),
        ] {
            let failure = failure.clone();
            let mut left = Some(Loops { failure: failure.clone(), is_bad });
            let open = move |_: &Version| Ok(left.take().unwrap());
            let mut student = Student::start(Mover::Acclaim, vec![walk()], open, quiet);
            let trouble = told(&mut student, 3);
            assert_eq!(trouble.details, [at, "in part3, visit_bones"]);
            assert_eq!(trouble.headline, failure.to_string().lines().next().unwrap());
        }
    }
}

/// The solution, but that it fails when it is asked for bones in a chain. It counts what it is asked.
struct Chained {
    failure: Failure,
    is_bad: fn(&exam::acclaim::Question) -> bool,
    asked: usize,
}

impl Subject for Chained {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        if let Question::Acclaim(question) = question {
            self.asked += 1;
            if (self.is_bad)(question) {
                return Err(self.failure.clone());
            }
        }
        InProcess(Functions::Acclaim(solutions::ACCLAIM)).ask(question, limit)
    }
}

/// A question that is not answered takes as long as may be, and one about a large skeleton takes long, too.
#[test]
fn the_bone_is_not_looked_for_without_end() {
    use exam::acclaim::Question::{Rotation, Visits};
    use narrow::Place;
    let timed_out = Failure::TimedOut { limit: Duration::from_secs(2) };
    let panicked = Failure::Panicked { message: "no".into(), location: None };
    let visits: fn(&exam::acclaim::Question) -> bool = |question| matches!(question, Visits { .. });
    let tip: fn(&exam::acclaim::Question) -> bool = |question| match question {
        Rotation { skeleton, bone, .. } => bone.0 + 1 == skeleton.len(),
        _ => false,
    };
    let part3 = Place { part: Some(2), ..Place::default() };
    for (bones, failure, is_bad, place, most) in [
        (100, &timed_out, visits, &part3, 15),
        (600, &timed_out, visits, &part3, 1),
        (600, &panicked, visits, &part3, 1),
        (600, &panicked, tip, &Place::default(), 1),
    ] {
        let mut subject = Chained { failure: failure.clone(), is_bad, asked: 0 };
        let stage = samples::stage_of_bones(bones);
        assert_eq!(narrow::find(Mover::Acclaim, &mut subject, &stage, 0, failure), *place);
        assert!(subject.asked <= most, "{} questions about {bones} bones", subject.asked);
    }
    // A panic costs nothing, however deep it is.
    let mut subject = Chained { failure: panicked.clone(), is_bad: tip, asked: 0 };
    let found = narrow::find(Mover::Acclaim, &mut subject, &samples::stage_of_bones(100), 0, &panicked);
    assert_eq!(found, Place { at: Some("bone bone99".into()), part: Some(0), cause: None });
}

#[test]
fn an_answer_with_bones_missing_is_no_answer() {
    struct Short;
    impl Subject for Short {
        fn ask(&mut self, question: &Question, _: Duration) -> Result<Answer, Failure> {
            let Question::Acclaim(exam::acclaim::Question::Places { postures, .. }) = question else {
                return Ok(Answer::NotMine);
            };
            Ok(Answer::Acclaim(exam::acclaim::Answer::Places(vec![vec![None; 3]; postures.len()])))
        }
    }
    assert!(matches!(ask(Mover::Acclaim, &mut Short, &walk(), 0..1), Err(Failure::Unreadable { .. })));
}

#[test]
fn a_motion_that_could_not_be_read_yet_is_no_reason_to_fail() {
    let stage = crate::motion::source::nothing();
    let mut subject = InProcess(Functions::Acclaim(solutions::ACCLAIM));
    let posed = ask(Mover::Acclaim, &mut subject, &stage, 0..1).unwrap();
    assert!(posed[0].pose.is_empty());
    let frame = ask::details(Mover::Acclaim, &mut subject, &stage, 0, PATIENCE);
    assert_eq!(frame, Ok(Details::Visits(Vec::new())));
}
