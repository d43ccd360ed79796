//! Saving the exercise on Acclaim forward kinematics while the viewer runs: in a copy of it, with the real compiler and the
//! real worker.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "../../grading/tests/support/mod.rs"]
mod support;

use std::process::{Command, Output};
use std::sync::Arc;
use std::time::{Duration, Instant};
use std::{fs, thread};

use support::Course;
use viewer::live::Live;
use viewer::live::mover::Mover;
use viewer::live::package::Package;
use viewer::live::student::{Standing, Status};
use viewer::live::worker::{self, Trouble};
use viewer::motion::source::Source;
use viewer::motion::stage::Stage;

const SOLUTION: &str = include_str!("../../../solutions/src/acclaim.rs");
const TEMPLATE: &str = include_str!("../../../solutions/templates/acclaim.rs");

/// Far longer than a build takes.
const PATIENCE: Duration = Duration::from_secs(100);

/// The viewer without its window, on a copy of the exercise.
struct Desk {
    course: Course,
    stage: Arc<Stage>,
    live: Live,
}

const FRAME: usize = 100;

impl Desk {
    fn open(source: &str) -> Desk {
        // What this copy is built with is built already, for other tests.
        let course = Course::open("a course with spaces");
        course.save_exercise("acclaim", source);
        let data = |name: &str| format!("{}/data/{name}", support::WORKSPACE);
        let source = Source { skeleton: Some(data("walk.asf").into()), ..Source::new(data("walk.amc")) };
        let stage = source.read().unwrap().stage;
        let folder = course.folder.clone();
        let build = move |version: &_| {
            let target = folder.join("target");
            let program = worker::compile_into(&target, Package::Acclaim, &folder, version)?;
            Ok(program.worker())
        };
        let stages = vec![Arc::clone(&stage)];
        let live = Live::open_with(Mover::Acclaim, &course.folder, stages, vec![source.files()], build);
        Desk { course, stage, live }
    }

    fn save(&self, source: &str) {
        self.course.save_exercise("acclaim", source);
    }

    fn until<T>(&mut self, what: &str, done: impl Fn(&Standing) -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            self.live.update(&[FRAME]);
            let standing = self.live.student().standing(0, FRAME);
            if let Some(result) = done(&standing) {
                return result;
            }
            assert!(start.elapsed() < PATIENCE, "waited in vain for {what}: {standing:?}");
            thread::sleep(Duration::from_millis(1));
        }
    }

    fn board(&mut self) -> String {
        self.until("the points", |standing| standing.board.clone()).title.clone()
    }

    /// What is told of the shown frame, when its first line says this and it is known in which part it fails.
    fn trouble(&mut self, words: &str) -> Arc<Trouble> {
        self.until(words, |standing| match &standing.status {
            Status::Failed(trouble) if trouble.headline.contains(words) && trouble.details.len() > 1 => {
                Some(Arc::clone(trouble))
            }
            _ => None,
        })
    }

    fn visited(&self) -> usize {
        let posed = self.live.student().pose(0, FRAME).unwrap();
        posed.places().unwrap().iter().flatten().count()
    }
}

fn current(standing: &Standing) -> Option<()> {
    standing.current.then_some(())
}

/// The solution with another line in place of one of its own.
fn with(line: &str, other: &str) -> String {
    support::with(SOLUTION, line, other)
}

#[test]
fn saved_functions_move_the_bones_and_their_troubles_are_told_with_bone_and_part() {
    let mut desk = Desk::open(TEMPLATE);
    desk.until("the template's frame", current);
    assert_eq!(desk.visited(), 1);
    assert_eq!(desk.board(), "Acclaim forward kinematics: 0 of 15 points.");

    desk.save(SOLUTION);
    desk.until("the new version", |standing| (!standing.current).then_some(()));
    desk.until("the solution's frame", current);
    let own = desk.live.student().pose(0, FRAME).unwrap().pose.clone();
    for (own, right) in own.transforms().iter().zip(desk.stage.reference(FRAME).transforms()) {
        assert!(own.position.distance(right.position) < 1e-3);
    }
    assert_eq!(desk.board(), "Acclaim forward kinematics: 15 of 15 points.");
    let exercise = ["--exercise", "acclaim"];
    let right = picture(&desk.course, &[&exercise[..], &["--solution"]].concat());
    let (students, said) = picture(&desk.course, &[&exercise[..], &["--hide", "goal"]].concat());
    assert!(students == right.0 && said.is_empty(), "{said}");

    for (kind, name) in [("--sheet", "sheet.png"), ("--gif", "film.gif"), ("--apng", "film.png")] {
        let file = desk.course.folder.join(name);
        let _ = fs::remove_file(&file);
        let frames = [kind, file.to_str().unwrap(), "--frames", "100..110/2", "--size", "160x120"];
        let output = view(&desk.course, &[&exercise[..], &frames].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        assert!(file.metadata().unwrap().len() > 1000, "{name}");
    }

    let turn = "let [x, y, z] = angles";
    desk.save(&with(turn, &format!("assert!(bone.name != \"rtibia\", \"not today\");\n    {turn}")));
    let trouble = desk.trouble("not today");
    assert!(trouble.headline.replace('\\', "/").contains("exercises/acclaim/src/acclaim.rs:"), "{trouble:?}");
    assert_eq!(
        trouble.details,
        [format!("at bone rtibia, in frame {FRAME}").as_str(), "in part1, bone_rotation"]
    );
    let (goal, said) = picture(&desk.course, &exercise);
    assert!(said.contains("not today: the picture shows only the goal") && goal != right.0, "{said}");
    assert!(said.contains("at bone rtibia, in frame 100"), "{said}");

    desk.save(&with(turn, "let [x, y, z] = ;"));
    let trouble = desk.trouble("your code does not compile");
    let place = trouble.details[1].replace('\\', "/");
    assert!(place.starts_with("exercises/acclaim/src/acclaim.rs:"), "{trouble:?}");

    // An endless loop and a recursion without end: at whichever bone others hang on.
    desk.save(&with("next = child.sibling;", "next = Some(id);"));
    let trouble = desk.trouble("look for a loop that never ends");
    assert_eq!(trouble.details, [format!("in frame {FRAME}").as_str(), "in part3, visit_bones"]);
    let descend = "visit_bones(skeleton, child, visitor);";
    desk.save(&with(descend, "visit_bones(skeleton, bone, visitor);"));
    let trouble = desk.trouble("a function that calls itself without end");
    assert_eq!(trouble.details.last().unwrap(), "in part3, visit_bones");
}

/// The picture of one frame, without words, as the program writes it in the copy; and what it says of trouble.
fn picture(course: &Course, arguments: &[&str]) -> (Vec<u8>, String) {
    let file = course.folder.join("bones.png");
    let usual = ["--png", file.to_str().unwrap(), "--frame", "100", "--size", "320x240", "--camera", "40,10"];
    let hide = ["--hide", "words,traces"];
    let output = view(course, &[&usual[..], &hide, arguments].concat());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    (fs::read(file).unwrap(), said)
}

/// The program, in the copy, on the walk.
fn view(course: &Course, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_view"))
        .env("CARGO_MANIFEST_DIR", course.folder.join("crates/viewer"))
        .env_remove("DISPLAY")
        .arg(format!("{}/data/walk.amc", support::WORKSPACE))
        .args(arguments)
        .output()
        .unwrap()
}
