mod acclaim;
mod faults;
mod warp;
mod whole;

use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use exam::{Answer, Failure, Functions, InProcess, Question};
use glam::{Quat, Vec3};
use skeleton::{FkFunctions, Joint, Pose, PositionChannels};

use super::*;
use crate::samples;

fn stage(frames: usize) -> Arc<Stage> {
    Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace))
}

fn solution() -> InProcess {
    InProcess(Functions::Fk(solutions::FK))
}

/// Functions that put everything `height` up.
fn lifted(height: f32) -> Scripted {
    Scripted { height, ..Scripted::default() }
}

/// The solution with everything lifted, and faults at one joint of some frames, which the root's place along X tells.
#[derive(Clone, Default)]
struct Scripted {
    height: f32,
    fault: Option<Fault>,
    questions: Arc<AtomicUsize>,
}

#[derive(Clone)]
struct Fault {
    is_bad: fn(frame: usize) -> bool,
    joint: usize,
    failure: Failure,
}

impl Scripted {
    /// Whether the fault is met in a question about this frame.
    fn fails(&self, frame: &skeleton::Frame) -> Option<Failure> {
        let fault = self.fault.as_ref()?;
        let index = (frame.local_positions.first()?.x * 10.0).round() as usize;
        (frame.local_positions.len() > fault.joint && (fault.is_bad)(index)).then(|| fault.failure.clone())
    }
}

impl Subject for Scripted {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        self.questions.fetch_add(1, Ordering::SeqCst);
        let Question::Fk(exam::fk::Question::Poses { frames, .. }) = question else {
            return solution().ask(question, limit);
        };
        if let Some(failure) = frames.iter().find_map(|frame| self.fails(frame)) {
            return Err(failure);
        }
        let Answer::Fk(exam::fk::Answer::Poses(mut poses)) = solution().ask(question, limit)? else {
            panic!("not poses")
        };
        for posed in &mut poses {
            (0..posed.pose.len()).for_each(|i| posed.pose[skeleton::JointId(i)].position.y += self.height);
        }
        Ok(Answer::Fk(exam::fk::Answer::Poses(poses)))
    }
}

fn quiet(_: News) {}

/// Lets the student work until `done`, for as long as a slow machine may need.
fn update_until(student: &mut Student, shown: &[usize], done: impl Fn(&Student) -> bool) {
    let start = Instant::now();
    while !done(student) {
        assert!(start.elapsed() < Duration::from_secs(60), "still {:?}", student.standing(0, shown[0]));
        student.update(shown);
        thread::yield_now();
    }
}

fn is_current(motion: usize, frame: usize) -> impl Fn(&Student) -> bool {
    move |student| student.standing(motion, frame).current
}

fn trouble(student: &Student, motion: usize, frame: usize) -> Option<Arc<Trouble>> {
    match student.standing(motion, frame).status {
        Status::Failed(trouble) => Some(trouble),
        _ => None,
    }
}

fn height(student: &Student, frame: usize) -> f32 {
    student.pose(0, frame).unwrap().pose.transforms()[0].position.y
}

#[test]
fn the_answers_are_those_of_the_functions_for_every_frame_of_every_motion() {
    let stages = vec![stage(20_000), stage(1), stage(0), stage(3_000)];
    let mut student = Student::start(Mover::Fk, stages.clone(), |_| Ok(solution()), quiet);
    let shown = [19_999, 0, 0, 17];
    // Nothing but one frame is ever shown: all others are asked by themselves.
    for (motion, stage) in stages.iter().enumerate() {
        for frame in (0..stage.frame_count()).step_by(499) {
            update_until(&mut student, &shown, is_current(motion, frame));
            assert_eq!(student.pose(motion, frame).unwrap().pose, stage.reference(frame));
        }
    }
    assert_eq!(student.standing(0, 0).status, Status::Answered);
}

#[test]
fn a_motion_without_end_is_kept_in_part_and_what_is_shown_is_always_asked() {
    let stage = stage(1600 * (MOST_BATCHES + 80));
    let mut student = Student::start(Mover::Fk, vec![Arc::clone(&stage)], |_| Ok(solution()), quiet);
    for frame in [0, stage.frame_count() / 2, stage.frame_count() - 1, 0] {
        update_until(&mut student, &[frame], is_current(0, frame));
        let full = |student: &Student| student.held[0].batch_count() == MOST_BATCHES;
        update_until(&mut student, &[frame], full);
        student.update(&[frame]);
        assert!(student.held[0].batch_count() <= MOST_BATCHES);
    }
}

#[test]
fn a_new_version_takes_over_frame_by_frame_and_the_old_poses_stay_until_then() {
    let (hold, held) = mpsc::channel::<()>();
    let mut version = 0.0;
    let open = move |_: &Version| {
        version += 100.0;
        if version > 100.0 {
            held.recv().unwrap();
        }
        Ok(lifted(version))
    };
    let mut student = Student::start(Mover::Fk, vec![stage(50)], open, quiet);
    update_until(&mut student, &[7], is_current(0, 7));
    let first = height(&student, 7);
    student.rebuild();
    student.update(&[7]);
    let standing = student.standing(0, 7);
    assert_eq!((standing.status, standing.current), (Status::Compiling, false));
    assert_eq!(height(&student, 7), first, "the last good pose");
    hold.send(()).unwrap();
    update_until(&mut student, &[7], is_current(0, 7));
    assert!((height(&student, 7) - first - 100.0).abs() < 1.0, "the new one");
    assert_eq!(student.standing(0, 7).status, Status::Answered);
}

#[test]
fn what_an_abandoned_version_finds_out_is_not_looked_at() {
    let (hold, held) = mpsc::channel::<()>();
    let opened = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&opened);
    let open = move |_: &Version| {
        let number = count.fetch_add(1, Ordering::SeqCst);
        held.recv().unwrap();
        Ok(lifted(100.0 * number as f32))
    };
    let mut student = Student::start(Mover::Fk, vec![stage(3)], open, quiet);
    update_until(&mut student, &[0], |_| opened.load(Ordering::SeqCst) == 1);
    // While the first is being built there are nine more saves. They come to one more build.
    (0..9).for_each(|_| student.rebuild());
    hold.send(()).unwrap();
    hold.send(()).unwrap();
    update_until(&mut student, &[0], is_current(0, 0));
    assert!((height(&student, 0) - height_of_reference() - 100.0).abs() < 1.0, "the second, not the first");
    assert_eq!(opened.load(Ordering::SeqCst), 2);
}

/// Answers for its first frame only when it may, and says when it was asked and when it has gone.
struct Late {
    functions: Scripted,
    may: Option<Receiver<()>>,
    said: mpsc::Sender<()>,
}

impl Subject for Late {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        let is_frame =
            matches!(question, Question::Fk(exam::fk::Question::Poses { frames, .. }) if !frames.is_empty());
        if let Some(may) = self.may.take_if(|_| is_frame) {
            self.said.send(()).unwrap();
            may.recv().unwrap();
        }
        self.functions.ask(question, limit)
    }
}

impl Drop for Late {
    fn drop(&mut self) {
        // The last one goes with the test.
        let _ = self.said.send(());
    }
}

#[test]
fn an_answer_that_comes_after_the_next_save_does_not_take_its_place() {
    for second_is_there in [false, true] {
        let (answer, may) = mpsc::channel();
        let (go, wait) = mpsc::channel::<()>();
        let (said, first) = mpsc::channel();
        let mut versions = vec![(100.0, None), (0.0, Some(may))];
        let open = move |_: &Version| {
            let (height, may) = versions.pop().unwrap();
            if may.is_none() {
                wait.recv().unwrap();
            }
            Ok(Late { functions: lifted(height), may, said: said.clone() })
        };
        let mut student = Student::start(Mover::Fk, vec![stage(3)], open, quiet);
        first.recv().unwrap();
        student.rebuild();
        let is_graded = |student: &Student| student.standing(0, 0).board.is_some();
        if second_is_there {
            go.send(()).unwrap();
            update_until(&mut student, &[0], is_graded);
        }
        // The first version's thread sends its answer, and then drops the functions.
        answer.send(()).unwrap();
        first.recv().unwrap();
        student.update(&[0]);
        let _ = go.send(());
        update_until(&mut student, &[0], is_graded);
        assert!(student.standing(0, 0).current);
        assert!((height(&student, 0) - height_of_reference() - 100.0).abs() < 1.0);
    }
}

fn height_of_reference() -> f32 {
    stage(3).reference(0).transforms()[0].position.y
}

#[test]
fn a_version_that_does_not_compile_is_told_and_the_last_good_pose_stays() {
    let told = Trouble { headline: "your code does not compile".into(), details: vec!["error".into()] };
    let (sender, news) = mpsc::channel();
    let mut results = vec![Err(told.clone()), Ok(solution())];
    let open = move |_: &Version| results.pop().unwrap();
    let mut student = Student::start(Mover::Fk, vec![stage(10)], open, move |news| drop(sender.send(news)));
    assert_eq!(student.standing(0, 3).status, Status::Compiling);
    assert!(!student.standing(0, 3).current);
    update_until(&mut student, &[3], |student| student.standing(0, 3).board.is_some());
    assert!(matches!(news.recv().unwrap(), News::Board(_)));
    student.rebuild();
    update_until(&mut student, &[3], |student| trouble(student, 0, 3).is_some());
    assert_eq!(*trouble(&student, 0, 3).unwrap(), told);
    let standing = student.standing(0, 3);
    assert_eq!((standing.current, standing.board), (false, None));
    assert!(student.pose(0, 3).is_some() && student.standing(0, 3).former.is_some());
    assert_eq!(news.recv().unwrap(), News::Trouble(told.into()));
}

#[test]
fn the_points_are_those_of_self_grading() {
    let template =
        InProcess(Functions::Fk(FkFunctions { local_quaternion: |_, _| Quat::IDENTITY, ..solutions::FK }));
    let (sender, news) = mpsc::channel();
    let open = move |_: &Version| Ok(template);
    let mut student = Student::start(Mover::Fk, vec![stage(10)], open, move |news| drop(sender.send(news)));
    update_until(&mut student, &[0], |student| student.standing(0, 0).board.is_some());
    let standing = student.standing(0, 0);
    let board = standing.board.unwrap();
    assert!(!standing.grading);
    assert_eq!(board.title, "Forward kinematics: 10 of 15 points.");
    assert_eq!((board.points, board.of, board.rows.len()), (10, 15, 3));
    assert_eq!(board.rows[0].state.name(), "not started");
    assert!(
        board.text.contains("Its comment says what it should do.") && board.text.ends_with(&board.summary)
    );
    assert_eq!(news.recv().unwrap(), News::Board(board));
}

#[test]
fn what_is_printed_about_a_frame_is_heard_when_the_frame_is_shown() {
    /// Prints the root's place along X for every frame.
    struct Talkative<W>(W);
    impl<W: io::Write> Subject for Talkative<W> {
        fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
            if let Question::Fk(exam::fk::Question::Poses { frames, .. }) = question {
                for frame in frames {
                    writeln!(self.0, "{}", (frame.local_positions[0].x * 10.0).round()).unwrap();
                }
            }
            solution().ask(question, limit)
        }
    }
    let (reader, writer) = io::pipe().unwrap();
    let (go, wait) = mpsc::channel::<()>();
    let open = move |version: &Version| {
        wait.recv().unwrap();
        Ok(Talkative(version.voice(writer.try_clone().unwrap())))
    };
    let mut student = Student::start(Mover::Fk, vec![stage(3000)], open, quiet);
    student.update(&[7]);
    go.send(()).unwrap();
    let mut lines = io::BufRead::lines(io::BufReader::new(reader));
    assert_eq!(lines.next().unwrap().unwrap(), "7");
    // All others are asked too, and nothing is heard of that until they are shown.
    update_until(&mut student, &[7], |student| (0..3000).all(|frame| is_current(0, frame)(student)));
    for shown in [2000, 2001, 7] {
        student.update(&[shown]);
        assert_eq!(lines.next().unwrap().unwrap(), shown.to_string());
    }
}

#[test]
fn a_motion_that_was_read_again_is_asked_again_without_a_build() {
    let builds = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&builds);
    let open = move |_: &Version| {
        count.fetch_add(1, Ordering::SeqCst);
        Ok(solution())
    };
    let mut student = Student::start(Mover::Fk, vec![stage(5), stage(5)], open, quiet);
    update_until(&mut student, &[0, 4], is_current(1, 4));
    let longer = stage(9);
    student.replace_stage(1, Arc::clone(&longer));
    assert!(student.pose(1, 4).is_none());
    update_until(&mut student, &[0, 8], is_current(1, 8));
    assert_eq!(student.pose(1, 8).unwrap().pose, longer.reference(8));
    assert!(student.standing(0, 0).current);
    assert_eq!(builds.load(Ordering::SeqCst), 1);
    // A motion that there is not is no reason to fall over.
    student.replace_stage(2, stage(1));
    assert!(student.pose(2, 0).is_none() && student.details(2, 0).is_none());
    assert!(!student.standing(2, 0).current);
}

#[test]
fn details_come_when_they_are_wanted() {
    let mut student = Student::start(Mover::Fk, vec![stage(5)], |_| Ok(solution()), quiet);
    let start = Instant::now();
    let locals = loop {
        student.update(&[2]);
        if let Some(Details::Locals(locals)) = student.details(0, 2) {
            break locals.to_vec();
        }
        assert!(start.elapsed() < Duration::from_secs(60));
        thread::yield_now();
    };
    assert_eq!(locals.len(), 5);
    assert_eq!(locals.iter().map(|local| local.taken).collect::<Vec<_>>(), [3, 3, 0, 0, 0]);
}

#[test]
fn an_answer_with_joints_missing_is_no_answer() {
    struct Short;
    impl Subject for Short {
        fn ask(&mut self, question: &Question, _: Duration) -> Result<Answer, Failure> {
            let Question::Fk(exam::fk::Question::Poses { frames, .. }) = question else { panic!() };
            let posed = exam::fk::PosedFrame { pose: Pose::identity(1), taken: 0, available: 0 };
            Ok(Answer::Fk(exam::fk::Answer::Poses(vec![posed; frames.len()])))
        }
    }
    assert!(matches!(ask(Mover::Fk, &mut Short, &stage(1), 0..1), Err(Failure::Unreadable { .. })));
}
