//! The pictures of the exercises on bones.

use std::sync::Arc;

use exam::{Functions, InProcess};
use glam::{EulerRot, Quat};
use skeleton::acclaim::{AcclaimFunctions, Between, Posture, TimeWarpFunctions};
use skeleton::{FkFunctions, Pose, pose_frame};

use super::Studio;
use crate::draw::canvas::{Canvas, Color, Weight};
use crate::live::board::Board;
use crate::live::mover::Mover;
use crate::motion::stage::MARGIN;
use crate::motion::time_map::TimeMap;
use crate::scene::{Look, Scene, Style};
use crate::view::answers::Recorded;
use crate::view::app::{App, Shown};
use crate::view::gallery::Gallery;
use crate::view::screen::Screen;

/// What a student has at the beginning.
pub(super) const STUB: AcclaimFunctions = grading::acclaim::TEMPLATE;

/// Parts 2 and 3.
pub(super) const STIFF: AcclaimFunctions =
    AcclaimFunctions { bone_rotation: STUB.bone_rotation, ..solutions::ACCLAIM };

/// A joint's rotation as a bone has it whose axes are the world's, by three angles about Z, Y and X, but multiplied in the order
/// X, Y, Z.
const TURNED_ROUND: FkFunctions = FkFunctions {
    local_quaternion: |joint, cursor| {
        let local = (solutions::FK.local_quaternion)(joint, cursor);
        let (z, y, x) = local.to_euler(EulerRot::ZYX);
        Quat::from_rotation_x(x) * Quat::from_rotation_y(y) * Quat::from_rotation_z(z)
    },
    ..solutions::FK
};

/// Part 2 with the angles about X and Z exchanged.
const MIXED_UP: TimeWarpFunctions = TimeWarpFunctions {
    blend,
    warp: |postures, new_count| {
        if postures.is_empty() {
            return Vec::new();
        }
        let frame = |index| {
            let Between { before, after, t } =
                (solutions::TIME_WARP.old_position)(index, postures.len(), new_count);
            blend(&postures[before], &postures[after], t)
        };
        (0..new_count).map(frame).collect()
    },
    ..solutions::TIME_WARP
};

fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
    let mut posture = (solutions::TIME_WARP.blend)(from, to, t);
    posture.angles.iter_mut().for_each(|angles| angles.reverse());
    posture
}

impl Studio {
    /// The window of the exercise on bones as it looks when a student's functions are these.
    pub(super) fn bones(&mut self, functions: AcclaimFunctions, frame: usize) -> Canvas {
        const SIZE: (usize, usize) = (960, 540);
        let mut app = App::new(self.walk.clone(), "walk.amc".into(), Vec::new(), SIZE);
        app.settings.bones = true;
        app.go_to(frame);
        let mut subject = InProcess(Functions::Acclaim(functions));
        let mut recorded = Recorded::ask(Mover::Acclaim, &mut subject, &self.walk, 0..=frame);
        recorded.standing.board = Some(Arc::new(Board::of(&mut subject, Mover::Acclaim.package())));
        self.draw(&app.scene(Shown::Student(&recorded), SIZE), SIZE)
    }

    /// One frame twice: with the three rotations of a bone multiplied as they are meant, and the other way round. It is one
    /// of the dance, as the walk's bones turn far about one axis only, and look nearly the same in both orders.
    pub(super) fn orders(&mut self) -> Canvas {
        const FRAME: usize = 28;
        const TILE: (usize, usize) = (480, 540);
        const SIDE: (f32, f32) = (1.05, 0.1);
        let stage = Arc::clone(&self.dance);
        let both = [("ZYX: Rz Ry Rx", solutions::FK), ("XYZ: Rx Ry Rz", TURNED_ROUND)];
        let mut picture = Canvas::new(2 * TILE.0, TILE.1);
        let poses = both.map(|(_, functions)| {
            let mut pose = Pose::default();
            pose_frame(stage.motion().skeleton(), &stage.frame(FRAME), &functions, &mut pose);
            pose
        });
        let points: Vec<_> = poses.iter().flat_map(|pose| stage.places(pose)).collect();
        for (column, ((order, _), pose)) in both.iter().zip(&poses).enumerate() {
            let mut scene = Scene {
                camera: stage.camera(stage.anchor(FRAME), &[], TILE),
                ground: stage.ground(),
                style: Style::Lit,
                size: stage.size(),
                text_scale: 1.0,
                ..Scene::default()
            };
            (scene.camera.azimuth, scene.camera.elevation) = SIDE;
            scene.camera.frame(&points, TILE, MARGIN, 0.0);
            *scene.figures.add() = stage.figure(pose, Look::Solid, false);
            let mut tile = self.draw(&scene, TILE);
            self.painter.caption(order, (16, TILE.1 as i32 - 18), 20, Weight::Regular, &mut tile);
            tile.rectangle((TILE.0 as i32 - 1, 0), (1, TILE.1 as i32), Color::WHITE, 0.7);
            picture.paste(&tile, column * TILE.0, 0);
        }
        picture
    }

    /// The window of the exercise on time warping, of a student whose part 2 takes angles for those about other axes.
    pub(super) fn warped_by_student(&mut self) -> Canvas {
        const SIZE: (usize, usize) = (1280, 720);
        const FRAME: usize = 301;
        let old = self.walk.moving_frames();
        let warped = Arc::new(self.walk.warped(TimeMap::Whole { old, new: 2 * old }));
        let mut subject = InProcess(Functions::TimeWarp(MIXED_UP));
        let mut recorded = Recorded::ask(Mover::TimeWarp, &mut subject, &warped, 0..warped.frame_count());
        recorded.standing.board = Some(Arc::new(Board::of(&mut subject, Mover::TimeWarp.package())));
        let app = |stage| App::new(stage, "walk.amc".into(), Vec::new(), (SIZE.0 / 2, SIZE.1));
        let mut gallery = Gallery::new(vec![app(self.walk.clone()), app(warped)]);
        gallery.show_points(Mover::TimeWarp, &recorded.standing.points());
        gallery.go_to(1, FRAME);
        let mut screen = Screen::new(SIZE);
        let shown = |motion: usize| if motion == 1 { Shown::Student(&recorded) } else { Shown::Reference };
        screen.update(&mut gallery, shown, SIZE);
        screen.canvas().clone()
    }
}
