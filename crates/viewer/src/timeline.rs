//! TEMPORARY
#![allow(missing_docs)]
use crate::scene::Timeline;
pub fn contains(_size: (usize, usize), _scale: f32, _place: (f32, f32)) -> bool {
    false
}
pub fn frame_at(_size: (usize, usize), _scale: f32, _timeline: &Timeline, _x: f32) -> usize {
    0
}
