//! What is written and plotted of an edited motion.

use super::*;
use crate::edit::{Edited, EngineState, NotEdited};

#[test]
fn curves_begin_without_an_error_rise_to_the_right_and_end_at_the_present_state() {
    for actions in [&[Action::Automatic, Action::Plot][..], &[Action::Interpolate, Action::Plot]] {
        let mut app = edited(50, actions);
        let plot = show(&mut app).plot.unwrap();
        assert_eq!(plot.curves.len(), 2);
        for curve in &plot.curves {
            assert_eq!(curve.points[0], (0.0, 0.0));
            assert_eq!(curve.points.last().unwrap().0, 1.0);
            assert!(curve.points.windows(2).all(|pair| pair[0].0 < pair[1].0));
            assert!(curve.points.iter().all(|(_, up)| (0.0..=1.0).contains(up)));
        }
        let end = *plot.curves[0].points.last().unwrap();
        let mark = plot.mark.unwrap();
        assert!(mark.0 == 1.0 && (mark.1 - end.1).abs() < 1e-4, "{mark:?} {end:?}");
        let last = plot.columns.last().unwrap();
        let frames = app.edited().unwrap().interpolated as f32;
        assert!((last.label.parse::<f32>().unwrap() / frames - last.at).abs() < 1e-6);
        assert!((3..=6).contains(&plot.rows.len()), "{:?}", plot.rows);
    }
}

#[test]
fn long_curves_are_told_by_some_of_their_points() {
    let mut app = edited(1500, &[Action::Automatic, Action::Plot]);
    let plot = show(&mut app).plot.unwrap();
    assert!(plot.curves.iter().all(|curve| (300..=401).contains(&curve.points.len())));
}

#[test]
fn there_is_none_without_an_edited_motion_without_words_with_the_help_or_in_a_small_picture() {
    let mut app = edited(50, &[Action::Plot]);
    let scene = show(&mut app);
    assert!(scene.plot.is_none() && words(&scene).contains("for the plot, edit the motion: press i or k"));
    let mut app = edited(50, &[Action::Plot, Action::Errors, Action::Automatic]);
    let scene = app.scene(Shown::Reference, (500, 300));
    assert!(scene.plot.is_none() && words(&scene).contains("the plot needs a larger window"));
    assert!(show(&mut app).plot.is_some());
    app.act(Action::Help);
    assert!(show(&mut app).plot.is_none());
    app.act(Action::Help);
    app.settings.words = false;
    let scene = show(&mut app);
    assert!(scene.plot.is_none() && scene.keyframes.is_empty());
}

#[test]
fn how_many_keyframes_how_far_off_and_by_whom() {
    let mut app = edited(50, &[Action::Automatic, Action::Keyframes(-10), Action::Step(1)]);
    let scene = show(&mut app);
    let told = words(&scene);
    for part in
        ["10 keyframes of 50 frames", "Euler angles, interpolated by the reference", "error ", "tips "]
    {
        assert!(told.contains(part), "{part} is missing in {told}");
    }
    assert!(told.contains("here a keyframe") != app.edited().unwrap().pose(1).is_some());
    assert_eq!(scene.keyframes, keyframes(&app));
    for part in ["the original", "keyframe"] {
        assert!(told.contains(part), "{part} is missing in the legend of {told}");
    }
    assert!(!told.contains("arrow"));
    app.act(Action::Errors);
    assert!(words(&show(&mut app)).contains("arrow"));
}

#[test]
fn where_there_is_nothing_to_interpolate_that_is_said() {
    for (frames, actions, expected) in [
        (0, &[Action::Interpolate][..], "no frames to interpolate"),
        (1, &[Action::Automatic], "one frame: nothing to interpolate"),
        (2, &[Action::Interpolate], "no frames between 0 and 1"),
        (2, &[Action::Automatic], "all 2 frames are keyframes"),
        (3, &[Action::Interpolate], "frames 0 to 2: 1 interpolated"),
        (3, &[Action::Automatic], "all 3 frames are keyframes"),
        (9, &[Action::Interpolate, Action::Last, Action::RangeStart], "no frames between 8 and 8"),
    ] {
        let mut app = edited(frames, actions);
        app.act(Action::Plot);
        app.act(Action::Errors);
        app.edit(&mut ReferenceHand::default());
        let scene = show(&mut app);
        assert!(words(&scene).contains(expected), "{expected} is missing in {}", words(&scene));
        Painter::new().draw(&scene, &mut Canvas::new(ROOMY.0, ROOMY.1));
    }
}

#[test]
fn a_motion_that_is_too_long_says_what_to_do() {
    let mut skeleton = Skeleton::new();
    for _ in 0..4_000 {
        skeleton.add_joint(None, "j", Vec3::Y, []).unwrap();
    }
    let stage = Arc::new(Stage::new(
        Motion::new(skeleton, 1_500, 0.1, Vec::new()).unwrap(),
        PositionChannels::Replace,
    ));
    let mut app = App::new(stage, "long.bvh".into(), Vec::new(), SIZE);
    app.act(Action::Automatic);
    app.edit(&mut ReferenceHand::default());
    let told = words(&show(&mut app));
    assert!(
        told.contains("A stretch of at most 1000 frames") && told.contains("[ and ] set a stretch"),
        "{told}"
    );
    app.settings.still = true;
    let told = words(&show(&mut app));
    assert!(told.contains("at most 1000 frames") && !told.contains("[ and ]"), "{told}");
}

#[test]
fn work_that_takes_long_is_told_and_work_that_does_not_is_not() {
    let mut app = edited(50, &[Action::Automatic]);
    let made = app.edited().unwrap().clone();
    let state = EngineState {
        edited: Some(&made),
        stale: true,
        by_former_hand: false,
        progress: None,
        failure: None,
    };
    let mut told = |edited, progress, pictures| {
        (0..pictures).for_each(|_| app.show_edit(EngineState { edited, progress, ..state }));
        words(&show(&mut app))
    };
    assert!(!told(Some(&made), Some((20, 50)), 1).contains("calculating"));
    assert!(told(Some(&made), Some((20, 50)), 30).contains("calculating… 40 %"));
    // One result after the other, as while a key is held: each is newer than the one before.
    let newer = Arc::new(Edited::clone(&made));
    assert!(!told(Some(&newer), Some((20, 50)), 10).contains("calculating"));
    assert!(!told(Some(&made), Some((20, 50)), 10).contains("calculating"));
    assert!(told(None, Some((0, 0)), 30).contains("calculating…"));
    assert!(!told(Some(&made), None, 1).contains("calculating"));
    let failure = Arc::new(NotEdited::Odd("no frames came back".into()));
    app.show_edit(EngineState { failure: Some(&failure), ..state });
    let told = words(&show(&mut app));
    assert!(told.contains("no frames came back") && told.contains("the last result stays"), "{told}");
}

#[test]
fn a_picture_of_it_speaks_of_no_keys() {
    let mut app = edited(2, &[Action::Interpolate, Action::Plot, Action::Errors]);
    app.settings.still = true;
    let told = words(&app.scene(Shown::Reference, (500, 300)));
    assert!(["[ and ]", "press", "window"].iter().all(|word| !told.contains(word)), "{told}");
}
