//! Motions that are edited by a student's functions.

use super::*;
use crate::edit::{EngineState, Hand, Maker, Makers, Progress, ReferenceHand};
use crate::live::package::Package;
use crate::live::student::Standing;

const ROOMY: (usize, usize) = (1280, 720);

/// A motion as it is first shown with the exercise, edited by the reference in the student's place.
fn edited(package: Package) -> App {
    let mut app = app(50);
    app.settings.edit = EditSettings::for_exercise(package);
    app.go_to(7);
    app.edit(&mut ReferenceHand::default());
    app
}

fn sister(package: Package, status: Status) -> Option<Sister> {
    let current = status == Status::Answered;
    let standing = Standing { status, current, board: None, former: None, grading: false };
    Some(Sister { package, standing })
}

fn failed() -> Status {
    Status::Failed(Arc::new(Trouble {
        headline: "your code panicked".into(),
        details: vec!["in frame 7".into()],
    }))
}

/// What is to be seen while things stand like this.
fn seen(app: &mut App, package: Package, status: Status) -> (Vec<Look>, String) {
    app.show_sister(sister(package, status));
    let scene = app.scene(Shown::Reference, ROOMY);
    (looks(&scene), words(&scene))
}

#[test]
fn each_exercise_begins_with_what_its_functions_have_a_part_in() {
    for (package, interpolated, automatic) in
        [(Package::Fk, false, false), (Package::Interpolation, true, false), (Package::Keyframes, true, true)]
    {
        let edit = EditSettings::for_exercise(package);
        assert_eq!(
            (edit.interpolated().is_some(), edit.automatic, edit.errors),
            (interpolated, automatic, automatic)
        );
    }
}

#[test]
fn the_edited_figure_is_pale_until_the_last_version_has_answered() {
    for package in [Package::Interpolation, Package::Keyframes] {
        let mut app = edited(package);
        let (looks, words) = seen(&mut app, package, Status::Answered);
        assert_eq!(looks, [Look::Ghost, Look::Solid]);
        assert!(!words.contains("pale") && !words.contains("your functions…"), "{words}");
        for (status, told) in
            [(Status::Compiling, "compiling your functions…"), (failed(), "your code panicked\nin frame 7")]
        {
            let (looks, words) = seen(&mut app, package, status);
            assert_eq!(looks, [Look::Ghost, Look::Dimmed]);
            assert!(
                words.contains(told) && words.contains("pale: by your last version that worked"),
                "{words}"
            );
        }
    }
}

#[test]
fn asking_is_told_while_it_takes_its_time_and_then_no_more() {
    let mut app = edited(Package::Interpolation);
    let made = app.edited().unwrap().clone();
    let working = EngineState {
        edited: Some(&made),
        stale: true,
        by_former_hand: true,
        progress: Some((0, 0)),
        failure: None,
    };
    app.show_edit(working);
    let (looks, words) = seen(&mut app, Package::Interpolation, Status::Asking);
    assert_eq!(looks, [Look::Ghost, Look::Dimmed]);
    assert!(words.contains("asking your functions…") && words.contains("pale"), "{words}");
    // Some stretches have been answered for, and not all.
    let (looks, words) = seen(&mut app, Package::Interpolation, Status::Answered);
    assert_eq!(looks, [Look::Ghost, Look::Dimmed]);
    assert!(words.contains("pale: by your last version"), "{words}");
    // This version's own, for another wish.
    app.show_edit(EngineState { by_former_hand: false, ..working });
    assert_eq!(seen(&mut app, Package::Interpolation, Status::Answered).0, [Look::Ghost, Look::Solid]);
    // Nothing was left to ask.
    app.show_edit(EngineState { stale: false, by_former_hand: false, progress: None, ..working });
    let (looks, words) = seen(&mut app, Package::Interpolation, Status::Asking);
    assert_eq!(looks, [Look::Ghost, Look::Solid]);
    assert!(!words.contains("asking") && !words.contains("pale"), "{words}");
}

#[test]
fn while_nothing_is_edited_the_original_is_shown_and_the_key_is_told() {
    for (package, key) in [(Package::Interpolation, "press i"), (Package::Keyframes, "press k")] {
        let mut app = app(50);
        let (looks, words) = seen(&mut app, package, Status::Asking);
        assert_eq!(looks, [Look::Solid]);
        assert!(
            words.contains("the original: the reference solution's figure") && words.contains(key),
            "{words}"
        );
        app.settings.still = true;
        assert!(!seen(&mut app, package, Status::Asking).1.contains("press"));
    }
}

#[test]
fn without_a_version_that_worked_only_the_original_is_shown() {
    let mut app = app(50);
    app.settings.edit = EditSettings::for_exercise(Package::Interpolation);
    let (looks, words) = seen(&mut app, Package::Interpolation, failed());
    assert_eq!(looks, [Look::Solid]);
    assert!(words.contains("Only the original is shown.") && !words.contains("pale"), "{words}");
    assert!(!words.contains("interpolated"), "{words}");
}

#[test]
fn why_there_is_no_answer_is_told_once() {
    /// Panics.
    struct Failing;
    impl Hand for Failing {
        fn reduce(
            &mut self,
            _: &Stage,
            _: skeleton::Representation,
            _: &[usize],
            _: Progress,
        ) -> Result<Vec<exam::keyframes::Reduction>, exam::Failure> {
            Err(exam::Failure::Panicked { message: "no".into(), location: None })
        }
        fn between(
            &mut self,
            _: &Stage,
            _: skeleton::Representation,
            _: usize,
            _: usize,
            _: Progress,
        ) -> Result<Vec<skeleton::LocalPose>, exam::Failure> {
            Err(exam::Failure::Panicked { message: "no".into(), location: None })
        }
    }
    let mut app = edited(Package::Interpolation);
    app.edit(&mut Failing);
    let (_, words) = seen(&mut app, Package::Interpolation, failed());
    assert_eq!(words.matches("your code panicked").count(), 1, "{words}");
    app.show_sister(None);
    assert!(self::words(&app.scene(Shown::Reference, ROOMY)).contains("your code panicked: no"));
}

#[test]
fn points_stand_beside_what_is_edited() {
    let mut app = edited(Package::Keyframes);
    let board = Board {
        title: "Keyframes: 7 of 15 points.".into(),
        rows: Vec::new(),
        points: 7,
        of: 15,
        text: String::new(),
        summary: String::new(),
    };
    let mut sister = sister(Package::Keyframes, Status::Answered).unwrap();
    sister.standing.board = Some(Arc::new(board));
    app.show_sister(Some(sister));
    assert!(words(&app.scene(Shown::Reference, ROOMY)).contains("Keyframes: 7 of 15 points."));
}

/// The reference as the student, but one that keeps every n-th frame.
struct Every(usize);

impl Hand for Every {
    fn reduce(
        &mut self,
        stage: &Stage,
        _: skeleton::Representation,
        counts: &[usize],
        _: Progress,
    ) -> Result<Vec<exam::keyframes::Reduction>, exam::Failure> {
        let keyframes: Vec<usize> = (0..stage.frame_count()).step_by(self.0).collect();
        Ok(vec![exam::keyframes::Reduction { keyframes, error: 0.0 }; counts.len()])
    }

    fn between(
        &mut self,
        stage: &Stage,
        representation: skeleton::Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<skeleton::LocalPose>, exam::Failure> {
        ReferenceHand::default().between(stage, representation, start, end, progress)
    }

    fn makers(&self) -> Makers {
        Makers { keyframes: Maker::Student, ..Makers::default() }
    }
}

#[test]
fn another_number_of_keyframes_than_was_wanted_is_told_but_not_while_the_right_one_is_on_its_way() {
    let mut app = edited(Package::Keyframes);
    app.edit(&mut Every(7));
    let (_, words) = seen(&mut app, Package::Keyframes, Status::Answered);
    assert!(words.contains("your reduce keeps 8 keyframes instead of 20"), "{words}");
    assert!(!seen(&mut app, Package::Keyframes, Status::Compiling).1.contains("instead of"));
    app.edit(&mut Every(1));
    let (looks, words) = seen(&mut app, Package::Keyframes, Status::Answered);
    assert!(words.contains("your reduce keeps all frames"), "{words}");
    assert_eq!(looks, [Look::Ghost, Look::Solid], "nothing flashes when all frames are keyframes");
    app.edit(&mut ReferenceHand::default());
    app.act(Action::Keyframes(10));
    assert!(!seen(&mut app, Package::Keyframes, Status::Answered).1.contains("instead of"));
}

#[test]
fn between_keyframes_that_are_set_by_hand_nobody_chooses() {
    let mut app = edited(Package::Keyframes);
    app.act(Action::Automatic);
    app.act(Action::Interpolate);
    app.edit(&mut Every(7));
    assert_eq!(app.edited().unwrap().makers, Makers::default());
    let (looks, words) = seen(&mut app, Package::Keyframes, Status::Compiling);
    assert_eq!(looks, [Look::Ghost, Look::Solid]);
    assert!(!words.contains("pale") && words.contains("interpolated by the reference solution"), "{words}");
}
