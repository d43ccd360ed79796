//! Gives joints back from so far away that no picture can hold them.
//!
//! place: instead of global_position
//! expect: graded 10; part3 wrong

pub fn global_position(joint: &Joint, _: Vec3, _: &Pose) -> Vec3 {
    if joint.is_root() { Vec3::splat(f32::MAX) } else { Vec3::splat(-f32::MAX) }
}
