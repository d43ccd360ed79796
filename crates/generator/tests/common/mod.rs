//! A motion as the tests look at it: every joint's path, by the matrices of the expected values.
#![allow(dead_code)] // Each test file uses some of it.

pub mod bones;

use generator::global_transforms;
use glam::{DMat3, DVec3};
use skeleton::{Channel, Joint, Motion, PositionChannels};

pub struct Paths {
    pub motion: Motion,
    rotations: Vec<Vec<DMat3>>,
    positions: Vec<Vec<DVec3>>,
}

impl Paths {
    pub fn new(motion: Motion) -> Paths {
        let mut paths = Paths { motion, rotations: Vec::new(), positions: Vec::new() };
        for frame in paths.frames() {
            let (rotations, positions) = global_transforms(&paths.motion, frame, PositionChannels::Replace);
            let matrix = |rows: &[[f64; 3]; 3]| DMat3::from_cols_array_2d(rows).transpose();
            paths.rotations.push(rotations.iter().map(matrix).collect());
            paths.positions.push(positions.into_iter().map(DVec3::from_array).collect());
        }
        paths
    }

    pub fn frames(&self) -> std::ops::Range<usize> {
        0..self.motion.frame_count()
    }

    pub fn frame_time(&self) -> f64 {
        self.motion.frame_time()
    }

    fn joint(&self, name: &str) -> &Joint {
        self.motion.skeleton().joints().iter().find(|joint| joint.name == name).expect(name)
    }

    /// Where a joint is in every frame.
    pub fn path(&self, name: &str) -> Vec<DVec3> {
        let id = self.joint(name).id;
        self.positions.iter().map(|frame| frame[id.0]).collect()
    }

    /// Where a point fixed to a joint is in every frame.
    pub fn path_of(&self, name: &str, local: DVec3) -> Vec<DVec3> {
        let id = self.joint(name).id;
        self.frames().map(|frame| self.positions[frame][id.0] + self.rotations[frame][id.0] * local).collect()
    }

    /// A joint's own axis in every frame.
    pub fn direction(&self, name: &str, axis: DVec3) -> Vec<DVec3> {
        let id = self.joint(name).id;
        self.rotations.iter().map(|frame| frame[id.0] * axis).collect()
    }

    /// The stored values of one channel.
    pub fn channel(&self, name: &str, channel: Channel) -> Vec<f64> {
        let joints = self.motion.skeleton().joints();
        let before: usize = joints[..self.joint(name).id.0].iter().map(|joint| joint.channels.len()).sum();
        let within = self.joint(name).channels.iter().position(|own| *own == channel).expect("the channel");
        self.frames()
            .map(|frame| f64::from(self.motion.row(frame).expect("a row")[before + within]))
            .collect()
    }

    /// For every foot and frame the height of the lowest point of the sole, in cm: heel, ball or tip of the toes.
    pub fn sole_heights(&self, side: &str) -> Vec<f64> {
        // The humanoid's sole is 6.8 below the ankle, 2 below the ball and 0.8 below the tip of the toes.
        let heel = self.path_of(&format!("{side}Foot"), DVec3::new(0.0, -6.8, -6.0));
        let ball = self.path(&format!("{side}ToeBase"));
        let tip = self.path_of(&format!("{side}ToeBase"), DVec3::new(0.0, -1.2, 7.4));
        self.frames().map(|f| heel[f].y.min(ball[f].y - 2.0).min(tip[f].y - 0.8)).collect()
    }
}

/// The runs of frames for which `holds` is true: (first, one behind the last).
pub fn spans(holds: &[bool]) -> Vec<(usize, usize)> {
    let mut spans = Vec::new();
    let mut start = None;
    for (frame, &now) in holds.iter().chain([&false]).enumerate() {
        match (now, start) {
            (true, None) => start = Some(frame),
            (false, Some(first)) => {
                spans.push((first, frame));
                start = None;
            }
            _ => {}
        }
    }
    spans
}

pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

pub fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / values.len() as f64).sqrt()
}

pub fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let (mean_a, mean_b) = (mean(a), mean(b));
    let product: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - mean_a) * (b - mean_b)).collect();
    mean(&product) / (deviation(a) * deviation(b))
}

pub fn highest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

pub fn lowest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The differences from each value to the next.
pub fn differences(values: &[f64]) -> Vec<f64> {
    values.windows(2).map(|pair| pair[1] - pair[0]).collect()
}
