//! Where the camera of a motion stands.

use glam::Vec3;

use super::{App, Shown};
use crate::camera::Camera;
use crate::motion::stage::MARGIN;

/// What the camera does when the next scene is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aim {
    /// There was nothing to look at before: it looks at the motion from the beginning.
    Begin,
    /// Nobody has moved it yet: it takes in the student's joints as soon as there are any.
    Meet,
    /// It takes in everything.
    Everything,
    /// It stays where it was put, beside the root.
    Stay,
}

/// How near, in pixels, a click must be to a joint to mean it.
const CLICK: f32 = 14.0;

impl App {
    /// Looks from another side: `right` and `down` are how far the mouse was dragged, in pixels.
    pub fn orbit(&mut self, right: f32, down: f32) {
        self.aim = Aim::Stay;
        self.camera.orbit(-0.008 * right, 0.008 * down);
    }

    /// Moves the picture by so many pixels of a window of `size`.
    pub fn pan(&mut self, right: f32, down: f32, size: (usize, usize)) {
        self.aim = Aim::Stay;
        let before = self.camera.target;
        self.camera.pan(right, down, size);
        self.offset += self.camera.target - before;
    }

    /// The wheel was turned by this many notches, away from the user.
    pub fn wheel(&mut self, notches: f32) {
        self.aim = Aim::Stay;
        self.camera.zoom(0.88f32.powf(notches.clamp(-20.0, 20.0)));
        // Beyond this there is nothing to be seen.
        let size = self.stage.size();
        self.camera.distance = self.camera.distance.clamp(0.1 * size, 100.0 * size);
    }

    /// Looks from this side: the angles of [`Camera`], in degrees, and closer by the factor `zoom`.
    pub fn look_from(&mut self, azimuth: f32, elevation: f32, zoom: f32, size: (usize, usize)) {
        let anchor = self.stage.anchor(self.frame());
        let angles = (azimuth.to_radians(), elevation.to_radians());
        self.camera = self.stage.camera_from(angles, anchor, &[], size);
        self.camera.zoom(1.0 / zoom);
        self.step_back(size);
        self.offset = self.camera.target - anchor;
        self.aim = Aim::Stay;
    }

    /// Looks at the joint that is shown at (`x`, `y`) in a window of `size` pixels, if there is one.
    pub fn click(&mut self, shown: Shown, (x, y): (f32, f32), size: (usize, usize)) {
        let frame = self.frame();
        let reference = self.stage.reference(frame);
        let posed = match shown {
            _ if self.edited().is_some() => self.interpolated_pose(frame),
            Shown::Reference => None,
            Shown::Student(answers) => answers.posed(frame).map(|posed| &posed.pose),
        };
        let camera = self.present_camera(self.stage.anchor_of(&reference));
        let view = self.with_room(self.camera_between(camera), size).view(size);
        let spots = self.stage.places(posed.unwrap_or(&reference)).map(|place| view.project(place));
        let distances = spots.enumerate().filter_map(|(joint, spot)| {
            let spot = spot?;
            Some((joint, (spot.x - x).hypot(spot.y - y), spot.nearness))
        });
        let hit = distances.filter(|(_, distance, _)| *distance <= CLICK * self.settings.text_scale);
        // The one that is nearest to the click, by whole pixels, and of several in one place the one in front.
        let nearest = hit.min_by(|a, b| a.1.round().total_cmp(&b.1.round()).then(b.2.total_cmp(&a.2)));
        if let Some((joint, ..)) = nearest {
            self.selected = Some(joint);
        }
    }

    /// The camera as it stands now, when the followed point is at `anchor`.
    pub(super) fn present_camera(&self, anchor: Vec3) -> Camera {
        let target = if self.settings.follow { anchor + self.offset } else { self.camera.target };
        Camera { target, ..self.camera }
    }

    /// Moves the camera, if there is a reason to: see [`Aim`]. `places` are the reference's joints and `students` the
    /// student's.
    pub(super) fn aim(
        &mut self,
        anchor: Vec3,
        places: &[Vec3],
        students: Option<&[Vec3]>,
        size: (usize, usize),
    ) {
        match (self.aim, students) {
            (Aim::Stay, _) | (Aim::Meet, None) => {}
            (Aim::Begin, students) => {
                self.camera = self.stage.camera(anchor, students.unwrap_or_default(), size);
                self.step_back(size);
                self.offset = self.camera.target - anchor;
                self.aim = if students.is_some() { Aim::Stay } else { Aim::Meet };
            }
            (Aim::Meet, Some(students)) => {
                let angles = (self.camera.azimuth, self.camera.elevation);
                self.camera = self.stage.camera_from(angles, anchor, students, size);
                self.step_back(size);
                self.offset = self.camera.target - anchor;
                self.aim = Aim::Stay;
            }
            (Aim::Everything, students) => {
                let points = [places, students.unwrap_or_default()].concat();
                self.camera.frame(&points, size, MARGIN, 0.5 * self.stage.size());
                self.step_back(size);
                self.offset = self.camera.target - anchor;
                self.aim = Aim::Stay;
            }
        }
        self.camera = self.present_camera(anchor);
    }
}
