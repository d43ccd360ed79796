//! Files and functions that change while they are shown.

use glam::Vec3;

use super::*;
use crate::live::student::{Details, Posed, Standing};

fn staged(motion: skeleton::Motion) -> Arc<Stage> {
    Arc::new(Stage::new(motion, PositionChannels::Replace))
}

/// How many joints the picture does not show.
fn outside(app: &mut App, shown: Shown) -> usize {
    let scene = app.scene(shown, SIZE);
    let view = scene.camera.view(SIZE);
    let inside = |place: Vec3| {
        view.project(place).is_some_and(|spot| {
            (0.0..SIZE.0 as f32).contains(&spot.x) && (0.0..SIZE.1 as f32).contains(&spot.y)
        })
    };
    scene.figures.iter().flat_map(|figure| &figure.joints).filter(|dot| !inside(dot.place)).count()
}

#[test]
fn a_file_in_another_unit_is_looked_at_from_as_near() {
    let mut app = app(5);
    let before = app.scene(Shown::Reference, SIZE).camera;
    app.replace(Arc::new(Stage::new(samples::chain(5, 100.0), PositionChannels::Replace)), Vec::new());
    let after = app.scene(Shown::Reference, SIZE).camera;
    assert!((after.distance / before.distance / 100.0 - 1.0).abs() < 1e-3, "{before:?} {after:?}");
    assert!((after.target / 100.0).abs_diff_eq(before.target, 1e-3), "{before:?} {after:?}");
}

#[test]
fn a_file_that_can_be_read_at_last_is_looked_at_as_if_it_had_been_from_the_beginning() {
    for scale in [0.01, 0.6, 1.0, 1.8, 100.0] {
        let mut app = App::new(crate::motion::source::nothing(), "walk.bvh".into(), Vec::new(), SIZE);
        app.cannot_read("no");
        app.scene(Shown::Reference, SIZE);
        app.replace(staged(samples::chain(5, scale)), Vec::new());
        let mut fresh = App::new(staged(samples::chain(5, scale)), "walk.bvh".into(), Vec::new(), SIZE);
        assert_eq!(outside(&mut app, Shown::Reference), 0, "{scale}");
        let camera = app.scene(Shown::Reference, SIZE).camera;
        assert_eq!(camera, fresh.scene(Shown::Reference, SIZE).camera, "{scale}");
    }
}

#[test]
fn a_motion_that_has_gone_elsewhere_is_found_by_a_camera_that_stays() {
    let mut app = app(5);
    app.act(Action::Follow);
    app.scene(Shown::Reference, SIZE);
    let chain = samples::chain(5, 1.0);
    let mut values = chain.values().to_vec();
    values.chunks_exact_mut(chain.skeleton().channel_count()).for_each(|row| row[2] += 500.0);
    let moved = skeleton::Motion::new(chain.skeleton().clone(), 5, 0.1, values).unwrap();
    app.replace(staged(moved), Vec::new());
    assert_eq!(outside(&mut app, Shown::Reference), 0);
}

#[test]
fn a_selected_joint_stays_the_same_joint() {
    let skeleton_of = |names: &[&str]| {
        let mut skeleton = skeleton::Skeleton::new();
        let root = skeleton.add_joint(None, names[0], Vec3::ZERO, []).unwrap();
        for name in &names[1..] {
            skeleton.add_joint(Some(root), *name, Vec3::Y, []).unwrap();
        }
        staged(skeleton::Motion::new(skeleton, 3, 0.1, Vec::new()).unwrap())
    };
    let mut app = App::new(skeleton_of(&["Hips", "Leg", "Arm"]), "a".into(), Vec::new(), SIZE);
    app.select(Some(2));
    app.replace(skeleton_of(&["Hips", "Neck", "Leg", "Arm"]), Vec::new());
    assert_eq!(app.selected(), Some(3));
    app.replace(skeleton_of(&["Hips", "Neck"]), Vec::new());
    assert_eq!(app.selected(), None);
}

/// Answers of an older version for some frames, and of the last one for the others.
struct Mixed {
    older: Recorded,
    newer: Recorded,
}

impl Answers for Mixed {
    fn mover(&self) -> Mover {
        Mover::Fk
    }

    fn standing(&self, frame: usize) -> Standing {
        self.newer.standing(frame)
    }

    fn posed(&self, frame: usize) -> Option<&Posed> {
        self.newer.posed(frame).or_else(|| self.older.posed(frame))
    }

    fn version(&self, frame: usize) -> Option<u64> {
        let newer = self.newer.posed(frame).map(|_| 2);
        newer.or_else(|| self.older.posed(frame).map(|_| 1))
    }

    fn details(&self, _: usize) -> Option<&Details> {
        None
    }
}

#[test]
fn traces_are_those_of_the_functions_that_are_shown() {
    let mut app = app(40);
    let mixed = Mixed {
        older: Recorded::of(&STUB, &app.stage, 0..40),
        newer: Recorded::of(&solutions::FK, &app.stage, 15..40),
    };
    for (frame, points) in [(20, 6), (10, 11)] {
        app.go_to(frame);
        assert_eq!(app.scene(Shown::Student(&mixed), SIZE).trails[0].points.len(), points);
    }
}
