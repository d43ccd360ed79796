//! Which way is up in a motion.

use clap::ValueEnum;
use glam::{Quat, Vec3};
use skeleton::{Joint, Pose};

/// The axis of a motion that points up. The viewer shows it upright; numbers that it prints stay the file's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Up {
    /// X points up.
    X,
    /// Y points up: what most files mean.
    #[default]
    Y,
    /// Z points up.
    Z,
}

impl Up {
    /// The rotation from the motion's world to one in which Y points up. It turns right-handed axes into right-handed
    /// ones.
    pub fn rotation(self) -> Quat {
        const QUARTER: f32 = std::f32::consts::FRAC_PI_2;
        match self {
            Up::X => Quat::from_rotation_z(QUARTER),
            Up::Y => Quat::IDENTITY,
            Up::Z => Quat::from_rotation_x(-QUARTER),
        }
    }
}

/// How much more a figure must rise along an axis than along the others for that axis to be up.
const CLEARLY: f32 = 1.5;

/// Finds out which way is up: from the feet to the root and to the head, over many poses. Where no joint is called a foot,
/// or the figure does not clearly stand, it is Y.
pub struct Stance {
    feet: Vec<usize>,
    tops: Vec<usize>,
    sum: Vec3,
}

impl Stance {
    /// For a skeleton with these joints.
    pub fn new(joints: &[Joint]) -> Stance {
        let named = |words: &'static [&'static str]| {
            let fits = move |joint: &&Joint| {
                let name = joint.name.to_lowercase();
                words.iter().any(|word| name.contains(word))
            };
            joints.iter().filter(fits).map(|joint| joint.id.0).collect::<Vec<_>>()
        };
        let mut tops = named(&["head"]);
        tops.truncate(1);
        tops.extend(joints.first().map(|root| root.id.0));
        Stance { feet: named(&["foot", "toe", "ankle"]), tops, sum: Vec3::ZERO }
    }

    /// Looks at a pose of that skeleton.
    pub fn look(&mut self, pose: &Pose) {
        let place = |joint: &usize| pose.transforms()[*joint].position;
        let feet: Vec3 = self.feet.iter().map(place).sum::<Vec3>() / self.feet.len().max(1) as f32;
        let rise = self.tops.iter().map(|top| place(top) - feet).sum::<Vec3>().normalize_or_zero();
        if rise.is_finite() && !self.feet.is_empty() {
            self.sum += rise;
        }
    }

    /// What has been found.
    pub fn up(&self) -> Up {
        let Vec3 { x, y, z } = self.sum;
        let clearly = |axis: f32, a: f32, b: f32| axis > CLEARLY * a.abs() && axis > CLEARLY * b.abs();
        match () {
            () if clearly(z, x, y) => Up::Z,
            () if clearly(x, y, z) => Up::X,
            () => Up::Y,
        }
    }
}

#[cfg(test)]
mod tests {
    use skeleton::Skeleton;

    use super::*;

    #[test]
    fn the_axis_that_is_up_becomes_y() {
        for (up, axis) in [(Up::X, Vec3::X), (Up::Y, Vec3::Y), (Up::Z, Vec3::Z)] {
            assert!((up.rotation() * axis).abs_diff_eq(Vec3::Y, 1e-6), "{up:?}");
        }
    }

    fn found(names: [&str; 2], from_foot_to_head: Vec3) -> Up {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, names[0], from_foot_to_head, []).unwrap();
        skeleton.add_joint(Some(root), names[1], -from_foot_to_head, []).unwrap();
        let places = skeleton.rest_positions();
        let transform = |position| skeleton::Transform { position, ..skeleton::Transform::IDENTITY };
        let mut stance = Stance::new(skeleton.joints());
        stance.look(&Pose::from(places.into_iter().map(transform).collect::<Vec<_>>()));
        stance.up()
    }

    #[test]
    fn a_figure_that_stands_tells_what_is_up() {
        let names = ["Head", "LeftFoot"];
        assert_eq!(found(names, Vec3::new(0.1, 0.0, 1.7)), Up::Z);
        assert_eq!(found(names, Vec3::new(0.1, 1.7, 0.2)), Up::Y);
        assert_eq!(found(names, Vec3::new(1.7, 0.1, 0.2)), Up::X);
        assert_eq!(found(names, Vec3::new(0.0, 1.0, 1.1)), Up::Y, "leaning is not clear enough");
        assert_eq!(found(names, Vec3::NAN), Up::Y);
        assert_eq!(found(["a", "b"], Vec3::new(0.1, 0.0, 1.7)), Up::Y, "nothing is known of these joints");
    }
}
