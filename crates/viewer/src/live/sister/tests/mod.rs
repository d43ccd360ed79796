mod absurd;

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use exam::keyframes::Reduction;
use exam::{Answer, Failure, Functions, InProcess, Question, Subject};
use glam::{Quat, Vec3};
use skeleton::{LocalPose, PositionChannels, Representation};

use super::*;
use crate::edit::{Maker, Makers, Progress};
use crate::live::board::Board;
use crate::live::student::{News, Status};
use crate::motion::stage::Stage;
use crate::samples;

fn stage(frames: usize) -> Stage {
    Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace)
}

/// The solution, whose interpolated root is lifted.
#[derive(Clone, Copy)]
struct Lifted(f32);

impl Subject for Lifted {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        let mut answer =
            InProcess(Functions::Interpolation(solutions::INTERPOLATION)).ask(question, limit)?;
        if let Answer::Interpolation(exam::interpolation::Answer::Between(poses)) = &mut answer {
            poses.iter_mut().for_each(|pose| pose.positions[0].y += self.0);
        }
        Ok(answer)
    }
}

/// A hand that is nobody's: one pose for each stretch, and these keyframes.
struct Rest;

impl Hand for Rest {
    fn reduce(
        &mut self,
        _: &Stage,
        _: Representation,
        counts: &[usize],
        _: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        Ok(counts.iter().map(|count| Reduction { keyframes: vec![0, *count], error: 0.5 }).collect())
    }

    fn between(
        &mut self,
        _: &Stage,
        _: Representation,
        start: usize,
        end: usize,
        _: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        let place = Vec3::new(start as f32, end as f32, 0.0);
        Ok(vec![LocalPose { rotations: vec![Quat::IDENTITY], positions: vec![place] }])
    }
}

fn go_on(_: usize, _: usize) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn rest() -> Box<dyn Hand> {
    Box::new(Rest)
}

/// Counts no points: the questions for points are tested where they are made.
fn no_points(_: &mut dyn Subject, package: Package) -> Board {
    let rubric = package.exercise().rubric;
    Board::new(&grading::scoreboard::Scoreboard { rubric, parts: &[], whole: None })
}

/// Starts the interpolation's hands for two motions.
fn start<S: Subject + Send + Clone + 'static>(
    mut build: impl FnMut(&Version) -> Result<S, Trouble> + Send + 'static,
) -> (Hands, Receiver<News>) {
    let (sender, news) = mpsc::channel();
    let open = move |version: &Version| {
        let subject = build(version)?;
        Ok(Opened { workers: vec![subject.clone(), subject.clone()], graded: subject })
    };
    let tell = move |news| drop(sender.send(news));
    (Hands::start_with(Package::Interpolation, 2, open, rest, tell, no_points), news)
}

/// Takes what comes until there is something, for as long as a slow machine may need.
fn until<T>(hands: &mut Hands, mut found: impl FnMut(&Hands, Vec<(usize, Box<dyn Hand>)>) -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        let come = hands.update();
        if let Some(found) = found(hands, come) {
            return found;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "still {:?}", hands.standing(0));
        thread::yield_now();
    }
}

/// The next hand of the first motion.
fn next_hand(hands: &mut Hands) -> Box<dyn Hand> {
    until(hands, |_, come| come.into_iter().find(|(motion, _)| *motion == 0).map(|(_, hand)| hand))
}

fn between(hand: &mut dyn Hand) -> Result<Vec<LocalPose>, Failure> {
    hand.between(&stage(9), Representation::Quaternion, 2, 6, &mut go_on)
}

/// How much the second of these frames is lifted.
fn height(hand: &mut dyn Hand) -> f32 {
    let right = between(&mut *Box::new(Answering(Lifted(0.0)))).unwrap();
    between(hand).unwrap()[1].positions[0].y - right[1].positions[0].y
}

/// The subject alone as a hand.
struct Answering<S>(S);

impl<S: Subject + Send> Hand for Answering<S> {
    fn reduce(
        &mut self,
        stage: &Stage,
        way: Representation,
        counts: &[usize],
        _: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        ask::reduce(&mut self.0, stage, way, counts).map_err(|wrong| wrong.failure)
    }

    fn between(
        &mut self,
        stage: &Stage,
        way: Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        ask::between(&mut self.0, stage, way, (start, end), progress, || {}).map_err(|wrong| wrong.failure)
    }
}

fn trouble(hands: &Hands, motion: usize) -> Option<Arc<Trouble>> {
    match hands.standing(motion).status {
        Status::Failed(trouble) => Some(trouble),
        _ => None,
    }
}

#[test]
fn a_save_brings_a_new_hand_for_every_motion() {
    let mut heights = vec![200.0, 100.0];
    let (mut hands, _news) = start(move |_| Ok(Lifted(heights.pop().unwrap())));
    assert_eq!(hands.standing(0).status, Status::Compiling);
    let mut come = until(&mut hands, |_, come| (!come.is_empty()).then_some(come));
    assert_eq!(come.iter().map(|(motion, _)| *motion).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(hands.standing(1).status, Status::Asking, "nobody has asked it");
    assert!((height(&mut *come[1].1) - 100.0).abs() < 1e-3);
    until(&mut hands, |hands, _| hands.standing(1).current.then_some(()));
    assert!(!hands.standing(0).current);
    hands.rebuilder().rebuild();
    let mut newest = next_hand(&mut hands);
    assert_eq!(
        hands.standing(1).status,
        Status::Asking,
        "what the version before has answered does not count"
    );
    assert!((height(&mut *newest) - 200.0).abs() < 1e-3);
}

#[test]
fn what_is_not_the_students_part_is_done_by_another_hand() {
    let (mut hands, _news) = start(|_| Ok(Lifted(7.0)));
    let mut hand = next_hand(&mut hands);
    assert_eq!(hand.makers(), Makers { between: Maker::Student, keyframes: Maker::Reference });
    let reductions = hand.reduce(&stage(9), Representation::Euler, &[3, 5], &mut go_on).unwrap();
    assert_eq!((reductions[1].keyframes[1], reductions[1].error), (5, 0.5));
    assert!((height(&mut *hand) - 7.0).abs() < 1e-3);

    let subject = InProcess(Functions::keyframes(solutions::KEYFRAMES).with_clips(inbetween::clip));
    let open = move |_: &Version| Ok(Opened { workers: vec![subject], graded: subject });
    let mut hands = Hands::start_with(Package::Keyframes, 1, open, rest, |_| {}, no_points);
    let mut hand = next_hand(&mut hands);
    assert_eq!(hand.makers(), Makers { between: Maker::Reference, keyframes: Maker::Student });
    assert_eq!(between(&mut *hand).unwrap()[0].positions, [Vec3::new(2.0, 6.0, 0.0)]);
    let reductions = hand.reduce(&stage(9), Representation::Euler, &[3, 5], &mut go_on).unwrap();
    assert_eq!(reductions.iter().map(|reduction| reduction.keyframes.len()).collect::<Vec<_>>(), [3, 5]);
}

#[test]
fn of_many_saves_only_the_newest_is_built_and_only_its_hand_comes() {
    let (hold, held) = mpsc::channel::<()>();
    let built = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&built);
    let (mut hands, news) = start(move |_| {
        let number = count.fetch_add(1, Ordering::SeqCst);
        held.recv().unwrap();
        Ok(Lifted(100.0 * number as f32))
    });
    until(&mut hands, |_, _| (built.load(Ordering::SeqCst) == 1).then_some(()));
    (0..9).for_each(|_| assert!(hands.rebuilder().rebuild()));
    hold.send(()).unwrap();
    hold.send(()).unwrap();
    assert!((height(&mut *next_hand(&mut hands)) - 100.0).abs() < 1e-3, "the second, not the first");
    assert_eq!(built.load(Ordering::SeqCst), 2);
    until(&mut hands, |hands, _| hands.standing(0).board);
    assert_eq!(news.try_iter().count(), 1, "points of an abandoned version are told to nobody");
}

#[test]
fn points_follow_the_hands_and_stay_as_the_former_ones_after_the_next_save() {
    let (hold, held) = mpsc::channel::<()>();
    let mut builds = 0;
    let (mut hands, news) = start(move |_| {
        builds += 1;
        if builds > 1 {
            held.recv().unwrap();
        }
        Ok(Lifted(0.0))
    });
    let board = until(&mut hands, |hands, _| hands.standing(0).board);
    assert_eq!(news.recv().unwrap(), News::Board(Arc::clone(&board)));
    hands.rebuilder().rebuild();
    hands.update();
    let standing = hands.standing(0);
    assert_eq!((standing.status, standing.board), (Status::Compiling, None));
    assert_eq!(standing.former, Some(board));
    hold.send(()).unwrap();
    until(&mut hands, |hands, _| hands.standing(0).board);
    assert_eq!(hands.standing(0).former, None);
}

#[test]
fn a_version_that_does_not_compile_is_told_and_the_next_one_is_built() {
    let told = Trouble { headline: "your code does not compile".into(), details: vec!["error".into()] };
    let mut results = vec![Ok(Lifted(1.0)), Err(told.clone())];
    let (mut hands, news) = start(move |_| results.pop().unwrap());
    let shown = until(&mut hands, |hands, come| {
        assert!(come.is_empty());
        trouble(hands, 1)
    });
    assert_eq!(*shown, told);
    assert_eq!(news.recv().unwrap(), News::Trouble(told.into()));
    hands.rebuilder().rebuild();
    next_hand(&mut hands);
    assert_eq!(trouble(&hands, 1), None);
}

#[test]
fn a_trouble_is_told_once_is_known_of_its_motion_only_and_goes_when_an_answer_comes() {
    /// Panics for frames less than half-way.
    #[derive(Clone)]
    struct Moody;
    impl Subject for Moody {
        fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
            match question {
                Question::Interpolation(exam::interpolation::Question::Between { ts, .. })
                    if ts.iter().any(|t| *t < 0.5) =>
                {
                    Err(Failure::Panicked {
                        message: "too early".into(),
                        location: Some("here.rs:7:1".into()),
                    })
                }
                _ => Lifted(0.0).ask(question, limit),
            }
        }
    }
    let (mut hands, news) = start(|_| Ok(Moody));
    let mut hand = next_hand(&mut hands);
    (0..3).for_each(|_| assert!(between(&mut *hand).is_err()));
    let trouble_of_it = until(&mut hands, |hands, _| trouble(hands, 0));
    assert_eq!(trouble_of_it.headline, "your code panicked at here.rs:7:1: too early");
    let place = "in frame 3, t = 0.250, between the keyframes 2 and 6, with quaternions";
    assert_eq!(trouble_of_it.details, [place]);
    assert_eq!(trouble(&hands, 1), None);
    until(&mut hands, |hands, _| hands.standing(0).board);
    let told = news.try_iter().filter(|news| matches!(news, News::Trouble(_))).collect::<Vec<_>>();
    assert_eq!(told, [News::Trouble(trouble_of_it)]);
    hand.between(&stage(9), Representation::Euler, 3, 5, &mut go_on).unwrap();
    until(&mut hands, |hands, _| hands.standing(0).current.then_some(()));
}

#[test]
fn the_hand_of_an_abandoned_version_says_nothing_any_more() {
    #[derive(Clone)]
    struct Failing;
    impl Subject for Failing {
        fn ask(&mut self, _: &Question, _: Duration) -> Result<Answer, Failure> {
            Err(Failure::NoAnswer { why: "the worker was stopped".into() })
        }
    }
    let (hold, held) = mpsc::channel::<()>();
    let mut builds = 0;
    let (mut hands, news) = start(move |_| {
        builds += 1;
        if builds > 1 {
            held.recv().unwrap();
        }
        Ok(Failing)
    });
    let mut hand = next_hand(&mut hands);
    until(&mut hands, |hands, _| hands.standing(0).board);
    news.try_iter().count();
    hands.rebuilder().rebuild();
    assert!(between(&mut *hand).is_err());
    assert!(hands.update().is_empty());
    assert_eq!(hands.standing(0).status, Status::Compiling);
    hold.send(()).unwrap();
    until(&mut hands, |hands, _| hands.standing(0).board);
    assert!(news.try_iter().all(|news| matches!(news, News::Board(_))));
}

#[test]
fn what_is_printed_is_heard_except_while_the_failing_frame_is_looked_for() {
    use std::io::Write;
    /// Prints how many frames it is asked about, and fails for more than one and for the second.
    #[derive(Clone)]
    struct Talkative(Arc<Mutex<Box<dyn Write + Send>>>);
    impl Subject for Talkative {
        fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
            let Question::Interpolation(exam::interpolation::Question::Between { ts, .. }) = question else {
                panic!("not frames")
            };
            writeln!(self.0.lock().unwrap(), "{} frames", ts.len()).unwrap();
            if ts.len() > 1 || ts[0] == 0.5 {
                return Err(Failure::TimedOut { limit });
            }
            Lifted(0.0).ask(question, limit)
        }
    }
    let (mut reader, writer) = std::io::pipe().unwrap();
    let mut writer = Some(writer);
    let (mut hands, _news) = start(move |version| {
        let voice: Box<dyn Write + Send> = Box::new(version.voice(writer.take().unwrap()));
        Ok(Talkative(Arc::new(Mutex::new(voice))))
    });
    let mut hand = next_hand(&mut hands);
    let Err(failure) = between(&mut *hand) else { panic!() };
    assert_eq!(failure, Failure::TimedOut { limit: Duration::from_secs(2) });
    let trouble = until(&mut hands, |hands, _| trouble(hands, 0));
    assert!(trouble.details[0].starts_with("in frame 4, t = 0.500"), "{trouble:?}");
    hand.between(&stage(9), Representation::Euler, 0, 2, &mut go_on).unwrap_err();
    drop((hand, hands));
    assert_eq!(std::io::read_to_string(&mut reader).unwrap(), "3 frames\n1 frames\n");
}

#[test]
fn who_waits_for_an_answer_learns_what_is_wrong_with_it() {
    let mut right = Now::new(Package::Interpolation, &Version::default(), Lifted(0.0), rest());
    assert!(between(right.hand()).is_ok());
    assert_eq!(right.trouble(), None);
    let mut wrong = Now::new(Package::Interpolation, &Version::default(), Lifted(f32::NAN), rest());
    assert!(between(wrong.hand()).is_err());
    assert!(wrong.trouble().unwrap().headline.contains("NaN"));
    assert_eq!(wrong.trouble(), None, "told once");
}

#[test]
fn after_the_viewer_has_gone_nothing_is_built() {
    let builds = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&builds);
    let (mut hands, _news) = start(move |_| {
        count.fetch_add(1, Ordering::SeqCst);
        Ok(Lifted(0.0))
    });
    next_hand(&mut hands);
    let rebuilder = hands.rebuilder();
    drop(hands);
    assert!(!rebuilder.rebuild());
    assert_eq!(builds.load(Ordering::SeqCst), 1);
}
