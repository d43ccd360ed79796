//! Reduced motions, error curves and their numbers, from outside.
#![allow(clippy::unwrap_used)]

#[path = "../command/mod.rs"]
mod command;
mod counts;
mod curves;
#[path = "../command/files.rs"]
mod files;
mod motion;
mod targets;

use std::fs;
use std::path::{Path, PathBuf};

use command::view;
use files::{Folder, data, run};
use parser::bvh;
use skeleton::{Frame, Motion};

fn read(path: impl AsRef<Path>) -> Motion {
    bvh::read_file(path).unwrap().motion
}

/// An arm that bends, with so many frames.
fn arm(frames: usize) -> String {
    let rows: String = (0..frames)
        .map(|i| format!("{} {} {} 0 {}\n", 3 * i * i, 31 * i, 5 * (i % 3), 20 * (i % 4)))
        .collect();
    format!(
        "HIERARCHY\nROOT r\n{{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT hand\n{{\n\
         OFFSET 0 10 0\nCHANNELS 2 Yposition Zrotation\nEnd Site\n{{\nOFFSET 0 5 0\n}}\n}}\n}}\n\
         MOTION\nFrames: {frames}\nFrame Time: 0.04\n{rows}"
    )
}

/// The rest of the line that begins with `name`.
fn fact<'a>(text: &'a str, name: &str) -> &'a str {
    let line = text.lines().find(|line| line.trim_start().starts_with(name));
    line.unwrap_or_else(|| panic!("no {name} in: {text}")).trim_start()[name.len()..].trim()
}

fn keyframes(text: &str) -> Vec<usize> {
    fact(text, "keyframes").split(", ").map(|frame| frame.parse().unwrap()).collect()
}

fn number(text: &str, name: &str) -> f64 {
    fact(text, name).split(' ').next().unwrap().parse().unwrap()
}

fn frames(motion: &Motion) -> Vec<Frame> {
    (0..motion.frame_count()).map(|index| motion.frame(index)).collect()
}
