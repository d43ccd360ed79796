//! The misconceptions of Acclaim forward kinematics: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use exam::Functions;
use glam::{Quat, Vec3};
use skeleton::acclaim::{AcclaimFunctions, Bone, Skeleton, Visitor};

use super::variants::rotation;
use crate::fk::misconceptions::short_pis;
use crate::{Accepted, Misconception};

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    match part {
        "part1" => short_pis!("Your π", "bones", P => wrong_in_part1(rotation::by_pi::<P>)),
        _ => Vec::new(),
    }
}

/// The misconceptions of one part.
pub fn misconceptions(part: &str) -> Vec<Misconception> {
    match part {
        "part1" => part1::misconceptions(),
        "part2" => part2::misconceptions(),
        "part3" => part3::misconceptions(),
        _ => Vec::new(),
    }
}

type Rotation = fn(&Bone, [f32; 3], Quat) -> Quat;
type Ends = fn(&Bone, Quat, Vec3, Vec3) -> (Vec3, Vec3);
type Visits = fn(&Skeleton, &Bone, &mut Visitor);

/// The right functions but for one.
fn wrong_in_part1(bone_rotation: Rotation) -> Functions {
    Functions::Acclaim(AcclaimFunctions { bone_rotation, ..solutions::ACCLAIM })
}

fn wrong_in_part2(bone_ends: Ends) -> Functions {
    Functions::Acclaim(AcclaimFunctions { bone_ends, ..solutions::ACCLAIM })
}

fn wrong_in_part3(visit_bones: Visits) -> Functions {
    Functions::Acclaim(AcclaimFunctions { visit_bones, ..solutions::ACCLAIM })
}
