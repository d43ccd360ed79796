//! The exercise on bones.

use exam::{Functions, InProcess};
use glam::Vec3;
use grading::PartState::{NotStarted, Right, Wrong};
use grading::acclaim::TEMPLATE;
use skeleton::acclaim::AcclaimFunctions;

use super::*;

fn walk(frame: usize) -> App {
    of_stage(samples::walk(), frame)
}

fn of_stage(stage: Arc<Stage>, frame: usize) -> App {
    let mut app = App::new(stage, "walk.amc".into(), Vec::new(), SIZE);
    app.settings.bones = true;
    app.go_to(frame);
    app
}

fn asked(app: &App, functions: AcclaimFunctions) -> Recorded {
    let mut subject = InProcess(Functions::Acclaim(functions));
    let mut recorded = Recorded::ask(Mover::Acclaim, &mut subject, &app.stage, [app.frame()]);
    recorded.ask_details(&mut subject, &app.stage, app.frame());
    recorded
}

fn select(app: &mut App, name: &str) {
    let joints = app.stage.motion().skeleton().joints();
    app.select(joints.iter().position(|joint| joint.name == name));
}

/// What is said about the answers of these functions.
fn told_of(app: &mut App, functions: AcclaimFunctions) -> String {
    let recorded = asked(app, functions);
    told(app, &recorded)
}

fn told(app: &mut App, recorded: &Recorded) -> String {
    words(&app.scene(Shown::Student(recorded), SIZE))
}

/// Parts 2 and 3, and a part 1 that does nothing.
const STIFF: AcclaimFunctions =
    AcclaimFunctions { bone_rotation: TEMPLATE.bone_rotation, ..solutions::ACCLAIM };

#[test]
fn with_the_template_there_is_the_roots_square_and_nothing_is_wrong() {
    let mut app = walk(100);
    let mut recorded = asked(&app, TEMPLATE);
    recorded.standing.board = board([NotStarted; 3]);
    let scene = app.scene(Shown::Student(&recorded), SIZE);
    assert_eq!(looks(&scene), [Look::Ghost, Look::Solid]);
    let (goal, own) = (&scene.figures[0], &scene.figures[1]);
    let seen: Vec<_> = own.joints.iter().filter(|dot| dot.place.is_finite()).collect();
    assert_eq!(seen.len(), 1);
    assert_eq!((seen[0].place, seen[0].off), (goal.joints[0].place, Off::Right));
    let lengths = own.bones.iter().filter(|bone| bone.to.is_finite()).map(|bone| bone.from.distance(bone.to));
    assert!(lengths.clone().count() > 0 && lengths.sum::<f32>() == 0.0, "only the root, which has no length");
    let said = words(&scene);
    assert!(said.contains("part 3 visits 1 of 31 bones"), "{said}");
    assert!(!said.contains("NaN") && !said.contains("outside"), "{said}");
    let red = |scene: &Scene| {
        scene.panels.iter().flat_map(|panel| panel.lines()).filter(|(line, _)| *line == Line::Trouble).count()
    };
    assert_eq!(red(&scene), 0);
    select(&mut app, "ltibia");
    let scene = app.scene(Shown::Student(&recorded), SIZE);
    let said = words(&scene);
    for part in ["ltibia", "parent lfemur", "dof rx", "none: not visited", "does not visit this bone yet"] {
        assert!(said.contains(part), "{part} is missing in {said}");
    }
    assert_eq!(red(&scene), 0, "{said}");
}

#[test]
fn a_bone_is_drawn_from_where_it_starts_to_where_it_ends_though_nothing_hangs_on_it() {
    let mut app = walk(100);
    let neither = AcclaimFunctions {
        // Only what hangs on the root, and not what hangs on that.
        visit_bones: |skeleton, bone, visitor| {
            visitor.visit(bone);
            skeleton.children(bone.id).for_each(|child| visitor.visit(child));
        },
        ..solutions::ACCLAIM
    };
    let mut recorded = asked(&app, neither);
    recorded.standing.board = board([Right, Right, Wrong]);
    let scene = app.scene(Shown::Student(&recorded), SIZE);
    let (goal, own) = (&scene.figures[0], &scene.figures[1]);
    let mut seen = 0;
    for (goal, own) in goal.bones.iter().zip(&own.bones) {
        if own.to.is_finite() && own.from.distance(own.to) > 0.0 {
            assert!(own.to.distance(goal.to) < 1e-3 && own.from.distance(goal.from) < 1e-3);
            seen += 1;
        }
    }
    assert!(seen >= 3, "both hips and the back, and there are {seen}");
    let said = words(&scene);
    assert!(
        said.contains("part 3 visits 4 of 31 bones, and not lfemur, ltibia, lfoot and 24 more"),
        "{said}"
    );
}

#[test]
fn joints_are_judged_when_parts_2_and_3_are_begun() {
    let mut app = walk(100);
    let mut recorded = asked(&app, STIFF);
    let worst = |app: &mut App, recorded: &Recorded| {
        let scene = app.scene(Shown::Student(recorded), SIZE);
        scene.figures[1].joints.iter().map(|dot| dot.off).max().unwrap()
    };
    for (states, off) in [
        ([NotStarted, NotStarted, Right], Off::Right),
        ([Right, Right, NotStarted], Off::Right),
        ([NotStarted, Right, Right], Off::Much),
    ] {
        recorded.standing.board = board(states);
        assert_eq!(worst(&mut app, &recorded), off, "{states:?}");
    }
}

#[test]
fn a_bone_is_explained_with_whom_to_blame() {
    let mut app = walk(100);
    select(&mut app, "ltibia");
    let right = asked(&app, solutions::ACCLAIM);
    let said = told(&mut app, &right);
    for part in ["angles X 59.08°, Y 0.00°, Z 0.00°", "start, in the file's units", "yours ", "\nright"] {
        assert!(said.contains(part), "{part} is missing in {said}");
    }
    assert!(!said.contains("off by"), "{said}");
    let mut stiff = asked(&app, STIFF);
    stiff.standing.board = board([Wrong, Right, Right]);
    let said = told(&mut app, &stiff);
    assert!(said.contains("off by its start: ") && said.contains("% of the figure"), "{said}");
    assert!(
        said.contains("part 1 is to blame: given its parent's rotation, its rotation is wrong"),
        "{said}"
    );
    stiff.standing.board = board([NotStarted, Right, Right]);
    assert!(told(&mut app, &stiff).contains("not right yet: not all parts are started"));

    let short =
        AcclaimFunctions { bone_ends: |_, _, parent_end, _| (parent_end, parent_end), ..solutions::ACCLAIM };
    let said = told_of(&mut app, short);
    assert!(
        said.contains("part 2 is to blame: given its start and its rotation, its end is wrong"),
        "{said}"
    );
    let backwards = AcclaimFunctions {
        visit_bones: |skeleton, _, visitor| {
            skeleton.bones().iter().rev().for_each(|bone| visitor.visit(bone));
        },
        ..solutions::ACCLAIM
    };
    let said = told_of(&mut app, backwards);
    let why = "it visits this bone before its parent, lfemur, which had no place then";
    assert!(said.contains(&format!("part 3 is to blame: {why}")), "{said}");
    let thrice = AcclaimFunctions {
        visit_bones: |skeleton, bone, visitor| {
            (0..3).for_each(|_| (solutions::ACCLAIM.visit_bones)(skeleton, bone, visitor));
        },
        ..solutions::ACCLAIM
    };
    // More than twice as many visits as there are bones are not counted.
    assert!(told_of(&mut app, thrice).contains("part 3 visits it 2 times: once would do"));

    app.select(Some(
        samples::walk().motion().skeleton().joints().iter().position(|j| j.is_end_site).unwrap(),
    ));
    assert!(told(&mut app, &right).contains("ltoes: its end"));
}

#[test]
fn places_that_are_no_numbers_are_told_by_bones() {
    let mut app = walk(0);
    let nan = AcclaimFunctions {
        bone_ends: |bone, rotation, parent_end, translation| match &bone.name[..] {
            "ltoes" => (parent_end, Vec3::NAN),
            _ => (solutions::ACCLAIM.bone_ends)(bone, rotation, parent_end, translation),
        },
        ..solutions::ACCLAIM
    };
    let said = told_of(&mut app, nan);
    assert!(said.contains("NaN or infinity as the place of 1 of your 31 bones: not drawn"), "{said}");
}

#[test]
fn without_a_student_a_bone_is_explained_too() {
    let mut app = walk(100);
    select(&mut app, "ltibia");
    let said = words(&app.scene(Shown::Reference, SIZE));
    assert!(said.contains("dof rx") && said.contains("end ") && !said.contains("yours"), "{said}");
    app.settings.bones = false;
    let said = words(&app.scene(Shown::Reference, SIZE));
    assert!(said.contains("order ") && !said.contains("dof"), "otherwise it is a joint: {said}");
}

#[test]
fn a_file_in_other_orders_is_warned_about_and_the_solution_agrees_with_the_goal() {
    let mut app = of_stage(samples::walk_in_other_orders(), 100);
    let mut recorded = asked(&app, solutions::ACCLAIM);
    recorded.standing.board = board([Right; 3]);
    let scene = app.scene(Shown::Student(&recorded), SIZE);
    assert!(scene.figures[1].joints.iter().all(|dot| dot.off == Off::Right));
    let warning = "lfemur: not listed as rx ry rz in this file. ";
    assert!(words(&scene).contains(warning), "{}", words(&scene));
    let file = app.stage.reference(100);
    let off = file.transforms().iter().zip(&scene.figures[0].joints);
    assert!(off.map(|(file, goal)| file.position.distance(goal.place)).fold(0.0, f32::max) > 1.0);
    // Where the file itself is shown nothing is wrong with it.
    app.settings.bones = false;
    assert!(!words(&app.scene(Shown::Reference, SIZE)).contains("rx ry rz"));
    let mut usual = walk(100);
    let recorded = asked(&usual, solutions::ACCLAIM);
    assert!(!told(&mut usual, &recorded).contains("rx ry rz"));
}

#[test]
fn traces_end_at_the_tips_of_the_figure_that_is_drawn() {
    let mut app = of_stage(samples::walk_in_other_orders(), 0);
    (0..=100).for_each(|frame| app.go_to(frame));
    for bones in [true, false] {
        app.settings.bones = bones;
        let scene = app.scene(Shown::Reference, SIZE);
        let ends: Vec<Vec3> = scene.trails.iter().map(|trail| *trail.points.last().unwrap()).collect();
        let tips: Vec<Vec3> =
            app.stage.traced().iter().map(|tip| scene.figures[0].joints[*tip].place).collect();
        assert_eq!(ends, tips, "of bones: {bones}");
    }
}

#[test]
fn in_a_warped_motion_the_solution_agrees_with_the_goal_between_frames_too() {
    let map = crate::motion::time_map::TimeMap::Whole { old: 480, new: 1001 };
    let mut app = of_stage(Arc::new(samples::walk().warped(map)), 333);
    let mut recorded = asked(&app, solutions::ACCLAIM);
    recorded.standing.board = board([Right; 3]);
    let scene = app.scene(Shown::Student(&recorded), SIZE);
    assert!(scene.figures[1].joints.iter().all(|dot| dot.off == Off::Right));
    let fluent = app.stage.reference(333);
    for (fluent, goal) in fluent.transforms().iter().zip(&scene.figures[0].joints) {
        assert!(fluent.position.distance(goal.place) < 0.1, "it is a walk");
    }
}
