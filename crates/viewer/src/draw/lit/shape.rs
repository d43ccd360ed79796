//! A capsule in the picture: which pixels it may touch, and where the rays through them meet it.

use std::ops::Range;

use glam::Vec3;

use super::capsule::Capsule;
use crate::camera::View;

/// A capsule as the camera sees it. The axis is measured from its point that is nearest to the eye: from there
/// everything stays exact, however far away its ends are.
pub(super) struct Body<'a> {
    pub capsule: &'a Capsule,
    /// From the nearest point of the whole axis to the eye; at a right angle to the axis.
    pub to_eye: Vec3,
    /// Where the capsule starts and ends on its axis.
    pub start: f32,
    pub end: f32,
    /// Where it starts when nothing is cut off.
    pub own_start: f32,
    /// From its ends to the eye.
    from_start: Vec3,
    from_end: Vec3,
    /// The boxes around its two end balls in the picture.
    boxes: [Box; 2],
}

/// Left, top, right and bottom in pixels.
#[derive(Clone, Copy)]
struct Box {
    low: [f32; 2],
    high: [f32; 2],
}

impl<'a> Body<'a> {
    /// `None` when no part of the capsule is in front of the camera.
    pub fn new(capsule: &'a Capsule, lens: &View) -> Option<Body<'a>> {
        let seen = |point: Vec3| {
            let away = point - lens.eye;
            Vec3::new(away.dot(lens.right), away.dot(lens.up), away.dot(lens.forward))
        };
        let on_axis = (lens.eye - capsule.from).dot(capsule.axis);
        let (mut start, mut end) = (-on_axis, capsule.length - on_axis);
        let (mut from, mut to) = (seen(capsule.from), seen(capsule.to));
        // The camera never gets into a body: one that reaches into it is cut off in front of it.
        let limit = capsule.radius + lens.near;
        if from.z.max(to.z) < limit {
            return None;
        }
        if from.z < limit {
            let share = (limit - from.z) / (to.z - from.z);
            (from, start) = (from.lerp(to, share), start + share * (end - start));
        } else if to.z < limit {
            let share = (limit - to.z) / (from.z - to.z);
            (to, end) = (to.lerp(from, share), end + share * (start - end));
        }
        let to_eye = lens.eye - (capsule.from + capsule.axis * on_axis);
        Some(Body {
            capsule,
            to_eye,
            start,
            end,
            own_start: -on_axis,
            from_start: to_eye - capsule.axis * start,
            from_end: to_eye - capsule.axis * end,
            boxes: [from, to].map(|centre| Box::around(centre, capsule.radius, lens)),
        })
    }

    /// Whether it may touch a picture of this size.
    pub fn is_inside(&self, size: (usize, usize)) -> bool {
        let [a, b] = self.boxes;
        self.rows(size.1).is_some()
            && range(a.low[0].min(b.low[0]), a.high[0].max(b.high[0]), size.0).is_some()
    }

    /// The rows of the picture that it may touch.
    pub fn rows(&self, height: usize) -> Option<Range<usize>> {
        let [a, b] = self.boxes;
        range(a.low[1].min(b.low[1]), a.high[1].max(b.high[1]), height)
    }

    /// The pixels of the row through `y` that it may touch. Its outline lies within all boxes between those around
    /// its ends.
    pub fn columns(&self, y: f32, width: usize) -> Option<Range<usize>> {
        let [a, b] = self.boxes;
        let (mut first, mut last) = (0.0f32, 1.0f32);
        // The upper side of the box must be above the row, the lower side below it.
        for (start, end) in [(a.low[1] - y, b.low[1] - y), (y - a.high[1], y - b.high[1])] {
            let crossing = start / (start - end);
            match (start > 0.0, end > 0.0) {
                (true, true) => return None,
                (true, false) => first = first.max(crossing),
                (false, true) => last = last.min(crossing),
                (false, false) => {}
            }
        }
        let at = |share: f32, a: f32, b: f32| a + share * (b - a);
        let low = at(first, a.low[0], b.low[0]).min(at(last, a.low[0], b.low[0]));
        let high = at(first, a.high[0], b.high[0]).max(at(last, a.high[0], b.high[0]));
        range(low, high, width)
    }
}

/// The pixels between two places.
fn range(low: f32, high: f32, length: usize) -> Option<Range<usize>> {
    let first = (low.floor().max(0.0) as usize).min(length);
    let last = (high.ceil().max(0.0) as usize).min(length);
    (first < last).then_some(first..last)
}

impl Box {
    /// Around a ball whose centre is at this place seen from the camera (right, up, forward).
    fn around(centre: Vec3, radius: f32, lens: &View) -> Box {
        // The slopes of the two lines of sight that touch the ball, in one direction across the picture.
        let touching = |aside: f32| {
            let away = (centre.z * centre.z - radius * radius).max(1e-12);
            let reach = radius * (aside * aside + away).sqrt();
            [(aside * centre.z - reach) / away, (aside * centre.z + reach) / away]
        };
        let [left, right] = touching(centre.x);
        let [bottom, top] = touching(centre.y);
        // One pixel more, for soft edges.
        let (x, y, focal) = (lens.centre.x, lens.centre.y, lens.focal);
        Box {
            low: [x + focal * left - 1.0, y - focal * top - 1.0],
            high: [x + focal * right + 1.0, y - focal * bottom + 1.0],
        }
    }
}

/// What is the same for all rays through a row of pixels. A ray's direction has a depth of 1, so that how far it goes
/// is a depth.
pub(super) struct Row {
    squared: f32,
    along: [f32; 2],
    to_eye: [f32; 2],
    from_start: [f32; 2],
    from_end: [f32; 2],
    /// By how much the squared distances of the eye exceed the squared radius.
    axis_excess: f32,
    start_excess: f32,
    end_excess: f32,
}

/// Where a ray meets a capsule.
#[derive(Clone, Copy)]
pub(super) struct Hit {
    pub depth: f32,
    /// How much of the pixel the capsule covers.
    pub share: f32,
    /// On the capsule's axis, from its point nearest to the eye.
    pub along: f32,
}

impl Row {
    pub fn new(body: &Body, sight: Vec3, right: Vec3) -> Row {
        let both = |vector: Vec3| [vector.dot(sight), vector.dot(right)];
        let radius_squared = body.capsule.radius * body.capsule.radius;
        let excess = |vector: Vec3| vector.length_squared() - radius_squared;
        Row {
            squared: sight.length_squared(),
            along: both(body.capsule.axis),
            to_eye: both(body.to_eye),
            from_start: both(body.from_start),
            from_end: both(body.from_end),
            axis_excess: excess(body.to_eye),
            start_excess: excess(body.from_start),
            end_excess: excess(body.from_end),
        }
    }

    /// Meets `body` with the ray that goes this far to the right.
    #[inline]
    pub fn meet(&self, body: &Body, aside: f32, per_pixel: f32) -> Option<Hit> {
        let squared = self.squared + aside * aside;
        let along = self.along[0] + self.along[1] * aside;
        let to_eye = self.to_eye[0] + self.to_eye[1] * aside;
        // The squared sine between ray and axis, times the ray's squared length.
        let apart = squared - along * along;
        let per_apart = 1.0 / apart;
        // Where the ray passes closest to the axis, how much closer than the radius that is (as a difference of
        // squares), and where the ray enters the endless cylinder around the axis.
        let closest = -to_eye * per_apart;
        let within = -to_eye * closest - self.axis_excess;
        let entry = closest - (within.max(0.0) * per_apart).sqrt();
        let (on_axis, entry_on_axis) = (closest * along, entry * along);
        let parallel = apart < 1e-6 * squared;
        let between = |at: f32| at >= body.start && at <= body.end && !parallel;

        // The soft edge belongs to the part that the ray passes closest to.
        let at_start = |at: f32| if parallel { along > 0.0 } else { at < body.start };
        let (passing, within) =
            if between(on_axis) { (closest, within) } else { self.ball(at_start(on_axis), aside, squared) };
        let share = share(within, body.capsule.radius, passing * per_pixel);
        if !(share > 0.0 && passing > 0.0) {
            return None;
        }
        let depth = if between(entry_on_axis) {
            entry
        } else {
            let (closest, within) = self.ball(at_start(entry_on_axis), aside, squared);
            if within > 0.0 { closest - (within / squared).sqrt() } else { passing }
        };
        (depth > 0.0).then_some(Hit { depth, share, along: depth * along })
    }

    /// Where a ray passes closest to the centre of one of the end balls, and how much closer than the radius that is,
    /// as a difference of squares.
    #[inline]
    fn ball(&self, at_start: bool, aside: f32, squared: f32) -> (f32, f32) {
        let (to_centre, excess) = match at_start {
            true => (self.from_start, self.start_excess),
            false => (self.from_end, self.end_excess),
        };
        let to_centre = to_centre[0] + to_centre[1] * aside;
        let closest = -to_centre / squared;
        (closest, -to_centre * closest - excess)
    }
}

/// The share of a pixel that is covered where a ray passes inside of a surface. `within` is the squared radius less the
/// squared distance from the axis, `pixel` the size of a pixel there.
#[inline]
fn share(within: f32, radius: f32, pixel: f32) -> f32 {
    if within >= radius * pixel && pixel < radius {
        return 1.0;
    }
    let distance = (radius * radius - within).max(0.0).sqrt();
    // What is thinner than a pixel never covers all of it.
    ((radius - distance) / pixel + 0.5).min(2.0 * radius / pixel).clamp(0.0, 1.0)
}
