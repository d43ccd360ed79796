//! Part 1.

use glam::Vec3;
use skeleton::{Joint, Pose, RotationOrder, Skeleton};

/// What someone takes for the joints that count.
pub trait Counted {
    fn counts(skeleton: &Skeleton, joint: &Joint) -> bool;
}

macro_rules! counted {
    ($($(#[$doc:meta])* $name:ident = $counts:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Counted for $name {
                fn counts(skeleton: &Skeleton, joint: &Joint) -> bool {
                    let counts: fn(&Skeleton, &Joint) -> bool = $counts;
                    counts(skeleton, joint)
                }
            }
        )*
    };
}

counted! {
    /// As it should be.
    Tips = |skeleton, joint| is_tip(skeleton, joint);
    /// Joints on which nothing hangs are forgotten.
    EndSites = |_, joint| joint.is_end_site;
    /// No distinction.
    All = |_, _| true;
    /// The condition the wrong way round.
    ButEndSites = |_, joint| !joint.is_end_site;
    /// As if every joint that carries others could turn.
    WithoutRotation = |_, joint| joint.rotation_order == RotationOrder::None;
}

/// Whether nothing hangs on the joint.
pub fn is_tip(skeleton: &Skeleton, joint: &Joint) -> bool {
    !skeleton.joints().iter().any(|other| other.parent == Some(joint.id))
}

/// By how much each joint that counts is off.
fn off<C: Counted>(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> impl Iterator<Item = Vec3> {
    let joints = skeleton.joints().iter().filter(|joint| C::counts(skeleton, joint));
    joints.map(|joint| interpolated[joint.id].position - original[joint.id].position)
}

fn squared(vector: Vec3) -> f64 {
    f64::from(vector.length_squared())
}

fn length(vector: Vec3) -> f64 {
    f64::from(vector.length())
}

pub fn sum<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    off::<C>(skeleton, a, b).map(squared).sum()
}

pub fn not_squared<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    off::<C>(skeleton, a, b).map(length).sum()
}

pub fn root_of_the_sum<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    sum::<C>(skeleton, a, b).sqrt()
}

pub fn squared_sum_of_distances(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    not_squared::<Tips>(skeleton, a, b).powi(2)
}

pub fn squared_sum_of_vectors(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    squared(off::<Tips>(skeleton, a, b).sum())
}

/// What counts is added up, and divided by how many joints count.
pub fn mean<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    sum::<C>(skeleton, a, b) / counted::<C>(skeleton)
}

pub fn mean_distance<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    not_squared::<C>(skeleton, a, b) / counted::<C>(skeleton)
}

pub fn root_of_the_mean<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    mean::<C>(skeleton, a, b).sqrt()
}

/// What counts is added up, and divided by the number of all joints.
pub fn mean_over_all<C: Counted>(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    sum::<C>(skeleton, a, b) / counted::<All>(skeleton)
}

/// A skeleton without such joints gives no division by zero: then the sum is 0 too.
fn counted<C: Counted>(skeleton: &Skeleton) -> f64 {
    skeleton.joints().iter().filter(|joint| C::counts(skeleton, joint)).count().max(1) as f64
}

pub fn largest(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    off::<Tips>(skeleton, a, b).map(squared).fold(0.0, f64::max)
}

pub fn first_tip(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    off::<Tips>(skeleton, a, b).next().map_or(0.0, squared)
}

pub fn last_tip(skeleton: &Skeleton, a: &Pose, b: &Pose) -> f64 {
    off::<Tips>(skeleton, a, b).last().map_or(0.0, squared)
}
