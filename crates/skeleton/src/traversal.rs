//! The fixed traversal: from a frame to a pose, joint by joint, parents first.

use glam::{Quat, Vec3};

use crate::{Frame, FrameCursor, Joint, Pose, Skeleton};

/// The three functions of the assignment.
#[derive(Clone, Copy, Debug)]
pub struct FkFunctions {
    /// Part 1: takes the joint's angles from the frame and makes its local rotation of them.
    pub local_quaternion: fn(&Joint, &mut FrameCursor) -> Quat,
    /// Part 2: the joint's global rotation, from its local one and its parent's global one.
    pub global_quaternion: fn(&Joint, Quat, &Pose) -> Quat,
    /// Part 3: the joint's global position, from its local one and its parent's global transform.
    pub global_position: fn(&Joint, Vec3, &Pose) -> Vec3,
}

/// Whether the functions took just as many angles as the frame holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leftover {
    /// Angles taken over the whole frame.
    pub taken: usize,
    /// Angles that the frame holds.
    pub available: usize,
}

/// Calls the three functions for every joint and End Site of `skeleton`, parents first, and fills `pose`.
///
/// While a joint is visited, `pose` holds the global transforms of all joints before it; when part 3 is asked, the
/// joint's own global rotation is there too. What has not been visited yet is not turned and at the origin.
///
/// # Panics
///
/// Only if one of the functions does.
pub fn pose_frame(skeleton: &Skeleton, frame: &Frame, functions: &FkFunctions, pose: &mut Pose) -> Leftover {
    pose.reset(skeleton.len());
    let mut cursor = FrameCursor::new(&frame.angles);
    for (joint, &local_position) in skeleton.joints().iter().zip(&frame.local_positions) {
        let local = (functions.local_quaternion)(joint, &mut cursor);
        pose[joint.id].rotation = (functions.global_quaternion)(joint, local, pose);
        pose[joint.id].position = (functions.global_position)(joint, local_position, pose);
    }
    Leftover { taken: cursor.taken(), available: frame.angles.len() }
}
