//! What a worker's functions may do to it, and that the asker gets by. This program is its own worker.
#![allow(clippy::unwrap_used)] // Without libtest's harness clippy does not see that these are tests.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::time::Duration;
use std::{env, process, thread};

use exam::fk::{LocalAnswer, Question as FkQuestion};
use exam::{Answer, Failure, Functions, InProcess, Question, Subject, WorkerProcess, worker};
use glam::{Quat, Vec3};
use libtest_mimic::{Arguments, Trial};
use skeleton::acclaim::Posture;
use skeleton::{FkFunctions, Frame, FrameCursor, Joint, RotationOrder, Skeleton};

/// Names the functions that the worker serves.
const FUNCTIONS: &str = "EXAM_TEST_FUNCTIONS";

/// Makes this program ask a looping worker, and nothing else.
const ASKER: &str = "EXAM_TEST_ASKER";

/// Far more than any answer here takes, and the time that an endless loop costs these tests.
const LONG: Duration = Duration::from_secs(60);
const SHORT: Duration = Duration::from_millis(300);

fn main() {
    if let Ok(name) = env::var(FUNCTIONS) {
        let local_quaternion = match name.as_str() {
            "right" => turn_about_x,
            "panics" => |_: &Joint, _: &mut FrameCursor| panic!("no idea, {}", 42),
            "panics on NONE" => panics_on_none,
            "panics oddly" => |_: &Joint, _: &mut FrameCursor| std::panic::panic_any(Bomb),
            "loops" => |_: &Joint, _: &mut FrameCursor| {
                eprintln!("looping");
                loop {
                    std::hint::spin_loop()
                }
            },
            "exits" => |_: &Joint, _: &mut FrameCursor| process::exit(0),
            "calls itself" => calls_itself,
            "prints" => prints,
            "counts" => counts,
            "says errors" => |joint: &Joint, frame: &mut FrameCursor| {
                eprintln!("about {}", joint.name);
                turn_about_x(joint, frame)
            },
            "floods" => floods,
            _ => unreachable!("{name}"),
        };
        worker::serve(Functions::Fk(FkFunctions { local_quaternion, ..PLAIN }));
    }
    if env::var_os(ASKER).is_some() {
        let _ = worker("loops").ask(&local(RotationOrder::Xyz), LONG);
        return;
    }
    let tests: [(&str, fn()); 16] = [
        ("a_worker_answers_like_the_functions_themselves", answers),
        ("an_answer_may_be_asked_for_that_no_memory_could_hold", endless_answer),
        ("a_panic_is_told_with_its_message_and_place", panic_is_told),
        ("after_a_panic_the_same_worker_answers_on", goes_on_after_panic),
        ("a_panic_with_an_odd_payload_is_a_panic", odd_panic),
        ("an_endless_loop_is_ended", loop_is_ended),
        ("an_exit_is_a_crash", exit_is_a_crash),
        ("endless_recursion_is_a_crash", recursion_is_a_crash),
        ("print_does_not_disturb_the_answers", print_is_harmless),
        ("a_flood_of_print_does_not_disturb_the_answers", flood_is_harmless),
        ("a_looping_worker_ends_with_its_asker", ends_with_its_asker),
        ("a_program_that_is_not_there_is_no_answer", no_program),
        ("a_looping_worker_can_be_stopped_from_another_thread", loop_is_stopped),
        ("a_stopped_worker_is_never_started_again", stopped_stays_stopped),
        ("after_a_restart_nothing_is_kept", restart_forgets),
        ("errors_go_where_they_are_wanted", errors_are_handed_on),
    ];
    let trials = tests.into_iter().map(|(name, test)| {
        Trial::test(name, move || {
            test();
            Ok(())
        })
    });
    libtest_mimic::run(&Arguments::from_args(), trials.collect()).exit()
}

/// Some functions whose answers depend on all that they are given. Right answers have no place beside a worker.
const PLAIN: FkFunctions = FkFunctions {
    local_quaternion: turn_about_x,
    global_quaternion: |joint, local, pose| {
        joint.parent.map_or(local, |parent| pose[parent].rotation + local)
    },
    global_position: |joint, local, pose| joint.parent.map_or(local, |parent| pose[parent].position - local),
};

fn turn_about_x(_: &Joint, frame: &mut FrameCursor) -> Quat {
    Quat::from_rotation_x(frame.take3()[0].to_radians())
}

struct Bomb;

impl Drop for Bomb {
    fn drop(&mut self) {
        panic!("panics again when dropped");
    }
}

fn panics_on_none(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    assert!(joint.rotation_order != RotationOrder::None, "what is NONE?");
    turn_about_x(joint, frame)
}

#[allow(unconditional_recursion, clippy::only_used_in_recursion)]
fn calls_itself(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    let deeper = calls_itself(joint, frame);
    std::hint::black_box(deeper) * deeper
}

fn prints(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    println!("joint {}", joint.name);
    print!("\0 half a line");
    turn_about_x(joint, frame)
}

/// Keeps something between calls.
fn counts(_: &Joint, _: &mut FrameCursor) -> Quat {
    static CALLS: AtomicU8 = AtomicU8::new(0);
    Quat::from_xyzw(CALLS.fetch_add(1, Ordering::Relaxed).into(), 0.0, 0.0, 0.0)
}

fn floods(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    for _ in 0..3000 {
        println!("{}", ".".repeat(1000));
    }
    turn_about_x(joint, frame)
}

fn worker(functions: &str) -> WorkerProcess {
    WorkerProcess::new(command(functions))
}

fn command(functions: &str) -> Command {
    let mut command = Command::new(env::current_exe().unwrap());
    command.env(FUNCTIONS, functions);
    command
}

fn joint(order: RotationOrder) -> Joint {
    let mut skeleton = Skeleton::new();
    let id = skeleton.add_joint(None, "Hips", Vec3::ONE, []).unwrap();
    let mut joint = skeleton.get(id).unwrap().clone();
    joint.rotation_order = order;
    joint
}

fn local(order: RotationOrder) -> Question {
    Question::Fk(FkQuestion::LocalQuaternions { joints: vec![joint(order)], angles: vec![90.0, 0.0, 0.0] })
}

fn right() -> Answer {
    let rotation = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
    Answer::Fk(exam::fk::Answer::LocalQuaternions(vec![LocalAnswer { rotation, taken: 3 }]))
}

fn answers() {
    let mut skeleton = Skeleton::new();
    let root = skeleton.add_joint(None, "root", Vec3::X, []).unwrap();
    skeleton.add_end_site(root, "End Site", Vec3::Y).unwrap();
    let pose = vec![skeleton::Transform::IDENTITY; 2];
    let end = skeleton.joints()[1].clone();
    let frame = Frame { angles: vec![], local_positions: vec![Vec3::Z, Vec3::Y] };
    let questions = [
        FkQuestion::LocalQuaternions {
            joints: vec![joint(RotationOrder::Zyx)],
            angles: vec![10.0, 20.0, 30.0],
        },
        FkQuestion::GlobalQuaternion { joint: end.clone(), local: Quat::IDENTITY, pose: pose.clone().into() },
        FkQuestion::GlobalPosition { joint: end, local_position: Vec3::NEG_X, pose: pose.into() },
        FkQuestion::Poses { skeleton, frames: vec![frame; 100] },
    ];
    let mut worker = worker("right");
    for question in questions.map(Question::Fk) {
        let expected = InProcess(Functions::Fk(PLAIN)).ask(&question, LONG).unwrap();
        assert_eq!(worker.ask(&question, LONG).unwrap(), expected);
    }
}

/// The longest reply that the asker takes has no number.
fn endless_answer() {
    let posture = Posture { angles: vec![[0.0; 3]; 3], translations: vec![Vec3::ZERO; 3] };
    let mut worker = worker("right");
    for new_count in [usize::MAX, usize::MAX / 2] {
        let question = exam::time_warp::Question::Motion { postures: vec![posture.clone()], new_count };
        assert_eq!(worker.ask(&Question::TimeWarp(question), LONG), Ok(Answer::NotMine));
    }
}

fn panic_is_told() {
    let failure = worker("panics").ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
    let Failure::Panicked { message, location } = &failure else { panic!("{failure}") };
    assert_eq!(message, "no idea, 42");
    assert!(location.as_ref().is_some_and(|location| location.contains("worker.rs:")), "{location:?}");
    assert!(failure.to_string().starts_with("your code panicked at "), "{failure}");
}

fn goes_on_after_panic() {
    let mut worker = worker("panics on NONE");
    for _ in 0..3 {
        assert!(matches!(worker.ask(&local(RotationOrder::None), LONG), Err(Failure::Panicked { .. })));
        assert_eq!(worker.ask(&local(RotationOrder::Xyz), LONG), Ok(right()));
    }
}

fn odd_panic() {
    let failure = worker("panics oddly").ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
    assert!(matches!(failure, Failure::Panicked { .. }), "{failure}");
}

fn loop_is_ended() {
    let mut worker = worker("loops");
    for _ in 0..2 {
        assert_eq!(worker.ask(&local(RotationOrder::Xyz), SHORT), Err(Failure::TimedOut { limit: SHORT }));
    }
}

fn exit_is_a_crash() {
    let failure = worker("exits").ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
    assert!(matches!(failure, Failure::Crashed { .. }), "{failure}");
}

fn recursion_is_a_crash() {
    let failure = worker("calls itself").ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
    assert!(matches!(failure, Failure::Crashed { .. }), "{failure}");
}

/// What a worker printed, for looking at afterwards.
#[derive(Clone, Default)]
struct Sink(Arc<Mutex<Vec<u8>>>);

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn print_is_harmless() {
    let sink = Sink::default();
    let mut worker = worker("prints").printing_to(sink.clone());
    for _ in 0..2 {
        assert_eq!(worker.ask(&local(RotationOrder::Xyz), LONG), Ok(right()));
    }
    assert_eq!(*sink.0.lock().unwrap(), b"joint Hips\n\0 half a linejoint Hips\n\0 half a line");
}

fn flood_is_harmless() {
    let sink = Sink::default();
    let mut worker = worker("floods").printing_to(sink.clone());
    assert_eq!(worker.ask(&local(RotationOrder::Xyz), LONG), Ok(right()));
    let printed = sink.0.lock().unwrap();
    assert!(printed.ends_with(b"(your code prints very much: the rest is left out)\n"));
    assert!(printed.len() < (1 << 20) + 100, "{}", printed.len());
}

/// Worker and asker hold the same pipe for errors: it ends when both are gone.
fn ends_with_its_asker() {
    let mut asker = Command::new(env::current_exe().unwrap());
    let mut asker = asker.env(ASKER, "1").stdin(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let mut errors = BufReader::new(asker.stderr.take().unwrap());
    let mut line = String::new();
    errors.read_line(&mut line).unwrap();
    assert_eq!(line, "looping\n");

    asker.kill().unwrap();
    asker.wait().unwrap();
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(errors.read_to_end(&mut Vec::new())));
    receiver.recv_timeout(LONG).expect("the worker lives on").unwrap();
}

fn no_program() {
    let mut worker = WorkerProcess::new(Command::new("/no/such/program"));
    let failure = worker.ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
    assert!(matches!(failure, Failure::NoAnswer { .. }), "{failure}");
}

/// The worker's pipe for errors closes when its process is gone.
fn loop_is_stopped() {
    let (sender, lines) = mpsc::channel();
    let mut worker = worker("loops").errors_to(Lines(sender));
    let stopper = worker.stopper();
    let asking = thread::spawn(move || worker.ask(&local(RotationOrder::Xyz), 10 * LONG));
    assert_eq!(lines.recv_timeout(LONG).unwrap(), b"looping\n");
    stopper.stop();
    let failure = asking.join().unwrap().unwrap_err();
    assert!(matches!(failure, Failure::NoAnswer { .. }), "{failure}");
    assert_eq!(lines.recv_timeout(LONG), Err(mpsc::RecvTimeoutError::Disconnected));
}

struct Lines(mpsc::Sender<Vec<u8>>);

impl Write for Lines {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.send(bytes.to_vec()).map_err(io::Error::other)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn stopped_stays_stopped() {
    let mut worker = worker("right");
    assert_eq!(worker.ask(&local(RotationOrder::Xyz), LONG), Ok(right()));
    worker.stopper().stop();
    for _ in 0..2 {
        let failure = worker.ask(&local(RotationOrder::Xyz), LONG).unwrap_err();
        assert!(matches!(failure, Failure::NoAnswer { .. }), "{failure}");
    }
}

fn restart_forgets() {
    let mut worker = worker("counts");
    let mut count = || {
        let Ok(Answer::Fk(exam::fk::Answer::LocalQuaternions(locals))) =
            worker.ask(&local(RotationOrder::Xyz), LONG)
        else {
            panic!("no answer")
        };
        let count = locals[0].rotation.x;
        if count == 1.0 {
            worker.restart();
        }
        count
    };
    assert_eq!([count(), count(), count()], [0.0, 1.0, 0.0]);
}

fn errors_are_handed_on() {
    let sink = Sink::default();
    let mut worker = worker("says errors").errors_to(sink.clone());
    assert_eq!(worker.ask(&local(RotationOrder::Xyz), LONG), Ok(right()));
    let start = std::time::Instant::now();
    while *sink.0.lock().unwrap() != b"about Hips\n" {
        assert!(start.elapsed() < LONG, "{:?}", sink.0.lock().unwrap());
        thread::yield_now();
    }
}
