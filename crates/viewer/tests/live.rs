//! Saving the exercise while the viewer runs: in a copy of it, with the real compiler and the real worker.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "../../grading/tests/support/mod.rs"]
mod support;

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use skeleton::PositionChannels;
use support::Course;
use viewer::live::Live;
use viewer::live::mover::Mover;
use viewer::live::package::Package;
use viewer::live::student::{Standing, Status};
use viewer::live::worker::{self, Trouble};
use viewer::motion::stage::Stage;

const SOLUTION: &str = include_str!("../../../solutions/src/fk.rs");

/// Far longer than a build takes.
const PATIENCE: Duration = Duration::from_secs(100);

/// The viewer without its window, on a copy of the exercise.
struct Desk {
    course: Course,
    stage: Arc<Stage>,
    live: Live,
    shown: usize,
}

impl Desk {
    fn open(source: &str) -> Desk {
        // The tests of the grading use this copy too: what it is built with is built already.
        let course = Course::open("a course with spaces");
        course.save(source);
        fs::copy(format!("{}/data/arm.bvh", support::WORKSPACE), motion_file(&course)).unwrap();
        let stage = read_stage(&course);
        let live = open(&course, &stage);
        Desk { course, stage, live, shown: 0 }
    }

    fn standing(&self) -> Standing {
        self.live.student().standing(0, self.shown)
    }

    fn until<T>(&mut self, what: &str, done: impl Fn(&Standing) -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            self.live.update(&[self.shown]);
            if let Some(result) = done(&self.standing()) {
                return result;
            }
            assert!(start.elapsed() < PATIENCE, "waited in vain for {what}: {:?}", self.standing());
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// How far to the side of where it belongs the last pose at hand is.
    fn off(&self) -> f32 {
        let place = |pose: &skeleton::Pose| pose.transforms()[0].position.x;
        place(&self.live.student().pose(0, self.shown).unwrap().pose)
            - place(&self.stage.reference(self.shown))
    }
}

/// Watches the copy, and builds it where cargo does so by itself.
fn open(course: &Course, stage: &Arc<Stage>) -> Live {
    let folder = course.folder.clone();
    let build = move |version: &_| {
        let target = folder.join("target");
        worker::compile_into(&target, Package::Fk, &folder, version).map(|program| program.worker())
    };
    Live::open_with(
        Mover::Fk,
        &course.folder,
        vec![Arc::clone(stage)],
        vec![vec![motion_file(course)]],
        build,
    )
}

fn motion_file(course: &Course) -> PathBuf {
    course.folder.join("a motion.bvh")
}

fn read_stage(course: &Course) -> Arc<Stage> {
    let motion = parser::bvh::read_file(motion_file(course)).unwrap().motion;
    Arc::new(Stage::new(motion, PositionChannels::Replace))
}

fn current(standing: &Standing) -> Option<()> {
    standing.current.then_some(())
}

fn failed(standing: &Standing) -> Option<Arc<Trouble>> {
    match &standing.status {
        Status::Failed(trouble) => Some(Arc::clone(trouble)),
        _ => None,
    }
}

/// The solution with another answer for roots in part 3.
fn with_root(answer: &str) -> String {
    support::with(SOLUTION, "None => local_position,", &format!("None => {answer},"))
}

/// The tests edit the same copy.
static ALONE: Mutex<()> = Mutex::new(());

#[test]
fn a_save_swaps_the_picture_an_error_is_told_with_its_line_and_the_last_good_pose_stays() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut desk = Desk::open(&with_root("local_position"));
    let board = desk.until("the points", |standing| standing.board.clone());
    assert_eq!((board.points, board.of, desk.off()), (15, 15, 0.0));

    desk.course.save(&with_root("local_position + 7.0 * Vec3::X"));
    desk.until("the new version", |standing| (!standing.current).then_some(()));
    desk.until("the new pose", current);
    assert_eq!(desk.off(), 7.0);
    let board = desk.until("the new points", |standing| standing.board.clone());
    assert!(board.points < 15);

    // A copy that is put in the file's place keeps its time, which is long before the last build.
    let copy = desk.course.folder.join("copy.rs");
    fs::write(&copy, with_root("local_position + 9.0 * Vec3::X")).unwrap();
    let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
    File::options().append(true).open(&copy).unwrap().set_modified(long_ago).unwrap();
    fs::rename(&copy, desk.course.folder.join("exercises/fk/src/fk.rs")).unwrap();
    desk.until("the copy to be noticed", |standing| (!standing.current).then_some(()));
    desk.until("the copy's pose", current);
    assert_eq!(desk.off(), 9.0);

    desk.course.save(&with_root("local_position + 7.0 * Vec3::X"));
    desk.until("the version before", |standing| (!standing.current).then_some(()));
    desk.until("its pose", current);
    let wrong = with_root("local_position +");
    desk.course.save(&wrong);
    let trouble = desk.until("the error", failed);
    assert_eq!(trouble.headline, "your code does not compile");
    let line = 1 + wrong.lines().position(|line| line.contains("local_position +,")).unwrap();
    let place = format!("{}:{line}:", Path::new("exercises/fk/src/fk.rs").display());
    assert!(trouble.details[1].replace('\\', "/").starts_with(&place), "{trouble:?}");
    assert!(trouble.details[2].contains("None => local_position +,"), "{trouble:?}");
    let standing = desk.standing();
    assert_eq!((standing.current, standing.board, desk.off()), (false, None, 7.0));

    // What is the same as before is a change too, from what does not compile.
    desk.course.save(&with_root("local_position + 7.0 * Vec3::X"));
    desk.until("the good version again", current);
    desk.course.save(&with_root("panic!(\"a root?\")"));
    let with_joint = |standing: &Standing| failed(standing).filter(|trouble| trouble.details.len() > 1);
    let trouble = desk.until("the panic", with_joint);
    let line = 1 + with_root("panic!").lines().position(|line| line.contains("None => panic!")).unwrap();
    assert!(
        trouble.headline.replace('\\', "/").contains(&format!("exercises/fk/src/fk.rs:{line}:")),
        "{trouble:?}"
    );
    let root = &desk.stage.motion().skeleton().joints()[0].name;
    assert_eq!(trouble.details, [format!("at joint {root}, in frame 0"), "in part3, global_position".into()]);
    assert_eq!((desk.standing().current, desk.off()), (false, 7.0));
}

#[test]
fn a_motion_that_is_saved_is_asked_again() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut desk = Desk::open(&with_root("local_position + 5.0 * Vec3::X"));
    desk.until("the first pose", current);
    let text = fs::read_to_string(motion_file(&desk.course)).unwrap();
    fs::write(motion_file(&desk.course), text.replace("OFFSET 0", "OFFSET 1")).unwrap();
    let start = Instant::now();
    while desk.live.update(&[0]) != [0] {
        assert!(start.elapsed() < PATIENCE, "the motion's save was not noticed");
        thread::sleep(Duration::from_millis(1));
    }
    let before = desk.stage.motion().skeleton().clone();
    desk.stage = read_stage(&desk.course);
    assert_ne!(*desk.stage.motion().skeleton(), before);
    desk.live.replace_stage(0, Arc::clone(&desk.stage));
    assert_eq!(desk.standing().status, Status::Asking, "nothing is built");
    desk.until("the new motion's pose", current);
    assert_eq!(desk.off(), 5.0);
}

/// The next save ends the loop's process at once; without one it would be ended within seconds.
#[test]
fn an_endless_loop_is_told_and_ends_with_the_next_save() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut desk = Desk::open(&with_root("local_position"));
    desk.until("the first pose", current);
    let note = desk.course.folder.join("looping");
    let _ = fs::remove_file(&note);

    let source = format!(
        "{{ std::fs::write({note:?}, std::process::id().to_string()).unwrap(); loop {{ std::hint::spin_loop() }} }}"
    );
    desk.course.save(&with_root(&source));
    let process = desk.until("the loop", |_| fs::read_to_string(&note).ok().filter(|id| !id.is_empty()));
    assert!(is_running(&process).unwrap_or(true));
    desk.course.save(&with_root("local_position + 3.0 * Vec3::X"));
    desk.until("the next version", current);
    assert_eq!(desk.off(), 3.0);
    assert!(!is_running(&process).unwrap_or(false), "the loop goes on");

    // A loop that nobody ends is told.
    desk.course.save(&with_root("loop { std::hint::spin_loop() }"));
    let with_joint = |standing: &Standing| failed(standing).filter(|trouble| trouble.details.len() > 1);
    let trouble = desk.until("the loop", with_joint);
    assert!(trouble.headline.contains("look for a loop that never ends"), "{trouble:?}");
    assert!(trouble.details[0].ends_with("in frame 0"), "{trouble:?}");
    assert_eq!(trouble.details[1], "in part3, global_position");
}

/// Whether there is such a process, where that can be told.
fn is_running(process: &str) -> Option<bool> {
    let state = fs::read_to_string(format!("/proc/{process}/stat"));
    // One that has ended and was not yet waited for is listed too.
    cfg!(target_os = "linux").then(|| state.is_ok_and(|state| !state.contains(") Z ")))
}
