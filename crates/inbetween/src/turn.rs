//! How one joint is turned, between two others of its rotations.

use glam::Quat;
use skeleton::{Axis, RotationOrder};

/// The rotation that three angles in degrees make.
pub(crate) fn quaternion(order: RotationOrder, angles: [f32; 3]) -> Quat {
    let Some([first, second, third]) = order.axes() else { return Quat::IDENTITY };
    let turn = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    turn(first, angles[0]) * turn(second, angles[1]) * turn(third, angles[2])
}

/// The same difference of two angles in degrees, from −180 to 180.
pub(crate) fn shorter_way(degrees: f32) -> f32 {
    let degrees = degrees % 360.0;
    if degrees > 180.0 {
        degrees - 360.0
    } else if degrees < -180.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

/// From three angles to three others, each the shorter way round.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Angles {
    order: RotationOrder,
    from: [f32; 3],
    way: [f32; 3],
}

impl Angles {
    pub(crate) fn new(order: RotationOrder, from: [f32; 3], to: [f32; 3]) -> Angles {
        Angles { order, from, way: std::array::from_fn(|axis| shorter_way(to[axis] - from[axis])) }
    }

    pub(crate) fn at(&self, t: f32) -> Quat {
        quaternion(self.order, std::array::from_fn(|axis| self.from[axis] + t * self.way[axis]))
    }
}

/// From one rotation to another, about one axis, the shorter way round.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    from: Quat,
    to: Quat,
    /// The angle between the two as vectors, in radians, and its sine; `None` where a straight line is as good.
    angle: Option<(f32, f32)>,
}

impl Arc {
    pub(crate) fn new(from: Quat, to: Quat) -> Arc {
        let dot = from.dot(to);
        let (to, cosine) = if dot < 0.0 { (-to, -dot) } else { (to, dot) };
        let angle = (cosine <= 0.9995).then(|| cosine.acos());
        Arc { from, to, angle: angle.map(|angle| (angle, angle.sin())) }
    }

    pub(crate) fn at(&self, t: f32) -> Quat {
        let (first, second) = match self.angle {
            None => (1.0 - t, t),
            Some((angle, sine)) => (((1.0 - t) * angle).sin() / sine, (t * angle).sin() / sine),
        };
        (self.from * first + self.to * second).normalize()
    }
}
