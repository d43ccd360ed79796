//! The misconceptions of forward kinematics: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use exam::Functions;
use glam::{Quat, Vec3};
use skeleton::{FkFunctions, FrameCursor, Joint, Pose};

use super::variants::local;
use crate::{Accepted, Misconception};

/// Ways to answer a part that are right but for a π of few digits: they get full points, with a remark. `$pi` names the π in
/// the functions. In the usual remark `$whose` does, and over several `$things` the error grows.
macro_rules! short_pis {
    ($whose:literal, $things:literal, $pi:ident => $functions:expr) => {
        $crate::fk::misconceptions::short_pis!(
            concat!(
                $whose, " has only a few digits. This is accepted, but over several ", $things,
                " the error becomes visible. `f32::to_radians` is as exact as the type allows."
            ),
            $pi => $functions
        )
    };
    ($remark:expr, $pi:ident => $functions:expr) => {
        $crate::fk::misconceptions::short_pis!(
            $remark, $pi => $functions;
            TwoDecimals, ThreeDecimals, ThreeRounded, FourDecimals, Fraction
        )
    };
    ($remark:expr, $pi:ident => $functions:expr; $($digits:ident),*) => {
        vec![$({
            type $pi = $crate::fk::variants::$digits;
            $crate::Accepted { remark: $remark, functions: $functions }
        }),*]
    };
}
pub(crate) use short_pis;

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    match part {
        "part1" => short_pis!("Your π", "joints", P => wrong_in_part1(local::right::<P>)),
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

type Local = fn(&Joint, &mut FrameCursor) -> Quat;
type Rotation = fn(&Joint, Quat, &Pose) -> Quat;
type Position = fn(&Joint, Vec3, &Pose) -> Vec3;

/// The right functions but for one.
fn wrong_in_part1(local_quaternion: Local) -> Functions {
    Functions::Fk(FkFunctions { local_quaternion, ..solutions::FK })
}

fn wrong_in_part2(global_quaternion: Rotation) -> Functions {
    Functions::Fk(FkFunctions { global_quaternion, ..solutions::FK })
}

fn wrong_in_part3(global_position: Position) -> Functions {
    Functions::Fk(FkFunctions { global_position, ..solutions::FK })
}
