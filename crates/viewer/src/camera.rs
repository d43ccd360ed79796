//! From the world to the picture: an orbiting camera, and the projection that it makes.
//!
//! The world is right-handed with Y up. In the picture x goes right and y goes down, in pixels; the centre of the
//! first pixel is at (0.5, 0.5).

use glam::{Vec2, Vec3};

/// Half of the angle that the shorter side of the picture covers.
const HALF_ANGLE_OF_VIEW: f32 = 0.35;

/// The steepest look down or up. Straight down would leave no direction for "right".
const STEEPEST: f32 = 1.5;

/// The range of distances to the target, in world units: whatever the unit, single precision has room on both sides.
const NEAREST: f32 = 1e-30;
const FARTHEST: f32 = 1e30;

/// A camera that looks at a point and circles around it. It never rolls: the horizon stays level.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Camera {
    /// The point in the middle of the picture, in world units.
    pub target: Vec3,
    /// Where the camera stands around the target: 0 is along +Z, a quarter turn is along +X. Radians.
    pub azimuth: f32,
    /// How high the camera stands: 0 is level with the target, positive is above it. Radians.
    pub elevation: f32,
    /// From the camera to the target, in world units. Positive.
    pub distance: f32,
}

impl Camera {
    /// Circles around the target by these angles, in radians, and stays short of straight above and below.
    pub fn orbit(&mut self, azimuth: f32, elevation: f32) {
        if !(azimuth.is_finite() && elevation.is_finite()) {
            return;
        }
        self.azimuth = (self.azimuth + azimuth).rem_euclid(std::f32::consts::TAU);
        self.elevation = (self.elevation + elevation).clamp(-STEEPEST, STEEPEST);
    }

    /// Moves towards the target (`factor` below 1) or away from it.
    pub fn zoom(&mut self, factor: f32) {
        if factor.is_finite() {
            self.distance = (self.distance * factor).clamp(NEAREST, FARTHEST);
        }
    }

    /// Moves sideways so that what is at the target's distance moves by these many pixels of a picture of `size`.
    pub fn pan(&mut self, right: f32, down: f32, size: (usize, usize)) {
        let view = self.view(size);
        let moved = self.target - (view.right * right - view.up * down) * (self.distance / view.focal);
        if moved.is_finite() {
            self.target = moved;
        }
    }

    /// Looks at the middle of `points` from just as far that all of them are inside the picture, `margin` away from
    /// its borders (0.1 leaves a tenth of the picture free on each side). The direction stays. `room` is the least
    /// size, in world units, that the picture shows, so that a single point is not looked at from no distance at all.
    pub fn frame(&mut self, points: &[Vec3], size: (usize, usize), margin: f32, room: f32) {
        let mut finite = points.iter().copied().filter(|point| point.is_finite());
        let Some(first) = finite.next() else { return };
        let (low, high) = finite.fold((first, first), |(low, high), p| (low.min(p), high.max(p)));
        self.target = low.midpoint(high);

        let view = self.view(size);
        let limit =
            (1.0 - 2.0 * margin).max(0.1) / (2.0 * view.focal) * Vec2::new(size.0 as f32, size.1 as f32);
        let mut distance = 0.5 * room / limit.min_element();
        for point in points.iter().filter(|point| point.is_finite()) {
            let seen = view.turned(*point - self.target);
            let aside = Vec2::new(seen.x.abs(), seen.y.abs()) / limit;
            // The second keeps a point on the line of sight off the camera itself.
            distance = distance.max(aside.max_element() - seen.z).max(-1.1 * seen.z);
        }
        self.distance = distance.clamp(NEAREST, FARTHEST);
    }

    /// What this camera sees in a picture of `size` (width, height) pixels.
    pub fn view(&self, size: (usize, usize)) -> View {
        let elevation = self.elevation.clamp(-STEEPEST, STEEPEST);
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = elevation.sin_cos();
        let back = Vec3::new(sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation);
        let right = Vec3::new(cos_azimuth, 0.0, -sin_azimuth);
        let centre = Vec2::new(size.0 as f32, size.1 as f32) * 0.5;
        View {
            eye: self.target + back * self.distance,
            right,
            up: back.cross(right),
            forward: -back,
            focal: centre.min_element().max(0.5) / HALF_ANGLE_OF_VIEW.tan(),
            centre,
            near: self.distance * 0.01,
        }
    }
}

/// A place in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// In pixels, from the left.
    pub x: f32,
    /// In pixels, from the top.
    pub y: f32,
    /// One over the distance from the camera along its line of sight, in world units: larger is nearer. Unlike the
    /// distance itself it changes evenly along a line in the picture.
    pub nearness: f32,
}

/// A camera set up for a picture of one size: the pinhole projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where the camera is, in world units.
    pub eye: Vec3,
    /// The world direction that points right in the picture. A unit vector, always level.
    pub right: Vec3,
    /// The world direction that points up in the picture. A unit vector.
    pub up: Vec3,
    /// The world direction of the line of sight. A unit vector.
    pub forward: Vec3,
    /// Pixels per unit of slope: what stands 1 aside at a distance of 1 is this far from the middle.
    pub focal: f32,
    /// The middle of the picture, in pixels.
    pub centre: Vec2,
    /// Nothing nearer to the camera than this is seen, in world units.
    pub near: f32,
}

impl View {
    /// Where `point` is in the picture (or outside of it); `None` when it is behind the camera, too near, or not
    /// made of numbers.
    pub fn project(&self, point: Vec3) -> Option<Spot> {
        self.project_turned(self.turned(point - self.eye))
    }

    /// Both ends of the part of a line that is in front of the camera; `None` when no part of it is.
    pub fn project_line(&self, from: Vec3, to: Vec3) -> Option<(Spot, Spot)> {
        let (mut from, mut to) = (self.turned(from - self.eye), self.turned(to - self.eye));
        let crossing = |inside: Vec3, outside: Vec3| {
            let crossing = inside.lerp(outside, (inside.z - self.near) / (inside.z - outside.z));
            Vec3::new(crossing.x, crossing.y, self.near)
        };
        match (from.z < self.near, to.z < self.near) {
            (true, true) => return None,
            (true, false) => from = crossing(to, from),
            (false, true) => to = crossing(from, to),
            (false, false) => {}
        }
        Some((self.project_turned(from)?, self.project_turned(to)?))
    }

    /// A world direction as (right, up, forward).
    fn turned(&self, direction: Vec3) -> Vec3 {
        Vec3::new(direction.dot(self.right), direction.dot(self.up), direction.dot(self.forward))
    }

    fn project_turned(&self, seen: Vec3) -> Option<Spot> {
        let nearness = 1.0 / seen.z;
        let x = self.centre.x + seen.x * nearness * self.focal;
        let y = self.centre.y - seen.y * nearness * self.focal;
        let visible = seen.z >= self.near && x.is_finite() && y.is_finite() && nearness > 0.0;
        visible.then_some(Spot { x, y, nearness })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SIZE: (usize, usize) = (640, 360);

    fn any_camera() -> impl Strategy<Value = Camera> {
        let number = -100.0f32..100.0;
        (number.clone(), number.clone(), number, 0.0f32..6.0, -1.5f32..1.5, 0.5f32..500.0).prop_map(
            |(x, y, z, azimuth, elevation, distance)| Camera {
                target: Vec3::new(x, y, z),
                azimuth,
                elevation,
                distance,
            },
        )
    }

    #[test]
    fn the_target_is_in_the_middle_and_x_goes_right_and_y_goes_up() {
        let camera = Camera { target: Vec3::ZERO, azimuth: 0.0, elevation: 0.0, distance: 10.0 };
        let view = camera.view(SIZE);
        let middle = view.project(Vec3::ZERO).unwrap();
        assert_eq!((middle.x, middle.y), (320.0, 180.0));
        assert!((middle.nearness - 0.1).abs() < 1e-6);
        assert!(view.project(Vec3::X).unwrap().x > 321.0);
        assert!(view.project(Vec3::Y).unwrap().y < 179.0);
        assert!(view.project(Vec3::Z).unwrap().nearness > middle.nearness, "+Z is nearer");
        assert_eq!(view.project(Vec3::Z * 11.0), None, "behind the camera");
    }

    #[test]
    fn panning_moves_the_target_by_so_many_pixels() {
        let mut camera = Camera { target: Vec3::ONE, azimuth: 0.8, elevation: 0.4, distance: 7.0 };
        camera.pan(30.0, -12.0, SIZE);
        let spot = camera.view(SIZE).project(Vec3::ONE).unwrap();
        assert!((spot.x - 350.0).abs() < 0.01 && (spot.y - 168.0).abs() < 0.01, "{spot:?}");
        let before = camera;
        camera.pan(f32::NAN, f32::INFINITY, SIZE);
        camera.zoom(f32::NAN);
        camera.zoom(f32::INFINITY);
        camera.orbit(f32::NAN, 1.0);
        camera.orbit(1.0, f32::INFINITY);
        assert_eq!(camera, before);
    }

    #[test]
    fn framing_works_in_any_unit() {
        for unit in [1e-20f32, 1e-7, 1.0, 1e12, 1e20] {
            let mut camera = Camera { target: Vec3::ZERO, azimuth: 0.0, elevation: 0.0, distance: 1.0 };
            camera.frame(&[Vec3::ZERO, Vec3::Y * unit], SIZE, 0.1, 0.5 * unit);
            let view = camera.view(SIZE);
            let (low, high) = (view.project(Vec3::ZERO).unwrap(), view.project(Vec3::Y * unit).unwrap());
            assert!((low.y - 324.0).abs() < 0.1 && (high.y - 36.0).abs() < 0.1, "{unit}: {low:?} {high:?}");
            camera.zoom(0.5);
            assert!((camera.view(SIZE).eye.z / view.eye.z - 0.5).abs() < 1e-3);
        }
    }

    #[test]
    fn framing_no_point_changes_nothing() {
        let before = Camera { target: Vec3::X, azimuth: 1.0, elevation: 0.5, distance: 3.0 };
        let mut camera = before;
        camera.frame(&[], SIZE, 0.1, 1.0);
        camera.frame(&[Vec3::NAN], SIZE, 0.1, 1.0);
        assert_eq!(camera, before);
    }

    proptest! {
        #[test]
        fn framing_shows_every_point_and_no_more_room_than_needed(
            mut camera in any_camera(),
            points in prop::collection::vec((-1e4f32..1e4, -1e4f32..1e4, -1e4f32..1e4).prop_map(Vec3::from), 2..40),
            width in 100usize..2000,
            height in 100usize..2000,
        ) {
            let size = (width, height);
            camera.frame(&points, size, 0.1, 0.001);
            let view = camera.view(size);
            let mut closest_to_border = f32::INFINITY;
            for &point in &points {
                let spot = view.project(point).expect("in front of the camera");
                for (at, length) in [(spot.x, width as f32), (spot.y, height as f32)] {
                    let free = at.min(length - at) / length;
                    prop_assert!(free > 0.098, "{free} of the side is free");
                    closest_to_border = closest_to_border.min(free);
                }
            }
            let nearness = points.iter().filter_map(|&point| view.project(point)).map(|spot| spot.nearness);
            let at_the_camera = nearness.fold(0.0, f32::max) * camera.distance > 9.0;
            prop_assert!(closest_to_border < 0.102 || at_the_camera, "{closest_to_border} of the side is free");
        }

        #[test]
        fn a_line_that_crosses_the_camera_ends_at_the_near_plane(
            camera in any_camera(),
            aside in (-5.0f32..5.0, -5.0f32..5.0),
        ) {
            let view = camera.view(SIZE);
            let front = view.eye + view.forward * camera.distance + view.right * aside.0 + view.up * aside.1;
            let behind = view.eye - view.forward * camera.distance;
            let (a, b) = view.project_line(front, behind).expect("half of it is in front");
            prop_assert!(a.nearness > 0.0 && (b.nearness * view.near - 1.0).abs() < 1e-3);
            let (b, a) = view.project_line(behind, front).expect("the same from the other end");
            prop_assert!(a.nearness > 0.0 && (b.nearness * view.near - 1.0).abs() < 1e-3);
        }

        #[test]
        fn whatever_the_numbers_a_spot_is_made_of_numbers(camera in any_camera(), raw in any::<[f32; 6]>()) {
            let view = camera.view(SIZE);
            let (a, b) = (Vec3::new(raw[0], raw[1], raw[2]), Vec3::new(raw[3], raw[4], raw[5]));
            let spots = view.project(a).into_iter().chain(view.project_line(a, b).into_iter().flat_map(|(a, b)| [a, b]));
            for spot in spots {
                prop_assert!(spot.x.is_finite() && spot.y.is_finite() && spot.nearness.is_finite());
            }
        }
    }
}
