//! Saving the exercises on interpolation and on keyframes while the viewer runs: in a copy of them, with the real compiler
//! and the real workers.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "../../grading/tests/support/mod.rs"]
mod support;

use std::fs;
use std::ops::ControlFlow;
use std::process::Command;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use skeleton::{PositionChannels, Representation};
use support::Course;
use viewer::edit::{Hand, ReferenceHand};
use viewer::live::package::Package;
use viewer::live::sister::Sister;
use viewer::live::student::{Standing, Status};
use viewer::live::worker::{self, Trouble};
use viewer::motion::stage::Stage;

const INTERPOLATION: &str = include_str!("../../../solutions/src/interpolation.rs");
const KEYFRAMES: &str = include_str!("../../../solutions/src/keyframes.rs");

/// Far longer than a build takes.
const PATIENCE: Duration = Duration::from_secs(100);

/// The viewer without its window, on a copy of the exercise.
struct Desk {
    course: Course,
    stage: Stage,
    sister: Sister,
}

impl Desk {
    fn open(package: Package, source: &str) -> Desk {
        // What this copy is built with is built already, for other tests.
        let course = Course::open("a course with spaces");
        save(&course, package, source);
        let motion = format!("{}/data/dance.bvh", support::WORKSPACE);
        let stage = Stage::new(parser::bvh::read_file(&motion).unwrap().motion, PositionChannels::Replace);
        let folder = course.folder.clone();
        let build =
            move |version: &_| worker::compile_into(&folder.join("target"), package, &folder, version);
        let rest = || -> Box<dyn Hand> { Box::new(ReferenceHand::default()) };
        let sister = Sister::open_with(package, &course.folder, vec![vec![motion.into()]], rest, build);
        Desk { course, stage, sister }
    }

    fn save(&self, source: &str) {
        save(&self.course, self.sister.package(), source);
    }

    fn until<T>(
        &mut self,
        what: &str,
        mut done: impl FnMut(&Standing, Option<Box<dyn Hand>>) -> Option<T>,
    ) -> T {
        let start = Instant::now();
        loop {
            let hand = self.sister.update().hands.pop().map(|(_, hand)| hand);
            let standing = self.sister.standing(0);
            if let Some(result) = done(&standing, hand) {
                return result;
            }
            assert!(start.elapsed() < PATIENCE, "waited in vain for {what}: {standing:?}");
            thread::sleep(Duration::from_millis(1));
        }
    }

    fn next_hand(&mut self) -> Box<dyn Hand> {
        self.until("a new version", |_, hand| hand)
    }

    fn trouble(&mut self) -> Arc<Trouble> {
        self.until("a trouble", |standing, _| match &standing.status {
            Status::Failed(trouble) => Some(Arc::clone(trouble)),
            _ => None,
        })
    }

    /// Waits for all points.
    fn all_points(&mut self, title: &str) {
        let board = self.until("the points", |standing, _| standing.board.clone());
        assert_eq!(board.title, title);
    }
}

/// The picture of one frame of the dance, without words, as the program writes it in the copy; and what it says of trouble.
fn picture(course: &Course, arguments: &[&str]) -> (Vec<u8>, String) {
    let file = course.folder.join("picture.png");
    let output = Command::new(env!("CARGO_BIN_EXE_view"))
        .env("CARGO_MANIFEST_DIR", course.folder.join("crates/viewer"))
        .env_remove("DISPLAY")
        .args([&format!("{}/data/dance.bvh", support::WORKSPACE), "--png", file.to_str().unwrap()])
        .args(["--frame", "60", "--size", "320x240", "--hide", "words"])
        .args(arguments)
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    (fs::read(file).unwrap(), said)
}

fn go_on(_: usize, _: usize) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn save(course: &Course, package: Package, source: &str) {
    support::write(&package.sources(&course.folder).join(package.file()), source.as_bytes());
}

/// The line of `source` (from 1) that holds `text`, as a place of the package's file.
fn place(package: Package, source: &str, text: &str) -> String {
    let line = 1 + source.lines().position(|line| line.contains(text)).unwrap();
    format!("exercises/{}/src/{}:{line}:", package.name(), package.file())
}

fn told_at(trouble: &Trouble, place: &str) -> bool {
    let mut lines = [&trouble.headline].into_iter().chain(&trouble.details);
    lines.any(|line| line.replace('\\', "/").contains(place))
}

/// The tests edit the same copy.
static ALONE: Mutex<()> = Mutex::new(());

#[test]
fn saved_functions_make_the_frames_between_and_their_troubles_are_told_with_their_line() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let package = Package::Interpolation;
    let mut desk = Desk::open(package, INTERPOLATION);
    let mut hand = desk.next_hand();
    for representation in Representation::ALL {
        let students = hand.between(&desk.stage, representation, 3, 120, &mut go_on).unwrap();
        let right =
            ReferenceHand::default().between(&desk.stage, representation, 3, 120, &mut go_on).unwrap();
        assert_eq!(students, right);
    }
    desk.until("the answer", |standing, _| standing.current.then_some(()));
    desk.all_points("Interpolation: 15 of 15 points.");
    let exercise = ["--exercise", "interpolation"];
    let right = picture(&desk.course, &[&exercise[..], &["--solution"]].concat());
    assert!(picture(&desk.course, &exercise) == right && right.1.is_empty());

    let begin = "let t = t.clamp(0.0, 1.0);\n    std::array";
    assert!(INTERPOLATION.contains(begin), "the solution has changed");
    let panicking = INTERPOLATION.replace(begin, "assert!(t < 0.5, \"only so far\");\n    std::array");
    desk.save(&panicking);
    let mut hand = desk.next_hand();
    assert!(hand.between(&desk.stage, Representation::Quaternion, 0, 4, &mut go_on).is_ok());
    assert!(hand.between(&desk.stage, Representation::Euler, 0, 4, &mut go_on).is_err());
    let trouble = desk.trouble();
    assert!(trouble.headline.contains("only so far"), "{trouble:?}");
    assert!(told_at(&trouble, &place(package, &panicking, "only so far")), "{trouble:?}");
    assert_eq!(trouble.details, ["in frame 2, t = 0.500, between the keyframes 0 and 4, with Euler angles"]);

    let (original, said) = picture(&desk.course, &exercise);
    assert!(said.contains("only so far: only the original is shown"), "{said}");
    assert!(original != right.0 && original == picture(&desk.course, &["--solution"]).0);

    let wrong = INTERPOLATION.replace(begin, "let t = ;\n    std::array");
    desk.save(&wrong);
    let trouble = desk.until("the error", |standing, _| match &standing.status {
        Status::Failed(trouble) if trouble.headline == "your code does not compile" => Some(trouble.clone()),
        _ => None,
    });
    assert!(told_at(&trouble, &place(package, &wrong, "let t = ;")), "{trouble:?}");
}

#[test]
fn saved_functions_choose_keyframes_and_a_loop_ends_with_the_next_save() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let begin = "let surplus =";
    assert!(KEYFRAMES.contains(begin), "the solution has changed");
    let course = Course::open("a course with spaces");
    let note = course.folder.join("looping");
    let _ = fs::remove_file(&note);
    let looping = format!(
        "std::fs::write({note:?}, std::process::id().to_string()).unwrap(); loop {{ std::hint::spin_loop() }}\n    #[allow(unreachable_code)]\n    {begin}"
    );
    let mut desk = Desk::open(Package::Keyframes, &KEYFRAMES.replace(begin, &looping));
    let mut hand = desk.next_hand();
    let stage = desk.stage.clone();
    let asked =
        thread::spawn(move || hand.reduce(&stage, Representation::Quaternion, &[12], &mut go_on).map(|_| ()));
    let process = desk.until("the loop", |_, _| fs::read_to_string(&note).ok().filter(|id| !id.is_empty()));
    desk.save(KEYFRAMES);
    let mut hand = desk.next_hand();
    assert!(
        matches!(asked.join().unwrap(), Err(exam::Failure::NoAnswer { .. })),
        "it was ended, and has not ended"
    );
    assert!(!is_running(&process).unwrap_or(false), "the loop goes on");
    assert_eq!(desk.sister.standing(0).status, Status::Asking, "the trouble is that of an older version");

    let counts = [2, 12, 141, 999];
    let students = hand.reduce(&desk.stage, Representation::Quaternion, &counts, &mut go_on).unwrap();
    let right = ReferenceHand::default()
        .reduce(&desk.stage, Representation::Quaternion, &counts, &mut go_on)
        .unwrap();
    for (students, right) in students.iter().zip(&right) {
        assert_eq!(students.keyframes, right.keyframes);
        assert!((students.error - right.error).abs() <= 1e-3 * right.error);
    }
    desk.all_points("Keyframes: 15 of 15 points.");
}

/// Whether there is such a process, where that can be told.
fn is_running(process: &str) -> Option<bool> {
    let state = fs::read_to_string(format!("/proc/{process}/stat"));
    // One that has ended and was not yet waited for is listed too.
    cfg!(target_os = "linux").then(|| state.is_ok_and(|state| !state.contains(") Z ")))
}
