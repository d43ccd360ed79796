//! The pelvis of the walker: its way, its height over the ground, its sway and its turns.

use glam::{DMat3, DVec3};
use skeleton::Axis;

use crate::humanoid::{LEFT_HIP, Side};
use crate::math::{cos, from_euler, wobble};

/// Strides per second: 112 steps a minute.
const CADENCE: f64 = 112.0 / 120.0;
/// The way of one stride, in cm: at this cadence 1.24 m/s.
const STRIDE: f64 = 133.0;
/// The height of the hip joints halfway between its highest and its lowest, in cm.
const HEIGHT: f64 = 89.95;

/// Where the pelvis is.
#[derive(Clone, Copy, Debug)]
pub struct Pelvis {
    /// The global position of the root, in cm.
    pub position: DVec3,
    /// The global rotation.
    pub rotation: DMat3,
    /// Strides since time 0: the left foot strikes at whole numbers, the right one halfway between.
    pub phase: f64,
}

/// Strides since time 0. They differ by about 1 %.
pub fn phase(time: f64) -> f64 {
    CADENCE * time + 0.005 * wobble(40, time)
}

/// When the phase is `phase`, in seconds.
pub fn time_of(phase: f64) -> f64 {
    // What wobbles is so small that each round gives two digits more.
    (0..12).fold(phase / CADENCE, |time, _| (phase - 0.005 * wobble(40, time)) / CADENCE)
}

/// How far the body has come along +Z, in cm.
pub fn way(phase: f64) -> f64 {
    STRIDE * phase
}

impl Pelvis {
    /// The pelvis at `time`, in seconds.
    ///
    /// It turns forward on the side of the leg that is in front, and sinks on the side whose leg leaves the ground; it is
    /// lowest while both feet stand and highest over the standing leg, towards which it sways (Murray, Drought and Kory
    /// 1964, "Walking patterns of normal men"; Stokes, Andersson and Forssberg 1989, "Rotational and translational movement
    /// features of the pelvis and thorax during adult human locomotion").
    pub fn at(time: f64) -> Pelvis {
        let phase = phase(time);
        let wave = |amplitude: f64, peak: f64| amplitude * cos(360.0 * (phase - peak));
        let double_wave = |amplitude: f64, peak: f64| amplitude * cos(720.0 * (phase - peak));
        // The left side forward is a turn to the right, negative about Y; the left side up is positive about Z.
        let turn = -wave(4.5, 0.0) + 0.3 * wobble(41, time);
        let list = wave(3.2, 0.17) + 0.2 * wobble(42, time);
        let tilt = 3.0 + double_wave(0.8, 0.0);
        let rotation = from_euler([Axis::Y, Axis::X, Axis::Z], [turn, tilt, list]);
        let sway = wave(2.0, 0.29) + 0.4 * wobble(43, time);
        let height = HEIGHT + double_wave(1.45, 0.275) + 0.1 * wobble(44, time);
        let hips = DVec3::new(sway, height, way(phase) + double_wave(0.7, 0.12));
        Pelvis { position: hips - rotation * DVec3::new(0.0, LEFT_HIP.y, 0.0), rotation, phase }
    }

    /// The global position of a hip joint, in cm.
    pub fn hip(&self, side: Side) -> DVec3 {
        self.position + self.rotation * side.mirror(LEFT_HIP)
    }
}
