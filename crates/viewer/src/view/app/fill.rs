//! From the state of the viewer to what is to be seen.

use glam::Vec3;
use grading::PartState;
use skeleton::Pose;

use super::aim::Aim;
use super::{App, Shown};
use crate::camera::Camera;
use crate::draw::ruler;
use crate::live::board::Board;
use crate::live::mover::Mover;
use crate::motion::stage::{Moment, Wanted};
use crate::scene::{Figure, Look, Mark, Off, ScaleBar, Scene, Timeline, Tint, Trail};
use crate::view::texts::{self, Facts, OfBones};

/// How long a trace is: seconds of the motion, and points in it.
const TRACE_SECONDS: f64 = 2.0;
const TRACE_POINTS: usize = 120;

impl App {
    /// What is to be seen now in a picture of `size` pixels.
    pub fn scene(&mut self, shown: Shown, size: (usize, usize)) -> Scene {
        let mut scene = Scene::default();
        self.fill(&mut scene, shown, size);
        scene
    }

    /// Makes `scene` what is to be seen now in a picture of `size` pixels. Its memory is used again.
    pub fn fill(&mut self, scene: &mut Scene, shown: Shown, size: (usize, usize)) {
        let mut memory = std::mem::take(&mut self.memory);
        let frame = self.frame();
        let edited = self.edited().cloned();
        // Of an edited motion both figures are the reference's.
        let shown = if edited.is_some() { Shown::Reference } else { shown };
        let mover = match shown {
            Shown::Reference => None,
            Shown::Student(answers) => Some(answers.mover()),
        };
        let of_bones = mover.map_or(self.settings.bones && edited.is_none(), Mover::needs_bones);
        self.stage.read(frame, of_bones, &mut memory.now);
        let anchor = self.stage.anchor_of(&memory.now.pose);
        let interpolated = edited.as_ref().and_then(|edited| edited.pose(frame));
        let posed = match shown {
            Shown::Reference => None,
            Shown::Student(answers) => answers.posed(frame),
        };
        self.point_camera(
            &memory.now.pose,
            (posed.map(|posed| &posed.pose), interpolated),
            anchor,
            &mut memory.points,
            size,
        );

        let (stage, settings) = (&self.stage, self.settings);
        let beside = self.beside();
        scene.camera = self.with_room(self.camera_between(self.camera), size);
        scene.ground = stage.ground();
        scene.style = settings.style;
        scene.size = stage.size();
        scene.text_scale = settings.text_scale;
        scene.marks.clear();
        scene.figures.clear();
        scene.trails.clear();
        scene.panels.clear();
        scene.keyframes.clear();

        let standing = match shown {
            Shown::Reference => None,
            Shown::Student(answers) => Some(answers.standing(frame)),
        };
        // Before what puts joints in their places is begun none can be where it belongs: nothing is wrong yet.
        let board =
            standing.as_ref().and_then(|standing| standing.board.as_ref().or(standing.former.as_ref()));
        let begun = |board: &Board, part: usize| {
            board.rows.get(part).is_none_or(|row| row.state != PartState::NotStarted)
        };
        let placing = mover.map_or(&[][..], |mover| mover.placing_parts(stage));
        let judged = board.is_some_and(|board| placing.iter().all(|part| begun(board, *part)));
        let solid = match shown {
            Shown::Reference => Some(interpolated.unwrap_or(&memory.now.pose)),
            Shown::Student(_) => posed.map(|posed| &posed.pose),
        };
        if (standing.is_some() || edited.is_some()) && settings.ghost {
            let wanted = Wanted { look: Look::Ghost, ..Wanted::default() };
            let ghost = scene.figures.add();
            stage.fill(ghost, &memory.now.pose, &wanted);
            if let Some(beside) = beside {
                ghost.shift(beside);
            }
        }
        if let Some(pose) = solid {
            let outdated = interpolated.is_some() && self.is_outdated();
            let current = standing.as_ref().is_none_or(|standing| standing.current) && !outdated;
            let wanted = Wanted {
                look: match current {
                    true if self.flashes(frame) => Look::Flash,
                    true => Look::Solid,
                    false => Look::Dimmed,
                },
                axes: settings.axes,
                expected: standing.as_ref().map(|_| &memory.now.pose),
                judged,
                selected: self.selected,
                places: posed.and_then(|posed| posed.places()),
            };
            stage.fill(scene.figures.add(), pose, &wanted);
        }
        if let Some(pose) = interpolated.filter(|_| settings.edit.errors) {
            self.error_vectors(scene, pose, &memory.now.pose);
        }
        let worst = scene.figures.last().map_or(Off::Right, worst);

        if settings.traces {
            self.trace(scene, shown, of_bones, &mut memory.past);
        }
        scene.timeline = self.timeline();
        if let Some(edited) = edited.as_ref().filter(|_| settings.words) {
            scene.keyframes.extend_from_slice(&edited.keyframes);
        }
        if let Some(stretch) = self.stretch().filter(|_| settings.words) {
            scene.keyframes.extend(stretch);
            scene.keyframes.sort_unstable();
            scene.keyframes.dedup();
        }
        self.fill_plot(&mut scene.plot, shown);
        if settings.words {
            scale_bar(scene, size);
            let facts =
                Facts {
                    app: self,
                    shown,
                    standing: standing.as_ref(),
                    posed,
                    solid,
                    reference: &memory.now.pose,
                    angles: &memory.now.frame.angles,
                    local_positions: &memory.now.frame.local_positions,
                    bones: stage.bones().filter(|_| of_bones && self.selected.is_some()).map(|bones| {
                        OfBones { bones, posture: &memory.now.posture, expected: &memory.now.places }
                    }),
                    worst,
                    edited: edited.as_deref(),
                    outside: solid.map_or(0, |pose| outside(stage.places(pose), &scene.camera, size)),
                    size: (size.0 as f32 / settings.text_scale, size.1 as f32 / settings.text_scale),
                };
            match (texts::panels(&facts, &mut scene.panels), &mut scene.plot) {
                (Some(behind), Some(plot)) => plot.behind = behind,
                _ => scene.plot = None,
            }
        } else {
            scene.scale_bar = None;
        }
        self.memory = memory;
    }

    /// The bar that shows the frame among all frames, where there is one.
    pub fn timeline(&self) -> Option<Timeline> {
        let player = &self.player;
        (self.settings.words && player.count() > 1).then(|| Timeline {
            frame: player.frame(),
            count: player.count(),
            range: player.range(),
            playing: player.is_playing(),
        })
    }

    /// Arrows from the tips of an interpolated figure to where they are in the original, for those that are clearly off.
    fn error_vectors(&self, scene: &mut Scene, pose: &Pose, original: &Pose) {
        let stage = &self.stage;
        for tip in &self.tips {
            let place = |pose: &Pose| stage.place(pose.transforms()[*tip].position);
            let (from, to) = (place(pose), place(original));
            if Off::by(from.distance(to) / stage.size()) > Off::Right && from.is_finite() {
                let (text, text_offset) = (String::new(), (0, 0));
                scene.marks.push(Mark { from: Some(from), to, text, text_offset, tint: Tint::Error });
            }
        }
    }

    fn point_camera(
        &mut self,
        reference: &Pose,
        (students, interpolated): (Option<&Pose>, Option<&Pose>),
        anchor: Vec3,
        places: &mut Vec<Vec3>,
        size: (usize, usize),
    ) {
        let stage = self.stage.clone();
        let beside = self.beside();
        places.clear();
        places.extend(stage.places(reference));
        if self.aim == Aim::Everything && (interpolated.is_some() || beside.is_some()) {
            // The camera will stand beside the figure that it looks at.
            let (aside, back) = (beside.unwrap_or(Vec3::ZERO), -0.5 * beside.unwrap_or(Vec3::ZERO));
            places.iter_mut().for_each(|place| *place += aside + back);
            places.extend(stage.places(interpolated.unwrap_or(reference)).map(|place| place + back));
        }
        let own = places.len();
        places.extend(students.into_iter().flat_map(|pose| stage.places(pose)));
        let (reference, own) = places.split_at(own);
        self.aim(anchor, reference, students.map(|_| own), size);
    }

    /// How many frames a trace goes back, the shown one included.
    pub fn traced_frames(&self) -> usize {
        let (count, seconds) = (self.stage.frame_count(), self.stage.motion().playable_frame_time());
        // A float cast keeps to the range of its type.
        ((TRACE_SECONDS / seconds) as usize).clamp(1, count)
    }

    /// Where the tips of the solid figure have been: `of_bones` is how the reference is drawn now.
    fn trace(&self, scene: &mut Scene, shown: Shown, of_bones: bool, past: &mut Moment) {
        let stage = &self.stage;
        let tips = stage.traced();
        let most = self.traced_frames();
        // Every so many frames of the motion, so that points do not crawl along their trace.
        let step = most.div_ceil(TRACE_POINTS).max(1);
        for (index, tip) in tips.iter().enumerate() {
            let trail = scene.trails.add();
            (trail.index, trail.side) = (index, stage.side(*tip));
            trail.points.clear();
        }
        for index in self.player.traced(most) {
            if index % step != 0 && index != self.frame() {
                continue;
            }
            let pose = match shown {
                Shown::Reference => Some(self.interpolated_pose(index).unwrap_or_else(|| {
                    stage.read(index, of_bones, past);
                    &past.pose
                })),
                // Where an older version had put them is not where these functions put them.
                Shown::Student(answers) if answers.version(index) != answers.version(self.frame()) => None,
                Shown::Student(answers) => answers.posed(index).map(|posed| &posed.pose),
            };
            let Some(pose) = pose else { continue };
            for (trail, tip) in scene.trails.items_mut().iter_mut().zip(tips) {
                extend(trail, stage.place(pose.transforms()[*tip].position));
            }
        }
    }
}

/// Adds a point, if it is one.
fn extend(trail: &mut Trail, place: Vec3) {
    if place.is_finite() {
        trail.points.push(place);
    }
}

/// How far the joint that is farthest off is off, of those that are drawn.
fn worst(figure: &Figure) -> Off {
    let drawn = figure.joints.iter().filter(|dot| dot.place.is_finite());
    drawn.map(|dot| dot.off).max().unwrap_or(Off::Right)
}

/// A length to compare with, where one fits.
fn scale_bar(scene: &mut Scene, size: (usize, usize)) {
    let Some(length) = ruler::fitting_length(&scene.camera, size, scene.text_scale) else {
        scene.scale_bar = None;
        return;
    };
    let bar = scene.scale_bar.get_or_insert_with(ScaleBar::default);
    bar.length = length;
    bar.label.clear();
    texts::write_units(&mut bar.label, length);
}

/// How many places the picture does not show.
fn outside(places: impl Iterator<Item = Vec3>, camera: &Camera, size: (usize, usize)) -> usize {
    let view = camera.view(size);
    let inside = |place: Vec3| {
        view.project(place).is_some_and(|spot| {
            (0.0..size.0 as f32).contains(&spot.x) && (0.0..size.1 as f32).contains(&spot.y)
        })
    };
    places.filter(|place| place.is_finite() && !inside(*place)).count()
}
