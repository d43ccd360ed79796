//! Motions, and the keyframes that stay when nothing is remembered from one removal to the next.
#![allow(dead_code, clippy::unwrap_used)] // Every test file uses its own part of this.

use std::ops::ControlFlow;

use glam::Vec3;
use proptest::collection::vec;
use proptest::prelude::*;
use reduction::Errors;
use skeleton::{Axis, Channel, Frame, Motion, Representation, Skeleton};

/// A skeleton and frames of it.
pub type Frames = (Skeleton, Vec<Frame>);

pub fn dance() -> Frames {
    read(include_bytes!("../../../../data/dance.bvh"))
}

pub fn running() -> Frames {
    read(include_bytes!("../../../../data/running.bvh"))
}

fn read(text: &[u8]) -> Frames {
    frames_of(&parser::bvh::read(text).unwrap().motion)
}

fn frames_of(motion: &Motion) -> Frames {
    let frames = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    (motion.skeleton().clone(), frames)
}

pub fn errors((skeleton, frames): &Frames, representation: Representation) -> Errors {
    Errors::new(skeleton, frames, representation)
}

pub fn both(frames: &Frames) -> [Errors; 2] {
    Representation::ALL.map(|representation| errors(frames, representation))
}

pub fn go_on(_: usize, _: usize) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// The error of a gap, posed anew.
pub fn posed_gap(errors: &Errors, start: usize, end: usize) -> f64 {
    (start + 1..end).map(|frame| errors.of_frame(start, end, frame)).fold(0.0, |sum, error| sum + error)
}

/// What a removal costs, with all three gaps posed anew.
pub fn posed_cost(errors: &Errors) -> impl Fn(usize, usize, usize) -> f64 {
    |before, frame, after| {
        let gap = |start, end| posed_gap(errors, start, end);
        gap(before, after) - gap(before, frame) - gap(frame, after)
    }
}

/// Looks at what all removals cost, again after each one.
pub fn naive(frame_count: usize, count: usize, cost: impl Fn(usize, usize, usize) -> f64) -> Vec<usize> {
    let mut keyframes: Vec<usize> = (0..frame_count).collect();
    while keyframes.len() > count.max(2) {
        let costs = keyframes.windows(3).map(|three| cost(three[0], three[1], three[2]) + 0.0);
        // The first of the least.
        let least = costs.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        keyframes.remove(least.0 + 1);
    }
    keyframes
}

/// Few joints, and frames many of which are the same, so that there is much to tie.
pub fn motions(frames: std::ops::Range<usize>) -> impl Strategy<Value = Frames> {
    let value = prop_oneof![-400.0_f32..400.0, Just(0.0)];
    let joints =
        vec((prop::array::uniform3(-5.0_f32..5.0), any::<prop::sample::Index>(), any::<bool>()), 1..5);
    (joints, frames)
        .prop_flat_map(move |(joints, frames)| {
            let mut skeleton = Skeleton::new();
            for (index, (offset, parent, slides)) in joints.into_iter().enumerate() {
                let parent = (index > 0).then(|| skeleton.joints()[parent.index(index)].id);
                let mut channels = Axis::ALL.map(Channel::Rotation).to_vec();
                channels.rotate_left(index % 3);
                channels.extend(slides.then_some(Channel::Position(Axis::X)));
                skeleton.add_joint(parent, "joint", Vec3::from(offset), channels).unwrap();
            }
            let rows = vec(vec(value.clone(), skeleton.channel_count()), 1..6);
            let order = vec(any::<prop::sample::Index>(), frames);
            (Just(skeleton), rows, order)
        })
        .prop_map(|(skeleton, rows, order)| {
            // Half of the time close to the frame before, as in a real motion.
            let mut values = Vec::new();
            for (index, choice) in order.iter().enumerate() {
                let row = choice.get(&rows);
                let earlier = values.len().saturating_sub(row.len())..values.len();
                let earlier: Vec<f32> = values[earlier].to_vec();
                let near = |(value, earlier): (&f32, &f32)| earlier + value / 50.0;
                if index % 2 == 1 {
                    values.extend(row.iter().zip(&earlier).map(near));
                } else {
                    values.extend(row);
                }
            }
            frames_of(&Motion::new(skeleton, order.len(), 1.0 / 30.0, values).unwrap())
        })
}

/// `count` times the same frame.
pub fn still(frame: &Frame, count: usize) -> Vec<Frame> {
    vec![frame.clone(); count]
}

/// `count` times the same frame, but for the last digit that an `f32` has. Every seventh angle stands at the end of a
/// full turn, on either side of it.
pub fn noisy(frame: &Frame, count: usize) -> Vec<Frame> {
    let mut state = 1_u32;
    let mut chance = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        state >> 24
    };
    let mut shake = move |value: f32| match chance() % 3 {
        0 => value.next_down(),
        1 => value.next_up(),
        _ => value,
    };
    let mut noisy = vec![frame.clone(); count];
    for (index, frame) in noisy.iter_mut().enumerate() {
        for (number, angle) in frame.angles.iter_mut().enumerate() {
            let turned = if number % 7 == 0 { 360.0 * (index % 2) as f32 } else { *angle };
            *angle = shake(turned);
        }
        frame.local_positions[0] = Vec3::from(frame.local_positions[0].to_array().map(&mut shake));
    }
    noisy
}

/// The dance, interrupted for `count` frames.
pub fn dance_with_a_pause(count: usize) -> Frames {
    let (skeleton, mut frames) = dance();
    let pause = noisy(&frames[60], count);
    frames.splice(60..61, pause);
    (skeleton, frames)
}
