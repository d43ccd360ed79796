//! Functions that panic, never come back, or do so only now and then.

use super::*;

#[test]
fn a_panic_is_told_with_its_joint_frame_and_part_and_other_frames_are_shown() {
    fn panics(joint: &Joint, position: Vec3, pose: &Pose) -> Vec3 {
        // In frame 118 the root is at 11.8.
        if joint.name == "RightLeg" && (pose.transforms()[0].position.x - 11.8).abs() < 0.04 {
            let none: [Vec3; 0] = [];
            return none[joint.id.0];
        }
        solutions::fk::global_position(joint, position, pose)
    }
    let functions = FkFunctions { global_position: panics, ..solutions::FK };
    let (sender, news) = mpsc::channel();
    let open = move |_: &Version| Ok(InProcess(Functions::Fk(functions)));
    let mut student = Student::start(Mover::Fk, vec![stage(400)], open, move |news| drop(sender.send(news)));
    for frame in (0..400).filter(|frame| *frame != 118) {
        update_until(&mut student, &[5], is_current(0, frame));
    }
    // Ahead of time the frame is found, and once it is shown, the joint too.
    let with = |line: &'static str| {
        move |student: &Student| {
            trouble(student, 0, 118).is_some_and(|trouble| trouble.details.contains(&line.into()))
        }
    };
    update_until(&mut student, &[5], with("in frame 118"));
    update_until(&mut student, &[118], with("at joint RightLeg, in frame 118"));
    let trouble = trouble(&student, 0, 118).unwrap();
    assert!(
        trouble.headline.contains("faults.rs:") && trouble.headline.contains("index out of bounds"),
        "{trouble:?}"
    );
    assert_eq!(trouble.details.last().unwrap(), "in part3, global_position");
    assert!(!student.standing(0, 118).current);
    let told = news.into_iter().find(|news| matches!(news, News::Trouble(_)));
    assert_eq!(told, Some(News::Trouble(trouble)));
}

fn looping(is_bad: fn(usize) -> bool) -> Scripted {
    let failure = Failure::TimedOut { limit: Duration::from_secs(2) };
    Scripted { fault: Some(Fault { is_bad, joint: 3, failure }), ..Scripted::default() }
}

#[test]
fn an_endless_loop_is_told_with_its_joint_and_frame_and_other_frames_are_shown() {
    let subject = looping(|frame| frame == 31);
    let mut student = Student::start(Mover::Fk, vec![stage(400)], move |_| Ok(subject.clone()), quiet);
    for frame in [30, 32, 0, 399] {
        update_until(&mut student, &[30], is_current(0, frame));
    }
    let is_told = |student: &Student| {
        trouble(student, 0, 31).is_some_and(|trouble| trouble.details[0] == "at joint RightLeg, in frame 31")
    };
    update_until(&mut student, &[31], is_told);
    assert!(trouble(&student, 0, 31).unwrap().headline.contains("did not finish within 2 seconds"));
}

#[test]
fn code_that_loops_everywhere_is_not_asked_without_end() {
    let subject = looping(|_| true);
    let questions = Arc::clone(&subject.questions);
    let mut student = Student::start(Mover::Fk, vec![stage(40_000)], move |_| Ok(subject.clone()), quiet);
    for frame in 0..2000 {
        update_until(&mut student, &[frame], |student| trouble(student, 0, frame).is_some());
    }
    assert!(trouble(&student, 0, 1999).unwrap().details[0].contains("not asked"));
    let asked = questions.load(Ordering::SeqCst);
    assert!(asked < 300, "{asked} questions");
}

/// Fails for whole frames as `is_bad` says of the number of the question, and never for less.
struct Moody {
    asked: usize,
    is_bad: fn(usize) -> bool,
}

impl Subject for Moody {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        if let Question::Fk(exam::fk::Question::Poses { skeleton, frames }) = question
            && frames.iter().any(|frame| frame.local_positions.len() == skeleton.len())
        {
            self.asked += 1;
            if (self.is_bad)(self.asked) {
                return Err(Failure::TimedOut { limit });
            }
        }
        solution().ask(question, limit)
    }
}

#[test]
fn a_joint_that_is_another_each_time_is_not_told() {
    // The frame, the search's proof that it fails, which fails to fail, and the last try.
    let open = |_: &Version| Ok(Moody { asked: 0, is_bad: |asked| asked != 2 });
    let (sender, news) = mpsc::channel();
    let mut student = Student::start(Mover::Fk, vec![stage(1)], open, move |news| drop(sender.send(news)));
    update_until(&mut student, &[0], |student| trouble(student, 0, 0).is_some());
    let Some(News::Trouble(told)) = news.iter().find(|news| matches!(news, News::Trouble(_))) else {
        panic!()
    };
    assert_eq!(told.details, ["in frame 0"]);
}

#[test]
fn a_frame_that_is_answered_after_all_is_shown() {
    let open = |_: &Version| Ok(Moody { asked: 0, is_bad: |asked| asked == 1 });
    let mut student = Student::start(Mover::Fk, vec![stage(1)], open, quiet);
    update_until(&mut student, &[0], is_current(0, 0));
    assert_eq!(student.standing(0, 0).status, Status::Answered);
}

#[test]
fn after_the_viewer_has_gone_nothing_is_built() {
    let builds = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&builds);
    let open = move |_: &Version| {
        count.fetch_add(1, Ordering::SeqCst);
        Ok(solution())
    };
    let mut student = Student::start(Mover::Fk, vec![stage(5)], open, quiet);
    update_until(&mut student, &[0], is_current(0, 0));
    let rebuilder = student.rebuilder();
    assert!(rebuilder.rebuild());
    update_until(&mut student, &[0], |_| builds.load(Ordering::SeqCst) == 2);
    drop(student);
    assert!(!rebuilder.rebuild());
    assert_eq!(builds.load(Ordering::SeqCst), 2);
}
