//! Motions that are edited: keys, figures, arrows, flashes.

mod told;

use proptest::prelude::*;
use skeleton::{Motion, Representation, Skeleton};

use super::*;
use crate::draw::Painter;
use crate::draw::canvas::Canvas;
use crate::edit::{Keys, ReferenceHand};
use crate::scene::Tint;

const EULER: Option<Representation> = Some(Representation::Euler);
const QUATERNION: Option<Representation> = Some(Representation::Quaternion);
const ROOMY: (usize, usize) = (1280, 720);

/// After these keys, with what the reference makes of them.
fn edited(frames: usize, actions: &[Action]) -> App {
    let mut app = app(frames);
    actions.iter().for_each(|action| app.act(*action));
    app.edit(&mut ReferenceHand::default());
    app
}

fn show(app: &mut App) -> Scene {
    app.scene(Shown::Reference, ROOMY)
}

fn keyframes(app: &App) -> Vec<usize> {
    app.edited().unwrap().keyframes.clone()
}

mod keys {
    use super::*;

    #[test]
    fn i_goes_from_nothing_over_both_representations_to_nothing() {
        let mut app = app(50);
        let mut seen = Vec::new();
        for _ in 0..4 {
            seen.push(app.settings.edit.interpolated());
            app.act(Action::Interpolate);
        }
        assert_eq!(seen, [None, EULER, QUATERNION, None]);
    }

    #[test]
    fn with_automatic_keyframes_i_only_changes_the_representation() {
        let mut app = app(50);
        app.act(Action::Automatic);
        let mut seen = Vec::new();
        for _ in 0..3 {
            seen.push(app.settings.edit.interpolated());
            app.act(Action::Interpolate);
        }
        assert_eq!(seen, [EULER, QUATERNION, EULER]);
        app.act(Action::Automatic);
        assert_eq!(app.wish(), None, "there was no stretch before");
        app.act(Action::Interpolate);
        app.act(Action::Automatic);
        app.act(Action::Interpolate);
        app.act(Action::Automatic);
        assert_eq!(app.settings.edit.interpolated(), QUATERNION, "the stretch is there again");
    }

    #[test]
    fn the_stretch_is_what_is_played_and_k_takes_the_whole_motion() {
        let mut app = app(50);
        app.act(Action::Interpolate);
        assert_eq!(app.wish().unwrap().keys, Keys::Ends(0, 49));
        for (frame, action) in [(30, Action::RangeEnd), (10, Action::RangeStart)] {
            app.go_to(frame);
            app.act(action);
        }
        assert_eq!(app.wish().unwrap().keys, Keys::Ends(10, 30));
        app.act(Action::Automatic);
        assert_eq!(app.wish().unwrap().keys, Keys::Automatic(20));
        assert!(!app.wish().unwrap().curves);
        app.act(Action::Plot);
        assert!(app.wish().unwrap().curves);
    }

    #[test]
    fn as_many_keyframes_as_the_motion_can_have() {
        let mut app = app(25);
        app.act(Action::Keyframes(1));
        assert_eq!(app.keyframe_count(), 20, "without automatic keyframes there is nothing to count");
        app.act(Action::Automatic);
        let mut after = |by: isize| {
            app.act(Action::Keyframes(by));
            app.keyframe_count()
        };
        assert_eq!([1, 1, -1, 10, 1, -10, -10, -10, 1].map(&mut after), [21, 22, 21, 25, 25, 15, 5, 2, 3]);
        assert_eq!([isize::MAX, isize::MIN].map(&mut after), [25, 2]);
        for (frames, count) in [(0, 0), (1, 1), (2, 2), (3, 3), (19, 19), (21, 20)] {
            let mut app = self::app(frames);
            app.act(Action::Automatic);
            assert_eq!(app.keyframe_count(), count);
            app.act(Action::Keyframes(-1));
            assert_eq!(app.keyframe_count(), count.saturating_sub(1).max(count.min(2)));
        }
    }

    #[test]
    fn the_title_says_what_is_edited() {
        let mut app = app(50);
        app.act(Action::Interpolate);
        assert_eq!(app.window_title(), "walk.bvh · frame 0 / 50 · interpolated, Euler angles");
        app.act(Action::Interpolate);
        app.act(Action::Automatic);
        app.act(Action::Keyframes(1));
        app.act(Action::Play);
        assert_eq!(app.window_title(), "walk.bvh · frame 0 / 50 · 21 keyframes, quaternions · playing");
    }
}

mod figures {
    use super::*;

    #[test]
    fn the_solid_one_is_interpolated_and_the_ghost_is_the_original() {
        let mut app = edited(50, &[Action::Interpolate]);
        for frame in [0, 20, 49] {
            app.go_to(frame);
            let scene = show(&mut app);
            let original = app.stage.reference(frame);
            let pose = app.edited().unwrap().pose(frame).unwrap_or(&original).clone();
            assert_eq!(pose == original, frame != 20);
            let figures =
                [app.stage.figure(&original, Look::Ghost, false), app.stage.figure(&pose, Look::Solid, true)];
            for (shown, wanted) in scene.figures.iter().zip(&figures) {
                assert_eq!((&shown.joints, &shown.bones), (&wanted.joints, &wanted.bones));
            }
        }
        app.act(Action::Ghost);
        assert_eq!(show(&mut app).figures.len(), 1);
    }

    #[test]
    fn beside_the_original_stands_to_the_right_and_as_far_away_in_every_frame() {
        let mut app = edited(50, &[Action::Interpolate, Action::Beside]);
        let mut shifts = Vec::new();
        for frame in [5, 20, 35] {
            app.go_to(frame);
            let scene = show(&mut app);
            let original = app.stage.figure(&app.stage.reference(frame), Look::Ghost, false);
            let shift = scene.figures[0].joints[0].place - original.joints[0].place;
            assert!(shift.dot(scene.camera.view(ROOMY).right) > 0.5 * app.stage.size() * 0.3, "{shift}");
            for (shown, own) in scene.figures[0].joints.iter().zip(&original.joints) {
                assert!((shown.place - own.place).distance(shift) < 1e-4);
            }
            shifts.push(shift);
        }
        assert!(shifts.iter().all(|shift| shift.distance(shifts[0]) < 1e-4), "{shifts:?}");
    }

    #[test]
    fn error_vectors_lead_from_the_interpolated_tips_to_those_of_the_original_also_beside_it() {
        for beside in [false, true] {
            let mut app = edited(50, &[Action::Interpolate, Action::Errors]);
            app.settings.edit.beside = beside;
            app.go_to(20);
            let scene = show(&mut app);
            let vectors: Vec<_> = scene.marks.iter().filter(|mark| mark.tint == Tint::Error).collect();
            assert_eq!(vectors.len(), 2);
            for (vector, tip) in vectors.into_iter().zip([2, 4]) {
                assert_eq!(vector.from, Some(scene.figures[1].joints[tip].place));
                assert_eq!(vector.to, app.stage.reference(20).transforms()[tip].position);
            }
            app.go_to(0);
            assert!(show(&mut app).marks.is_empty(), "a keyframe is not off");
        }
    }

    #[test]
    fn traces_follow_the_interpolated_tips() {
        let mut app = edited(50, &[Action::Interpolate]);
        app.go_to(20);
        let scene = show(&mut app);
        for (trail, tip) in scene.trails.iter().zip([2, 4]) {
            let interpolated = app.edited().unwrap().pose(15).unwrap().transforms()[tip].position;
            // Two seconds at most: from frame 1 on.
            assert_eq!(trail.points[14], interpolated);
            assert_eq!(trail.points.last(), Some(&scene.figures[1].joints[tip].place));
        }
    }

    #[test]
    fn a_click_finds_the_joint_where_it_is_seen() {
        for beside in [false, true] {
            let mut app = edited(50, &[Action::Interpolate]);
            app.settings.edit.beside = beside;
            app.go_to(20);
            let scene = show(&mut app);
            let spot = scene.camera.view(ROOMY).project(scene.figures[1].joints[4].place).unwrap();
            app.click(Shown::Reference, (spot.x, spot.y), ROOMY);
            assert_eq!(app.selected(), Some(4));
            assert!(words(&show(&mut app)).contains("apart "));
        }
    }

    #[test]
    fn everything_includes_the_original_that_stands_beside() {
        let mut app = edited(50, &[Action::Interpolate, Action::Beside, Action::Frame]);
        app.go_to(20);
        for size in [(1280, 720), (500, 700)] {
            app.act(Action::Frame);
            let scene = app.scene(Shown::Reference, size);
            let view = scene.camera.view(size);
            for dot in scene.figures.iter().flat_map(|figure| &figure.joints) {
                let spot = view.project(dot.place).unwrap();
                assert!(
                    (0.0..size.0 as f32).contains(&spot.x) && (0.0..size.1 as f32).contains(&spot.y),
                    "{spot:?}"
                );
            }
        }
    }

    #[test]
    fn a_students_figure_gives_way_to_the_edited_motion() {
        let mut app = app(50);
        app.go_to(20);
        let stub = answers(&app, STUB);
        app.act(Action::Interpolate);
        assert_eq!(app.scene(Shown::Student(&stub), ROOMY).figures[1].joints[2].place.x, 0.0, "not yet");
        app.edit(&mut ReferenceHand::default());
        let scene = app.scene(Shown::Student(&stub), ROOMY);
        let pose = app.edited().unwrap().pose(20).unwrap();
        assert_eq!(scene.figures[1].joints[2].place, pose.transforms()[2].position);
        assert!(words(&scene).contains("interpolated by the reference solution"));
        app.settings.edit.stretch = None;
        let scene = app.scene(Shown::Student(&stub), ROOMY);
        assert!(words(&scene).contains("your functions' figure"));
    }

    #[test]
    fn a_motion_that_was_saved_anew_is_not_shown_in_the_poses_of_the_old_one() {
        let mut app = edited(50, &[Action::Interpolate]);
        app.replace(Arc::new(Stage::new(samples::chain(9, 1.0), PositionChannels::Replace)), Vec::new());
        assert!(app.edited().is_none());
        assert_eq!(looks(&show(&mut app)), [Look::Solid]);
    }
}

mod flashes {
    use super::*;

    fn at(app: &mut App, frame: usize) -> bool {
        app.go_to(frame);
        looks(&show(app)).contains(&Look::Flash)
    }

    #[test]
    fn the_figure_flashes_exactly_at_keyframes() {
        let mut app = edited(50, &[Action::Automatic]);
        app.settings.edit.keyframes = 6;
        app.edit(&mut ReferenceHand::default());
        let keyframes = keyframes(&app);
        assert_eq!(keyframes.len(), 6);
        for frame in 0..50 {
            assert_eq!(at(&mut app, frame), keyframes.contains(&frame), "{frame}");
        }
        app.act(Action::Automatic);
        assert!((0..50).all(|frame| !at(&mut app, frame)));
    }

    #[test]
    fn at_120_frames_per_second_a_flash_lasts_five_frames_in_the_direction_of_play() {
        let chain = samples::chain(50, 1.0);
        let motion = Motion::new(chain.skeleton().clone(), 50, 1.0 / 120.0, chain.values().to_vec()).unwrap();
        let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
        let mut app = App::new(stage, "fast.bvh".into(), Vec::new(), SIZE);
        for (frame, action) in [(10, Action::RangeStart), (30, Action::RangeEnd)] {
            app.go_to(frame);
            app.act(action);
        }
        app.act(Action::Interpolate);
        app.edit(&mut ReferenceHand::default());
        let flashing = |app: &mut App| (0..50).filter(|frame| at(app, *frame)).collect::<Vec<_>>();
        assert_eq!(flashing(&mut app), [10, 11, 12, 13, 14, 30, 31, 32, 33, 34]);
        app.act(Action::Reverse);
        assert_eq!(flashing(&mut app), [6, 7, 8, 9, 10, 26, 27, 28, 29, 30]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn whatever_keys_are_pressed_there_is_a_picture(
        frames in 0usize..6, keys in prop::collection::vec(0usize..13, 0..20), size in (1usize..900, 1usize..600),
    ) {
        use Action::*;
        const ACTIONS: [Action; 13] = [
            Interpolate, Automatic, Keyframes(1), Keyframes(-10), Beside, Errors, Plot, RangeStart, RangeEnd, Step(1), Play, Reverse, Look,
        ];
        let mut app = app(frames);
        let mut hand = ReferenceHand::default();
        let mut canvas = Canvas::new(size.0, size.1);
        let mut painter = Painter::new();
        for key in keys {
            app.act(ACTIONS[key]);
            app.advance(0.1);
            // Some pictures come before the result.
            if key % 3 > 0 {
                app.edit(&mut hand);
            }
            painter.draw(&app.scene(Shown::Reference, size), &mut canvas);
        }
    }
}
