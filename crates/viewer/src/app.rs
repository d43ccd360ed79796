//! What the viewer shows at a moment: the state that keys and mouse change, and the scene that follows from it.

use std::sync::Arc;

use exam::fk::PosedFrame;
use glam::Vec3;
use skeleton::Pose;

use crate::camera::Camera;
use crate::keys::Action;
use crate::player::Player;
use crate::scene::{Look, Scene, Style};
use crate::stage::{MARGIN, Stage};
use crate::student::Status;
use crate::texts::{self, Facts};

/// Whose functions move the figure.
#[derive(Clone, Copy, Debug)]
pub enum Shown<'a> {
    /// The reference solution's.
    Reference,
    /// The student's, with the reference's figure beside them as the goal.
    Student {
        /// What they made of the shown frame.
        posed: Option<&'a PosedFrame>,
        /// How things stand with them.
        status: &'a Status,
    },
}

/// What the camera does when the next scene is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Aim {
    /// Nobody has moved it yet: it takes in the student's joints as soon as there are any.
    Meet,
    /// It takes in everything.
    Everything,
    /// It stays where it was put, beside the root.
    Stay,
}

/// The state of the viewer.
#[derive(Clone, Debug)]
pub struct App {
    stage: Arc<Stage>,
    title: String,
    warnings: Vec<String>,
    player: Player,
    camera: Camera,
    /// From the followed point to the camera's target.
    offset: Vec3,
    aim: Aim,
    ghost: bool,
    axes: bool,
    help: bool,
}

impl App {
    /// Shows `stage` from its frame 0. `title` is the file's name; `warnings` are shown with it.
    pub fn new(stage: Arc<Stage>, title: String, warnings: Vec<String>, size: (usize, usize)) -> App {
        let anchor = stage.anchor(0);
        let camera = stage.camera(anchor, &[], size);
        App {
            player: Player::new(stage.frame_count(), stage.motion().playable_frame_time()),
            offset: camera.target - anchor,
            camera,
            stage,
            title,
            warnings,
            aim: Aim::Meet,
            ghost: true,
            axes: true,
            help: false,
        }
    }

    /// The frame to show, from 0.
    pub fn frame(&self) -> usize {
        self.player.frame()
    }

    /// Goes to `frame`, or to the last one.
    pub fn go_to(&mut self, frame: usize) {
        self.player.go_to(frame);
    }

    /// A line for the window's title bar.
    pub fn window_title(&self) -> String {
        let playing = if self.player.is_playing() { " · playing" } else { "" };
        format!("{} · frame {} / {}{playing}", self.title, self.frame(), self.stage.motion().frame_count())
    }

    /// Lets `seconds` pass.
    pub fn advance(&mut self, seconds: f64) {
        self.player.advance(seconds);
    }

    /// Does what a key asks for. [`Action::Quit`] is up to the window.
    pub fn act(&mut self, action: Action) {
        match action {
            Action::Next => self.player.next(),
            Action::Previous => self.player.previous(),
            Action::First => self.player.go_to(0),
            Action::Play => self.player.toggle(),
            Action::Frame => self.aim = Aim::Everything,
            Action::Ghost => self.ghost = !self.ghost,
            Action::Axes => self.axes = !self.axes,
            Action::Help => self.help = !self.help,
            Action::Quit => {}
        }
    }

    /// The mouse was dragged by this many pixels.
    pub fn drag(&mut self, right: f32, down: f32) {
        self.aim = Aim::Stay;
        self.camera.orbit(-0.008 * right, 0.008 * down);
    }

    /// The wheel was turned by this many notches, away from the user.
    pub fn wheel(&mut self, notches: f32) {
        self.aim = Aim::Stay;
        self.camera.zoom(0.88f32.powf(notches.clamp(-20.0, 20.0)));
    }

    /// Moves the camera, if there is a reason to: see [`Aim`].
    fn aim(&mut self, reference: &Pose, shown: Shown, size: (usize, usize)) {
        let anchor = self.stage.anchor(self.frame());
        match (self.aim, student_pose(shown)) {
            (Aim::Stay, _) | (Aim::Meet, None) => return,
            (Aim::Meet, Some(pose)) => self.camera = self.stage.camera(anchor, &places(pose), size),
            (Aim::Everything, pose) => {
                let mut points = places(reference);
                points.extend(pose.map(places).unwrap_or_default());
                self.camera.frame(&points, size, MARGIN, 0.5 * self.stage.size());
            }
        }
        self.offset = self.camera.target - anchor;
        self.aim = Aim::Stay;
    }

    /// What is to be seen now in a picture of `size` pixels.
    pub fn scene(&mut self, shown: Shown, size: (usize, usize)) -> Scene {
        let reference = self.stage.reference(self.frame());
        self.aim(&reference, shown, size);
        let stage = &self.stage;
        let mut camera = self.camera;
        camera.target = stage.anchor(self.frame()) + self.offset;

        let mut figures = Vec::new();
        let solid = match shown {
            Shown::Reference => Some(&reference),
            Shown::Student { .. } => {
                if self.ghost {
                    figures.push(stage.figure(&reference, Look::Ghost, false));
                }
                student_pose(shown)
            }
        };
        figures.extend(solid.map(|pose| stage.figure(pose, Look::Solid, self.axes)));

        let facts = Facts {
            stage,
            title: &self.title,
            warnings: &self.warnings,
            frame: self.frame(),
            playing: self.player.is_playing(),
            shown,
            solid,
            outside: solid.map_or(0, |pose| outside(pose, &camera, size)),
            ghost: self.ghost,
            axes: self.axes,
            help: self.help,
            roomy: size.0 >= 800 && size.1 >= 450,
        };
        let mut scene = Scene {
            camera,
            ground: stage.ground(),
            style: Style::Lines,
            size: stage.size(),
            figures: figures.into_iter().collect(),
            axis_length: stage.axis_length(),
            text_scale: 1.0,
            ..Scene::default()
        };
        texts::panels(&facts, &mut scene.panels);
        scene
    }
}

fn student_pose(shown: Shown<'_>) -> Option<&Pose> {
    match shown {
        Shown::Reference => None,
        Shown::Student { posed, .. } => posed.map(|posed| &posed.pose),
    }
}

fn places(pose: &Pose) -> Vec<Vec3> {
    pose.transforms().iter().map(|transform| transform.position).collect()
}

/// How many joints are in places that the picture does not show.
fn outside(pose: &Pose, camera: &Camera, size: (usize, usize)) -> usize {
    let view = camera.view(size);
    let inside = |place: Vec3| {
        view.project(place).is_some_and(|spot| {
            (0.0..size.0 as f32).contains(&spot.x) && (0.0..size.1 as f32).contains(&spot.y)
        })
    };
    places(pose).into_iter().filter(|place| place.is_finite() && !inside(*place)).count()
}

#[cfg(test)]
mod tests {
    use skeleton::{FkFunctions, PositionChannels, pose_frame};

    use super::*;
    use crate::samples;
    use crate::scene::Line;

    const SIZE: (usize, usize) = (800, 500);

    fn app(frames: usize) -> App {
        let stage = Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace));
        App::new(stage, "walk.bvh".into(), Vec::new(), SIZE)
    }

    /// What the stubs answer.
    fn stub(app: &App) -> PosedFrame {
        let functions = FkFunctions {
            local_quaternion: |_, _| glam::Quat::IDENTITY,
            global_quaternion: |_, local, _| local,
            global_position: |_, position, _| position,
        };
        let mut pose = Pose::default();
        let frame = app.stage.frame(app.frame());
        let leftover = pose_frame(app.stage.motion().skeleton(), &frame, &functions, &mut pose);
        PosedFrame { pose, taken: leftover.taken, available: leftover.available }
    }

    fn words(scene: &Scene) -> String {
        let lines = scene.panels.iter().flat_map(|panel| panel.lines()).map(|(line, text)| match line {
            Line::Key(key) => format!("{key} {text}"),
            _ => text.to_owned(),
        });
        lines.collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn the_solution_has_no_ghost_and_the_students_figure_has_one() {
        let mut app = app(5);
        let scene = app.scene(Shown::Reference, SIZE);
        assert_eq!(scene.figures.iter().map(|figure| figure.look).collect::<Vec<_>>(), [Look::Solid]);
        let stub = stub(&app);
        let shown = Shown::Student { posed: Some(&stub), status: &Status::Answered };
        let scene = app.scene(shown, SIZE);
        assert_eq!(
            scene.figures.iter().map(|figure| figure.look).collect::<Vec<_>>(),
            [Look::Ghost, Look::Solid]
        );
    }

    #[test]
    fn with_the_stubs_the_roots_square_moves_with_the_ghost_and_the_rest_stays() {
        let mut app = app(50);
        let mut seen = Vec::new();
        for frame in [0, 40] {
            app.go_to(frame);
            let stub = stub(&app);
            let scene = app.scene(Shown::Student { posed: Some(&stub), status: &Status::Answered }, SIZE);
            assert_eq!(scene.figures[0].joints[0], scene.figures[1].joints[0], "both roots share a place");
            seen.push(scene.figures[1].clone());
        }
        assert_ne!(seen[0].joints[0], seen[1].joints[0]);
        assert_eq!(seen[0].joints[1..], seen[1].joints[1..]);
        assert!(seen[1].axes.iter().all(|axes| axes.rotation == glam::Quat::IDENTITY));
    }

    #[test]
    fn joints_that_are_left_behind_are_told_and_f_brings_them_back() {
        let mut app = app(900);
        let first = stub(&app);
        app.scene(Shown::Student { posed: Some(&first), status: &Status::Answered }, SIZE);
        app.go_to(899);
        let stub = stub(&app);
        let shown = Shown::Student { posed: Some(&stub), status: &Status::Answered };
        assert!(words(&app.scene(shown, SIZE)).contains("4 of your 5 joints are outside"));
        app.act(Action::Frame);
        assert!(!words(&app.scene(shown, SIZE)).contains("outside"));
    }

    #[test]
    fn joints_that_are_not_drawn_are_told_for_the_reference_too() {
        let chain = samples::chain(2, 1.0);
        let mut values = chain.values().to_vec();
        // The last angles of the first frame, and the first position of the second.
        let channels = chain.skeleton().channel_count();
        (values[channels - 1], values[channels]) = (f32::NAN, 1e9);
        let motion = skeleton::Motion::new(chain.skeleton().clone(), 2, 0.1, values).unwrap();
        let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
        let mut app = App::new(stage, "odd.bvh".into(), Vec::new(), SIZE);
        let first = words(&app.scene(Shown::Reference, SIZE));
        assert!(first.contains("NaN or infinity as the place of 1 of the 5 joints"), "{first}");
        assert!(first.contains("too large for single precision"), "{first}");
        app.camera.target.x += 1e6;
        app.offset.x += 1e6;
        let first = words(&app.scene(Shown::Reference, SIZE));
        assert!(first.contains("4 of the 5 joints are outside"), "{first}");

        let ordinary = words(&self::app(5).scene(Shown::Reference, SIZE));
        assert!(!ordinary.contains("joints") && !ordinary.contains("precision"), "{ordinary}");
    }

    #[test]
    fn a_moved_camera_stays_where_it_was_put() {
        let mut app = app(5);
        app.drag(100.0, 20.0);
        let camera = app.scene(Shown::Reference, SIZE).camera;
        let stub = stub(&app);
        let shown = Shown::Student { posed: Some(&stub), status: &Status::Answered };
        assert_eq!(app.scene(shown, SIZE).camera, camera);
        app.wheel(3.0);
        assert!(app.scene(shown, SIZE).camera.distance < camera.distance);
    }

    #[test]
    fn the_words_say_where_we_are_and_what_is_wrong() {
        let mut app = app(5);
        app.act(Action::Next);
        assert_eq!(app.window_title(), "walk.bvh · frame 1 / 5");
        app.act(Action::Play);
        assert_eq!(app.window_title(), "walk.bvh · frame 1 / 5 · playing");
        app.act(Action::Play);
        assert!(words(&app.scene(Shown::Reference, SIZE)).contains("frame 1 / 5"));
        app.act(Action::Help);
        let help = words(&app.scene(Shown::Reference, SIZE));
        for binding in crate::keys::BINDINGS {
            assert!(help.contains(binding.help), "{}", binding.help);
        }
        let trouble = crate::worker::Trouble {
            headline: "your code does not compile".into(),
            details: vec!["error[E0308]: mismatched types".into()],
        };
        let failed = Status::Failed(trouble.into());
        for (status, expected) in [
            (&Status::Compiling, "compiling"),
            (&Status::Asking, "asking your functions"),
            (&failed, "E0308"),
        ] {
            let scene = app.scene(Shown::Student { posed: None, status }, SIZE);
            assert!(words(&scene).contains(expected), "{}", words(&scene));
            assert_eq!(scene.figures.len(), 1, "the ghost is still there");
        }
        assert!(words(&self::app(0).scene(Shown::Reference, SIZE)).contains("rest pose"));
        assert!(words(&self::app(1).scene(Shown::Reference, SIZE)).contains("only one frame"));
    }
}
