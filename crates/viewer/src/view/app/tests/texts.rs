//! What the words in the picture say.

use super::*;
use crate::draw::Painter;
use crate::draw::canvas::Canvas;

#[test]
fn they_say_where_we_are_and_what_is_wrong() {
    let mut app = app(5);
    app.act(Action::Step(1));
    assert_eq!(app.window_title(), "walk.bvh · frame 1 / 5");
    app.act(Action::Play);
    assert_eq!(app.window_title(), "walk.bvh · frame 1 / 5 · playing");
    app.act(Action::Play);
    assert!(words(&app.scene(Shown::Reference, SIZE)).contains("frame 1 / 5"));
    let failed = Status::Failed(Arc::new(Trouble {
        headline: "your code does not compile".into(),
        details: vec!["error[E0308]: mismatched types".into()],
    }));
    for (status, expected) in
        [(Status::Compiling, "compiling"), (Status::Asking, "asking your functions"), (failed, "E0308")]
    {
        let scene = app.scene(Shown::Student(&Recorded::new(Mover::Fk, status)), SIZE);
        assert!(words(&scene).contains(expected), "{}", words(&scene));
        assert_eq!(scene.figures.len(), 1, "the ghost is still there");
    }
    assert!(words(&self::app(0).scene(Shown::Reference, SIZE)).contains("rest pose"));
    assert!(words(&self::app(1).scene(Shown::Reference, SIZE)).contains("only one frame"));
}

#[test]
fn help_names_every_key() {
    let mut app = app(5);
    app.act(Action::Help);
    let help = words(&app.scene(Shown::Reference, SIZE));
    for (name, text) in crate::window::keys::help() {
        assert!(help.contains(name) && help.contains(text), "{text}");
    }
}

#[test]
fn all_keys_are_seen_in_a_window_of_the_usual_size() {
    const SIZE: (usize, usize) = (1280, 720);
    let mut app = app(5);
    app.act(Action::Help);
    let scene = app.scene(Shown::Reference, SIZE);
    let (mut painter, mut canvas) = (Painter::new(), Canvas::new(SIZE.0, SIZE.1));
    let mut drawn = |scene: &Scene| {
        painter.draw(scene, &mut canvas);
        canvas.pixels().to_vec()
    };
    let pixels = drawn(&scene);
    assert_eq!(scene.panels.len(), 3, "two columns below the state of things");
    // A last line that says something else is seen.
    for panel in 1..3 {
        let mut other = scene.clone();
        let lines: Vec<_> = scene.panels[panel].lines().collect();
        let changed = &mut other.panels.items_mut()[panel];
        changed.begin(scene.panels[panel].corner);
        lines[..lines.len() - 1].iter().for_each(|(line, text)| changed.add(*line, text));
        changed.add(Line::Key("?"), "?");
        assert!(drawn(&other) != pixels, "column {panel} is cut");
    }
}

#[test]
fn how_it_plays_is_told_where_it_is_not_as_usual() {
    let mut app = app(9);
    assert!(!words(&app.scene(Shown::Reference, SIZE)).contains("speed"));
    for action in [Action::Slower, Action::Reverse, Action::Loop, Action::Step(2), Action::RangeStart] {
        app.act(action);
    }
    let told = words(&app.scene(Shown::Reference, SIZE));
    assert!(told.contains("speed 0.75×, backwards, once, frames 2 to 8"), "{told}");
}

#[test]
fn points_stand_in_the_window_with_what_was_misunderstood() {
    let mut app = app(5);
    let mut recorded = answers(&app, solutions::FK);
    let named = grading::Named {
        id: "x",
        title: "Your angles are degrees.",
        explanation: "",
        hint: "Look at pi.",
        seen_in: &[],
    };
    recorded.standing.board = Some(Arc::new(Board {
        title: "Forward kinematics: 0 of 15 points.".into(),
        rows: vec![BoardRow {
            id: "part1",
            title: "local quaternion",
            points: 0,
            of: 5,
            state: grading::PartState::Wrong,
            named: vec![named],
        }],
        points: 0,
        of: 15,
        text: String::new(),
        summary: String::new(),
    }));
    let told = words(&app.scene(Shown::Student(&recorded), SIZE));
    for part in
        ["Forward kinematics: 0 of 15 points", "part1  local quaternion  0 of 5  wrong", "degrees.", "pi."]
    {
        assert!(told.contains(part), "{part} is missing in {told}");
    }
    app.act(Action::Points);
    assert!(!words(&app.scene(Shown::Student(&recorded), SIZE)).contains("0 of 15"));
}

#[test]
fn a_file_that_can_no_longer_be_read_is_told_and_its_last_state_stays() {
    let mut app = app(5);
    app.cannot_read("walk.bvh:3:4: no number\nhint");
    let scene = app.scene(Shown::Reference, SIZE);
    assert!(words(&scene).contains("walk.bvh:3:4: no number\nhint") && words(&scene).contains("last state"));
    assert_eq!(scene.figures.len(), 1);
    app.replace(Arc::new(Stage::new(samples::chain(3, 1.0), PositionChannels::Replace)), vec!["odd".into()]);
    let told = words(&app.scene(Shown::Reference, SIZE));
    assert!(!told.contains("no number") && told.contains("frame 0 / 3") && told.contains("odd"), "{told}");
}

#[test]
fn without_words_there_is_nothing_but_the_scene() {
    let mut app = app(5);
    app.settings.words = false;
    let scene = app.scene(Shown::Reference, SIZE);
    assert!(scene.panels.is_empty() && scene.timeline.is_none() && scene.scale_bar.is_none());
}

#[test]
fn a_picture_speaks_of_no_window_and_of_no_keys() {
    let mut app = app(5);
    let failed =
        Status::Failed(Arc::new(Trouble { headline: "your code panicked".into(), details: Vec::new() }));
    let recorded = Recorded::new(Mover::Fk, failed);
    let told = |app: &mut App| words(&app.scene(Shown::Student(&recorded), SIZE));
    let window = told(&mut app);
    assert!(window.contains("this window follows") && window.contains("paused") && window.contains("h help"));
    app.settings.still = true;
    let picture = told(&mut app);
    assert!(
        picture.contains("your code panicked") && picture.contains("Only the goal is shown."),
        "{picture}"
    );
    assert!(["window", "paused", "help"].iter().all(|word| !picture.contains(word)), "{picture}");
}

#[test]
fn in_a_small_window_points_leave_out_hints() {
    let mut app = app(5);
    let mut answers = answers(&app, STUB);
    let (title, why, hint) = ("You turn it the wrong way.", "Why.", "Look for a minus sign.");
    let named = grading::Named { id: "wrong_way", title, explanation: why, hint, seen_in: &[] };
    let state = grading::PartState::Wrong;
    let row = BoardRow { id: "part", title: "title", points: 0, of: 5, state, named: vec![named] };
    let (title, text, summary) = (String::new(), String::new(), String::new());
    answers.standing.board =
        Some(Arc::new(Board { title, rows: [row].into(), points: 0, of: 15, text, summary }));
    for (size, has_hint) in [((800, 500), true), ((640, 480), false)] {
        let said = words(&app.scene(Shown::Student(&answers), size));
        assert!(said.contains(named.title), "{said}");
        assert_eq!(said.contains("Hint: "), has_hint, "{size:?}: {said}");
    }
}

#[test]
fn joints_outside_of_the_picture_are_no_trouble_before_anything_is_begun() {
    use exam::{Functions, InProcess};
    use grading::PartState::{NotStarted, Right, Wrong};
    let warp = crate::motion::time_map::TimeMap::Whole { old: 480, new: 960 };
    let of = |stage: Arc<Stage>| App::new(stage, "walk".into(), Vec::new(), SIZE);
    for (mover, functions, mut app) in [
        (Mover::Fk, Functions::Fk(solutions::FK), app(5)),
        (Mover::Acclaim, Functions::Acclaim(solutions::ACCLAIM), of(samples::walk())),
        (
            Mover::TimeWarp,
            Functions::TimeWarp(solutions::TIME_WARP),
            of(Arc::new(samples::walk().warped(warp))),
        ),
    ] {
        let mut recorded = Recorded::ask(mover, &mut InProcess(functions), &app.stage, [0]);
        let pose = &mut recorded.poses.get_mut(&0).unwrap().pose;
        pose.transforms_mut().iter_mut().for_each(|joint| joint.position.x += 1e5);
        let mut line = |recorded: &Recorded| {
            let scene = app.scene(Shown::Student(recorded), SIZE);
            let lines: Vec<_> = scene.panels.iter().flat_map(|panel| panel.lines()).collect();
            let told = lines.iter().find(|(_, text)| text.contains("are outside of the picture"));
            told.unwrap_or_else(|| panic!("{lines:?}")).0
        };
        assert_eq!(line(&recorded), Line::Text, "{mover:?}: nothing is known yet");
        recorded.standing.board = board([NotStarted; 3]);
        assert_eq!(line(&recorded), Line::Text, "{mover:?}");
        for states in [[Wrong, NotStarted, NotStarted], [NotStarted, NotStarted, Right]] {
            recorded.standing.board = board(states);
            assert_eq!(line(&recorded), Line::Trouble, "{mover:?}");
            recorded.standing.former = recorded.standing.board.take();
            assert_eq!(line(&recorded), Line::Trouble, "{mover:?}: points are being counted again");
            recorded.standing.former = None;
        }
    }
}
