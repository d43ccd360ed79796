//! Where the camera stands.

use super::*;

#[test]
fn a_moved_camera_stays_where_it_was_put() {
    let mut app = app(5);
    app.orbit(100.0, 20.0);
    let camera = app.scene(Shown::Reference, SIZE).camera;
    let stub = answers(&app, STUB);
    assert_eq!(app.scene(Shown::Student(&stub), SIZE).camera, camera);
    app.wheel(3.0);
    assert!(app.scene(Shown::Student(&stub), SIZE).camera.distance < camera.distance);
}

#[test]
fn it_moves_along_with_the_figure_or_stays() {
    let mut app = app(50);
    let first = app.scene(Shown::Reference, SIZE).camera;
    app.go_to(40);
    let along = app.scene(Shown::Reference, SIZE).camera;
    assert!((along.target.x - first.target.x - 4.0).abs() < 1e-4, "{along:?}");
    app.act(Action::Follow);
    app.go_to(0);
    assert_eq!(app.scene(Shown::Reference, SIZE).camera, along);
    app.pan(100.0, 0.0, SIZE);
    let moved = app.scene(Shown::Reference, SIZE).camera;
    assert_ne!(moved, along);
    app.act(Action::Follow);
    assert_eq!(app.scene(Shown::Reference, SIZE).camera, moved, "no leap when it follows again");
}

#[test]
fn a_chosen_side_is_kept() {
    let mut app = app(5);
    app.look_from(90.0, 30.0, 2.0, SIZE);
    let stub = answers(&app, STUB);
    let camera = app.scene(Shown::Student(&stub), SIZE).camera;
    assert!((camera.azimuth.to_degrees() - 90.0).abs() < 1e-3, "{camera:?}");
    assert!((camera.elevation.to_degrees() - 30.0).abs() < 1e-3, "{camera:?}");
    let mut far = self::app(5);
    far.look_from(90.0, 30.0, 1.0, SIZE);
    let far = far.scene(Shown::Reference, SIZE).camera;
    assert!((far.distance / camera.distance - 2.0).abs() < 1e-3);
}

#[test]
fn a_click_selects_the_joint_that_is_there() {
    let mut app = app(5);
    app.go_to(3);
    let scene = app.scene(Shown::Reference, SIZE);
    let view = scene.camera.view(SIZE);
    for (joint, dot) in scene.figures[0].joints.iter().enumerate() {
        let spot = view.project(dot.place).unwrap();
        app.click(Shown::Reference, (spot.x + 1.0, spot.y), SIZE);
        assert_eq!(app.selected(), Some(joint));
    }
    app.click(Shown::Reference, (1.0, 1.0), SIZE);
    assert_eq!(app.selected(), Some(4), "nothing is there");
}
