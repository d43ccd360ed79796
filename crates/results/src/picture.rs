//! One pose, as lines between points.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// One pose of a skeleton.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Where each joint is, in the motion's unit; X to the right, Y up, Z towards the reader. A student's may be anywhere, and
    /// no number at all: such a coordinate is `null` in JSON, and NaN again when it is read.
    #[serde(with = "numbers_or_null")]
    pub points: Vec<[f32; 3]>,
    /// The bones, each from one point's index to another's.
    pub bones: Vec<(u16, u16)>,
}

/// JSON has no NaN and no infinity.
mod numbers_or_null {
    use super::*;

    pub fn serialize<S: Serializer>(points: &[[f32; 3]], serializer: S) -> Result<S::Ok, S::Error> {
        let finite = |point: &[f32; 3]| point.map(|value| value.is_finite().then_some(value));
        serializer.collect_seq(points.iter().map(finite))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<[f32; 3]>, D::Error> {
        let points = Vec::<[Option<f32>; 3]>::deserialize(deserializer)?;
        Ok(points.into_iter().map(|point| point.map(|value| value.unwrap_or(f32::NAN))).collect())
    }
}
