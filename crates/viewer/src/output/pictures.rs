//! The book's pictures, made by the viewer itself so that they show what students see.

mod bones;

use std::sync::Arc;

use exam::{Functions, InProcess};
use glam::{Quat, Vec3};
use skeleton::{FkFunctions, JointId, Motion, Pose, PositionChannels, Transform};

use crate::draw::Painter;
use crate::draw::canvas::{Canvas, Color, Weight};
use crate::edit::ReferenceHand;
use crate::live::board::Board;
use crate::live::package::Package;
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;
use crate::scene::{Axes, Dot, Figure, Look, Mark, Scene, Side, Style, Tint};
use crate::view::answers::Recorded;
use crate::view::app::{App, Shown};
use crate::view::gallery::Gallery;
use crate::view::screen::Screen;

/// One picture: the name of its file, and how it is made.
pub struct Picture {
    /// The file's name in `docs/pictures/`, without `.png`.
    pub name: &'static str,
    draw: fn(&mut Studio) -> Canvas,
}

impl Picture {
    /// Makes the picture.
    pub fn draw(&self, studio: &mut Studio) -> Canvas {
        (self.draw)(studio)
    }
}

/// All pictures.
pub const PICTURES: [Picture; 16] = [
    Picture { name: "stub-frame-0", draw: |studio| studio.window(STUB, 0) },
    Picture { name: "stub-frame-300", draw: |studio| studio.window(STUB, 300) },
    Picture { name: "part-1", draw: |studio| studio.window(PART_1, 40) },
    Picture { name: "parts-1-and-2", draw: |studio| studio.window(PARTS_1_AND_2, 40) },
    Picture { name: "solved", draw: |studio| studio.window(solutions::FK, 300) },
    Picture { name: "window", draw: Studio::joint },
    Picture { name: "keyframes", draw: Studio::keyframes },
    Picture { name: "acclaim-stub", draw: |studio| studio.bones(bones::STUB, 100) },
    Picture { name: "acclaim-stiff", draw: |studio| studio.bones(bones::STIFF, 100) },
    Picture { name: "acclaim-order", draw: Studio::orders },
    Picture { name: "time-warp", draw: Studio::time_warp },
    Picture { name: "time-warp-mixed", draw: Studio::warped_by_student },
    Picture { name: "rest-pose", draw: Studio::rest_pose },
    Picture { name: "local-and-global", draw: Studio::local_and_global },
    Picture { name: "run", draw: Studio::run },
    Picture { name: "hero", draw: Studio::hero },
];

/// What a student has at the beginning.
const STUB: FkFunctions = FkFunctions {
    local_quaternion: |_, _| Quat::IDENTITY,
    global_quaternion: |_, local, _| local,
    global_position: |_, local_position, _| local_position,
};

const PART_1: FkFunctions = FkFunctions { local_quaternion: solutions::FK.local_quaternion, ..STUB };

const PARTS_1_AND_2: FkFunctions =
    FkFunctions { global_quaternion: solutions::FK.global_quaternion, ..PART_1 };

const SIZE: (usize, usize) = (960, 540);

/// Part 3 without the parent's rotation: what the viewer's page shows.
const UNTURNED: FkFunctions = FkFunctions {
    global_position: |joint, local_position, pose| {
        local_position + joint.parent.map_or(Vec3::ZERO, |parent| pose[parent].position)
    },
    ..solutions::FK
};

/// A motion, and what is needed to draw it.
pub struct Studio {
    stage: Arc<Stage>,
    dance: Arc<Stage>,
    walk: Arc<Stage>,
    painter: Painter,
}

impl Studio {
    /// Makes pictures of a run, of a dance, and of a walk of bones.
    pub fn new(running: Motion, dance: Motion, walk: Arc<Stage>) -> Studio {
        let [stage, dance] =
            [running, dance].map(|motion| Arc::new(Stage::new(motion, PositionChannels::Replace)));
        Studio { stage, dance, walk, painter: Painter::new() }
    }

    /// The window as it looks when a student's functions are these.
    fn window(&mut self, functions: FkFunctions, frame: usize) -> Canvas {
        let mut app = App::new(self.stage.clone(), "running.bvh".into(), Vec::new(), SIZE);
        app.go_to(frame);
        let recorded = judged(functions, &self.stage, frame);
        let shown = Shown::Student(&recorded);
        self.draw(&app.scene(shown, SIZE), SIZE)
    }

    /// The window with all that it says: points, and a joint that is off.
    fn joint(&mut self) -> Canvas {
        const SIZE: (usize, usize) = (1280, 720);
        const FRAME: usize = 56;
        let mut app = App::new(self.stage.clone(), "running.bvh".into(), Vec::new(), SIZE);
        app.go_to(FRAME);
        app.select(self.bone_to("LeftLeg").map(|(_, joint)| joint.0));
        let recorded = judged(UNTURNED, &self.stage, FRAME);
        self.draw(&app.scene(Shown::Student(&recorded), SIZE), SIZE)
    }

    /// The window while a motion is reduced to keyframes: how far the tips are off, and how the error grows.
    fn keyframes(&mut self) -> Canvas {
        const SIZE: (usize, usize) = (1280, 720);
        const FRAME: usize = 118;
        let mut app = App::new(self.dance.clone(), "dance.bvh".into(), Vec::new(), SIZE);
        let edit = &mut app.settings.edit;
        (edit.automatic, edit.keyframes) = (true, 12);
        (edit.errors, edit.plot) = (true, true);
        app.settings.axes = false;
        app.edit(&mut ReferenceHand::default());
        app.go_to(FRAME);
        self.draw(&app.scene(Shown::Reference, SIZE), SIZE)
    }

    /// The window with a motion and the same one warped: one step of a run in slow motion.
    fn time_warp(&mut self) -> Canvas {
        const SIZE: (usize, usize) = (1280, 720);
        const FRAME: usize = 320;
        let Some(map) = TimeMap::stretch(self.stage.moving_frames(), (230, 300), 280) else {
            return Canvas::new(1, 1);
        };
        let app = |stage| App::new(stage, "running.bvh".into(), Vec::new(), (SIZE.0 / 2, SIZE.1));
        let mut gallery = Gallery::new(vec![app(self.stage.clone()), app(Arc::new(self.stage.warped(map)))]);
        gallery.go_to(1, FRAME);
        let mut screen = Screen::new(SIZE);
        screen.update(&mut gallery, |_| Shown::Reference, SIZE);
        screen.canvas().clone()
    }

    /// The skeleton with nothing turned: every joint's name and axes.
    fn rest_pose(&mut self) -> Canvas {
        let skeleton = self.stage.motion().skeleton();
        let at = |position| Transform { position, ..Transform::IDENTITY };
        let pose = Pose::from(skeleton.rest_positions().into_iter().map(at).collect::<Vec<_>>());
        let mut marks = Vec::new();
        for joint in skeleton.joints() {
            let finger = ["Finger", "Thumb", "Index"].iter().any(|part| joint.name.contains(part));
            if joint.is_end_site || finger {
                continue;
            }
            let place = pose[joint.id].position;
            let outwards = if place.x < 0.0 { -1 } else { 1 };
            let text_offset = match joint.name.trim_start_matches("Left").trim_start_matches("Right") {
                "Hips" => (60, -4),
                "UpLeg" => (outwards * 14, 10),
                "Shoulder" => (outwards * 20, -70),
                "Arm" => (outwards * 30, 44),
                "ForeArm" => (0, -34),
                "Hand" => (outwards * 10, 36),
                _ => (outwards * 14, 0),
            };
            marks.push(Mark {
                from: None,
                to: place,
                text: joint.name.clone(),
                text_offset,
                tint: Tint::Ink,
            });
        }
        let figure = self.stage.figure(&pose, Look::Solid, true);
        let mut scene = self.scene(vec![figure], marks);
        (scene.camera.azimuth, scene.camera.elevation) = (0.3, 0.1);
        // At rest the root is at the origin; the ground is below the feet.
        scene.ground.height = pose.transforms().iter().map(|t| t.position.y).fold(0.0, f32::min);
        let points: Vec<Vec3> = pose.transforms().iter().map(|transform| transform.position).collect();
        scene.camera.frame(&points, SIZE, 0.07, self.stage.size() * 0.5);
        self.draw(&scene, SIZE)
    }

    /// Part 3 in one picture: from the parent's place, along the parent's axes, to the joint's place.
    fn local_and_global(&mut self) -> Canvas {
        const FRAME: usize = 56;
        let pose = self.stage.reference(FRAME);
        let Some((knee, foot)) = self.bone_to("LeftFoot") else { return Canvas::new(1, 1) };
        let (parent, joint) = (pose[knee], pose[foot].position);
        let local = self.stage.frame(FRAME).local_positions[foot.0];
        let mark =
            |from, to, text: &str, text_offset, tint| Mark { from, to, text: text.into(), text_offset, tint };
        let (origin, unturned) = (Vec3::ZERO, parent.position + local);
        let marks = vec![
            mark(Some(origin), parent.position, "the parent's position", (-34, -40), Tint::Ink),
            mark(Some(parent.position), unturned, "the local position, not turned", (14, 8), Tint::Ghost),
            mark(Some(parent.position), joint, "", (0, 0), Tint::Bone(Side::Left)),
            mark(
                None,
                parent.position.midpoint(joint),
                "turned by the parent's rotation",
                (40, -34),
                Tint::Bone(Side::Left),
            ),
            mark(Some(origin), joint, "the global position", (16, 0), Tint::Joint),
            mark(None, origin, "the origin", (0, 20), Tint::Ink),
        ];
        let mut figure = self.stage.figure(&pose, Look::Echo(0.8), false);
        figure.axes = vec![Axes {
            origin: parent.position,
            rotation: parent.rotation,
            length: 0.07 * self.stage.size(),
            lettered: true,
        }];
        let joints = vec![parent.position, joint, origin];
        let joints = joints.into_iter().map(Dot::from).collect();
        let squares = Figure { joints, ..Figure::default() };
        let mut scene = self.scene(vec![figure, squares], marks);
        (scene.camera.azimuth, scene.camera.elevation) = (1.35, 0.1);
        let mut points = vec![origin, unturned];
        points.extend(pose.transforms().iter().map(|transform| transform.position));
        scene.camera.frame(&points, SIZE, 0.05, 0.0);
        self.draw(&scene, SIZE)
    }

    /// One stride, frame by frame.
    fn run(&mut self) -> Canvas {
        const COLUMNS: usize = 6;
        const STEP: usize = 14;
        const TILE: (usize, usize) = (240, 320);
        let mut sheet = Canvas::new(COLUMNS * TILE.0, TILE.1);
        for column in 0..COLUMNS {
            let frame = column * STEP;
            let figure = self.stage.figure(&self.stage.reference(frame), Look::Solid, false);
            let mut scene = self.scene(vec![figure], Vec::new());
            scene.style = Style::Lit;
            scene.camera = self.stage.camera(self.stage.anchor(frame), &[], TILE);
            let mut tile = self.draw(&scene, TILE);
            let text = format!("frame {frame}");
            self.painter.caption(&text, (12, TILE.1 as i32 - 14), 15, Weight::Regular, &mut tile);
            tile.rectangle((TILE.0 as i32 - 1, 0), (1, TILE.1 as i32), Color::WHITE, 0.7);
            sheet.paste(&tile, column * TILE.0, 0);
        }
        sheet
    }

    /// A run in one picture: the figure, and where it was before.
    fn hero(&mut self) -> Canvas {
        const SIZE: (usize, usize) = (1280, 640);
        const LAST: usize = 216;
        const STEP: usize = 24;
        const AHEAD: f32 = 0.28;
        const ASIDE: f32 = 0.36;
        let mut figures = Vec::new();
        for frame in (0..=LAST).step_by(STEP) {
            let strength = 0.25 + 0.9 * (frame as f32 / LAST as f32).powi(2);
            let look = if frame == LAST { Look::Solid } else { Look::Echo(strength) };
            figures.push(self.stage.figure(&self.stage.reference(frame), look, frame == LAST));
        }
        let mut scene = self.scene(figures, Vec::new());
        scene.style = Style::Lit;
        // From ahead of the runner, so that the echoes stand behind, and to the right of it.
        let runner = scene.figures.last().map(|figure| figure.joints.clone()).unwrap_or_default();
        (scene.camera.azimuth, scene.camera.elevation) = (scene.camera.azimuth - AHEAD, 0.12);
        let runner: Vec<Vec3> = runner.into_iter().map(|dot| dot.place).collect();
        scene.camera.frame(&runner, SIZE, 0.06, 0.0);
        scene.camera.target += scene.camera.view(SIZE).right * ASIDE * self.stage.size();
        self.draw(&scene, SIZE)
    }

    /// A scene around the first frame, without texts.
    fn scene(&self, figures: Vec<Figure>, marks: Vec<Mark>) -> Scene {
        Scene {
            camera: self.stage.camera(self.stage.anchor(0), &[], SIZE),
            ground: self.stage.ground(),
            style: Style::Lines,
            size: self.stage.size(),
            figures: figures.into_iter().collect(),
            marks,
            text_scale: 1.0,
            ..Scene::default()
        }
    }

    fn draw(&mut self, scene: &Scene, size: (usize, usize)) -> Canvas {
        let mut canvas = Canvas::new(size.0, size.1);
        self.painter.draw(scene, &mut canvas);
        canvas
    }

    /// The joint with this name, behind its parent.
    fn bone_to(&self, name: &str) -> Option<(JointId, JointId)> {
        let joint = self.stage.motion().skeleton().joints().iter().find(|joint| joint.name == name)?;
        Some((joint.parent?, joint.id))
    }
}

/// The answers of `functions` up to a frame, and their points.
fn judged(functions: FkFunctions, stage: &Stage, frame: usize) -> Recorded {
    let mut recorded = Recorded::of(&functions, stage, 0..=frame);
    let board = Board::of(&mut InProcess(Functions::Fk(functions)), Package::Fk);
    recorded.standing.board = Some(Arc::new(board));
    recorded
}
