//! Known-wrong variants of the three functions, one misconception each.

pub(super) mod blend;
pub(super) mod place;
pub(super) mod warp;

use exam::Functions;
use glam::{EulerRot, Quat, Vec3};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

/// The functions of the untouched template.
pub const TEMPLATE: TimeWarpFunctions = TimeWarpFunctions {
    old_position: |new_frame, _, _| Between { before: new_frame, after: new_frame, t: 0.0 },
    blend: |from, _, _| from.clone(),
    warp: |postures, _| postures.to_vec(),
};

/// Somebody's way through the exercise. What it says nothing about is right; part 3 calls its own parts 1 and 2.
pub(super) trait Way {
    /// Part 1.
    fn place(new_frame: usize, old_count: usize, new_count: usize) -> Between {
        solutions::time_warp::old_position(new_frame, old_count, new_count)
    }

    /// What becomes of `t` before anything is blended.
    fn time(t: f32) -> f32 {
        t
    }

    /// What slerp is given for a bone's angles.
    fn quaternion(angles: [f32; 3]) -> Quat {
        quaternion(angles)
    }

    /// Between the two.
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        from.slerp(to, t)
    }

    /// The angles that are made of what slerp gives.
    fn angles(rotation: Quat) -> [f32; 3] {
        angles(rotation)
    }

    /// The angles of a bone between two postures.
    fn blend_angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        Self::angles(Self::slerp(Self::quaternion(from), Self::quaternion(to), t))
    }

    /// The translation of the bone of this number.
    fn translation(_bone: usize, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        from.lerp(to, t)
    }

    /// Part 2.
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        let angles = from.angles.iter().zip(&to.angles);
        let translations = from.translations.iter().zip(&to.translations).enumerate();
        Posture {
            angles: angles.map(|(from, to)| Self::blend_angles(*from, *to, Self::time(t))).collect(),
            translations: translations
                .map(|(bone, (from, to))| Self::translation(bone, *from, *to, t))
                .collect(),
        }
    }

    /// Part 3. Where part 1 names frames that are not there, a student's part 3 panics. So that part 1 can be looked at by
    /// itself, this one is right then.
    fn warp(postures: &[Posture], new_count: usize) -> Vec<Posture> {
        let frame = |frame| {
            let Between { before, after, t } = Self::place(frame, postures.len(), new_count);
            Some(Self::blend(postures.get(before)?, postures.get(after)?, t))
        };
        if postures.is_empty() {
            return Vec::new();
        }
        let warped: Option<Vec<Posture>> = (0..new_count).map(frame).collect();
        warped.unwrap_or_else(|| solutions::time_warp::warp(postures, new_count))
    }
}

/// All three functions of one who goes this way.
pub(super) fn functions<W: Way>() -> Functions {
    Functions::TimeWarp(TimeWarpFunctions { old_position: W::place, blend: W::blend, warp: W::warp })
}

/// One frame of the warped motion, as it should be. There must be an old one.
fn right_frame(postures: &[Posture], frame: usize, new_count: usize) -> Posture {
    let Between { before, after, t } = solutions::time_warp::old_position(frame, postures.len(), new_count);
    solutions::time_warp::blend(&postures[before], &postures[after], t)
}

/// The rotation that angles about X, Y and Z (degrees) stand for.
pub(super) fn quaternion([x, y, z]: [f32; 3]) -> Quat {
    Quat::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians())
}

/// The angles about X, Y and Z (degrees) that stand for a rotation.
fn angles(rotation: Quat) -> [f32; 3] {
    let (z, y, x) = rotation.to_euler(EulerRot::ZYX);
    [x, y, z].map(f32::to_degrees)
}
