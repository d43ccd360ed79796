//! Functions that warp time.

use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

use super::*;
use crate::motion::time_map::TimeMap;

/// The walk, and the same warped by `map`.
pub(super) fn pair(map: TimeMap) -> Vec<Arc<Stage>> {
    let walk = samples::walk();
    vec![walk.clone(), Arc::new(walk.warped(map))]
}

pub(super) fn whole(new: usize) -> TimeMap {
    TimeMap::Whole { old: 480, new }
}

pub(super) fn student(functions: TimeWarpFunctions, map: TimeMap) -> Student {
    let open = move |_: &Version| Ok(InProcess(Functions::TimeWarp(functions)));
    Student::start(Mover::TimeWarp, pair(map), open, quiet)
}

/// How far joints of a pose are from where the reference warps them, at most.
fn off(student: &Student, frame: usize, map: TimeMap) -> f32 {
    let right = samples::walk().warped(map).reference(frame);
    let pairs = student.pose(1, frame).unwrap().pose.transforms().iter().zip(right.transforms());
    pairs.map(|(own, right)| own.position.distance(right.position)).fold(0.0, f32::max)
}

#[test]
fn the_answers_are_those_of_the_functions_in_every_frame_and_the_original_is_not_asked_about() {
    for new in [240, 480, 960] {
        let mut student = student(solutions::TIME_WARP, whole(new));
        for frame in (0..new).step_by(61).chain([new - 1]) {
            update_until(&mut student, &[5, frame], is_current(1, frame));
            assert!(off(&student, frame, whole(new)) < 1e-2, "{new}: {frame}");
        }
        let at = whole(new).place(61);
        let place = Some(at);
        assert_eq!(student.pose(1, 61).unwrap().extra, Extra::Warp { given: Some(new), place, bones: None });
        update_until(&mut student, &[5, 0], |student| student.standing(1, 5).board.is_some());
        assert_eq!(student.standing(1, 5).board.unwrap().title, "Time warping: 15 of 15 points.");
        assert!(student.pose(0, 5).is_none());
    }
}

#[test]
fn frames_that_part_3_does_not_give_are_nowhere() {
    let mut student = student(grading::time_warp::TEMPLATE, whole(960));
    for (frame, is_there) in [(479, true), (480, false)] {
        update_until(&mut student, &[0, frame], is_current(1, frame));
        let posed = student.pose(1, frame).unwrap();
        let place = Some(Between { before: frame, after: frame, t: 0.0 });
        assert_eq!(posed.extra, Extra::Warp { given: Some(480), place, bones: None });
        assert_eq!(posed.pose.transforms()[0].position.is_finite(), is_there);
    }
}

fn fails(_: usize, _: usize, _: usize) -> Between {
    panic!("not part 1")
}

fn fails_too(_: &[Posture], _: usize) -> Vec<Posture> {
    panic!("not part 3")
}

#[test]
fn in_a_stretch_part_2_is_at_work_and_no_other() {
    let map = TimeMap::stretch(480, (100, 160), 200).unwrap();
    let functions = TimeWarpFunctions { old_position: fails, warp: fails_too, ..solutions::TIME_WARP };
    let mut student = student(functions, map);
    for frame in [0, 100, 101, 299, 300, 619] {
        update_until(&mut student, &[0, frame], is_current(1, frame));
        assert!(off(&student, frame, map) < 1e-2, "{frame}");
        assert_eq!(
            student.pose(1, frame).unwrap().extra,
            Extra::Warp { given: None, place: None, bones: None }
        );
    }
}

#[test]
fn of_a_million_frames_only_those_near_the_shown_one_are_asked_for() {
    let functions = TimeWarpFunctions { warp: fails_too, ..solutions::TIME_WARP };
    let mut student = student(functions, whole(1_000_000));
    for frame in [0, 777_777, 999_999] {
        update_until(&mut student, &[0, frame], is_current(1, frame));
        assert!(off(&student, frame, whole(1_000_000)) < 1e-2, "{frame}");
    }
    assert!(student.pose(1, 500_000).is_none());
}

#[test]
fn a_panic_is_told_with_its_part() {
    fn blend(_: &Posture, _: &Posture, _: f32) -> Posture {
        panic!("not part 2")
    }
    fn first(old: &[Posture], new: usize) -> Vec<Posture> {
        fails(0, old.len(), new);
        Vec::new()
    }
    let right = solutions::TIME_WARP;
    for (functions, part) in [
        (TimeWarpFunctions { old_position: fails, warp: first, ..right }, "in part1, old_position"),
        (TimeWarpFunctions { blend, warp: |_, _| panic!("not part 2"), ..right }, "in part2, blend"),
        (TimeWarpFunctions { warp: fails_too, ..right }, "in part3, warp"),
    ] {
        let mut student = student(functions, whole(960));
        let with_part =
            |student: &Student| trouble(student, 1, 7).filter(|trouble| trouble.details.len() > 1);
        update_until(&mut student, &[0, 7], |student| with_part(student).is_some());
        let trouble = with_part(&student).unwrap();
        assert!(trouble.headline.contains("not part "), "{trouble:?}");
        assert_eq!(trouble.details, ["while all 960 frames were made", part]);
        // All frames fail with it, and each is told when it is shown.
        update_until(&mut student, &[0, 700], |student| {
            super::trouble(student, 1, 700).is_some_and(|trouble| trouble.details.len() > 1)
        });
    }
}

#[test]
fn a_frame_that_part_1_names_and_that_is_not_there_is_told_as_the_cause() {
    fn behind(new_frame: usize, old: usize, new: usize) -> Between {
        let Between { before, t, .. } = (solutions::TIME_WARP.old_position)(new_frame, old, new);
        Between { before, after: before + 1, t }
    }
    let warp = |postures: &[Posture], new: usize| {
        let frame = |index| postures[behind(index, postures.len(), new).after].clone();
        (0..new).map(frame).collect()
    };
    let functions = TimeWarpFunctions { old_position: behind, warp, ..solutions::TIME_WARP };
    let mut student = student(functions, whole(960));
    let with_cause = |student: &Student| trouble(student, 1, 7).filter(|trouble| trouble.details.len() > 2);
    update_until(&mut student, &[0, 7], |student| with_cause(student).is_some());
    let cause = "part 1 names frame 480 for the new frame 958, and the last old frame is 479";
    assert_eq!(with_cause(&student).unwrap().details[2], cause);
}

#[test]
fn a_part_1_that_fails_costs_the_curve_and_nothing_else() {
    let functions = TimeWarpFunctions { old_position: fails, ..solutions::TIME_WARP };
    let mut student = student(functions, whole(960));
    update_until(&mut student, &[0, 7], is_current(1, 7));
    assert!(off(&student, 7, whole(960)) < 1e-2);
    assert_eq!(student.pose(1, 7).unwrap().extra, Extra::Warp { given: Some(960), place: None, bones: None });
}

#[test]
fn parts_1_and_2_are_asked_by_themselves_when_it_is_wanted() {
    // Half a frame late.
    let late =
        |new_frame, old, new| Between { t: 1.0, ..(solutions::TIME_WARP.old_position)(new_frame, old, new) };
    let functions = TimeWarpFunctions { old_position: late, ..solutions::TIME_WARP };
    let mut student = student(functions, whole(960));
    update_until(&mut student, &[0, 7], is_current(1, 7));
    assert_eq!(student.details(1, 7), None);
    update_until(&mut student, &[0, 7], |student| student.known_details(1, 7).is_some());
    let Some(Details::Blended { right, own: Some(own), .. }) = student.details(1, 7) else { panic!() };
    let root = |pose: &Pose| pose.transforms()[0].position;
    let walk = samples::walk();
    assert!(root(own).distance(root(&walk.reference(4))) < 1e-3);
    assert!(root(right).distance(root(&walk.warped(whole(960)).reference(7))) < 1e-3);
}

/// Each question about the whole motion takes as long as all its frames.
#[test]
fn functions_that_fail_are_not_asked_for_the_whole_motion_again_and_again() {
    static WHOLE: AtomicUsize = AtomicUsize::new(0);
    fn warp(_: &[Posture], _: usize) -> Vec<Posture> {
        WHOLE.fetch_add(1, Ordering::SeqCst);
        panic!("not part 3")
    }
    let functions = TimeWarpFunctions { warp, ..solutions::TIME_WARP };
    let mut student = student(functions, whole(960));
    for frame in [7, 400, 959] {
        update_until(&mut student, &[0, frame], |student| trouble(student, 1, frame).is_some());
    }
    update_until(&mut student, &[0, 7], |student| student.standing(1, 7).board.is_some());
    let graded = WHOLE.load(Ordering::SeqCst);
    let mut subject = InProcess(Functions::TimeWarp(functions));
    let recorded =
        crate::view::answers::Recorded::ask(Mover::TimeWarp, &mut subject, &pair(whole(960))[1], 0..960);
    assert!(matches!(recorded.standing.status, Status::Failed(_)));
    assert!(WHOLE.load(Ordering::SeqCst) - graded < 10);
    // The checks ask for short motions, some dozens of times at most.
    assert!(graded < 200, "{graded}");
}

#[test]
fn a_bone_of_the_original_is_not_asked_about() {
    let mut student = student(solutions::TIME_WARP, whole(960));
    for frame in 0..20 {
        let start = Instant::now();
        while student.known_details(1, frame).is_none() {
            assert!(start.elapsed() < Duration::from_secs(20), "{frame}: {:?}", student.standing(1, frame));
            // Whoever looks at a bone looks at it in both.
            student.details(0, frame);
            student.details(1, frame);
            student.update(&[frame, frame]);
            thread::yield_now();
        }
    }
    assert!(!student.desk.plan().is_wary());
}

#[test]
fn part_1_is_asked_by_itself_where_part_3_makes_the_motion() {
    let stretch = TimeMap::stretch(480, (100, 160), 200).unwrap();
    for (map, is_asked) in [(whole(1200), true), (stretch, false), (whole(1_000_000), false)] {
        let mut student = student(solutions::TIME_WARP, map);
        update_until(&mut student, &[0, 151], is_current(1, 151));
        student.details(1, 151);
        update_until(&mut student, &[0, 151], |student| student.known_details(1, 151).is_some());
        let Some(Details::Blended { own, .. }) = student.details(1, 151) else { panic!() };
        assert_eq!(own.is_some(), is_asked, "{map:?}");
    }
}

/// The plan of a pair after frame 7 of the warped motion was asked while it was on show, and the task that this was.
fn plan_at_7() -> (Plan, plan::Motion) {
    let mut plan = Plan::new(Mover::TimeWarp, pair(whole(960)), most_batches);
    plan.motions[1].shown = 7;
    let Some(plan::Task::Frames { at, frames, on_show: true }) = plan.next(false) else { panic!() };
    assert_eq!((at.index, frames), (1, 7..8));
    plan.hear(&at, 7);
    plan.graded = true;
    (plan, at)
}

#[test]
fn a_motion_that_is_made_at_once_is_heard_once() {
    let (mut plan, at) = plan_at_7();
    plan.settle(&at, 0..960);
    plan.motions[1].shown = 8;
    assert!(plan.next(true).is_none());
}

#[test]
fn a_motion_that_is_made_at_once_does_not_fail_again_for_every_frame() {
    let (mut plan, at) = plan_at_7();
    let failure = Failure::Panicked { message: "no".into(), location: None };
    plan.fail(&at, 7..8, &failure);
    plan.narrowed(&at, 7, Arc::new(failure));
    assert!(plan.next(true).is_none());
    plan.motions[1].shown = 8;
    assert!(matches!(plan.next(true), Some(plan::Task::Frames { frames, .. }) if frames == (8..9)));
    // It comes back after all, and all frames with it.
    plan.settle(&at, 0..960);
    assert!(plan.next(true).is_none());
}

#[test]
fn a_bone_of_several_motions_is_asked_about_in_all_of_them_and_once() {
    let pairs = [pair(whole(960)), pair(whole(240))].concat();
    let open = |_: &Version| Ok(InProcess(Functions::TimeWarp(solutions::TIME_WARP)));
    let mut student = Student::start(Mover::TimeWarp, pairs, open, quiet);
    for frame in 0..MOST_DETAILS {
        (0..4).for_each(|motion| drop(student.details(motion, frame).cloned()));
        let are_known =
            |student: &Student| [1, 3].iter().all(|motion| student.known_details(*motion, frame).is_some());
        update_until(&mut student, &[frame; 4], are_known);
        assert!(student.desk.plan().motions.iter().all(|motion| motion.details.is_none()));
    }
}

/// The solution, but that part 2 crashes.
struct Crashes;

impl Subject for Crashes {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        match question {
            Question::TimeWarp(exam::time_warp::Question::Blend { .. }) => {
                Err(Failure::Crashed { how: "bang".into() })
            }
            _ => InProcess(Functions::TimeWarp(solutions::TIME_WARP)).ask(question, limit),
        }
    }
}

#[test]
fn who_gives_up_because_of_a_part_by_itself_says_so() {
    let mut student = Student::start(Mover::TimeWarp, pair(whole(960)), |_| Ok(Crashes), quiet);
    for frame in 0..6 {
        update_until(&mut student, &[0, frame], is_current(1, frame));
        student.details(1, frame);
        update_until(&mut student, &[0, frame], |student| student.details.contains_key(&(1, frame)));
    }
    student.replace_stage(1, Arc::new(samples::walk().warped(whole(700))));
    update_until(&mut student, &[0, 3], |student| trouble(student, 1, 3).is_some());
}
