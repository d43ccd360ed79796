//! Keyframes: from all frames of a motion to the few that matter.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. Each is given what
//! the one before it computes, so that you can write and check them in any order.
//!
//! - Try it: in `cargo view --exercise keyframes` your functions choose the keyframes, and the frames between them are
//!   interpolated.
//! - Check it: `cargo test -p keyframes` shows your points and what to do next; `cargo test -p keyframes part1` checks
//!   part 1 only.
//!
//! Frames are counted from 0. At first every frame is a keyframe. A frame that is no longer one is interpolated between
//! the nearest keyframes before and after it, and is then a little off: that is its error. Keep nothing between calls.

#[allow(unused_imports)] // You may need all of them.
use skeleton::{FrameErrors, Joint, JointId, Pose, RemovalCosts, Skeleton};

/// Part 1 (5 points): how far an interpolated pose is from the original one.
///
/// **In:** the `skeleton`, and two poses of it. `pose[joint.id].position` is where a joint is.
///
/// **Out:** the sum, over all tips, of the squared distance between where the tip is in one pose and in the other.
///
/// A tip is an End Site (`joint.is_end_site`), and also a joint that no other joint hangs on: some files leave End Sites
/// out. Other joints do not count.
///
/// Square in `f32` or in `f64` as you like. The sum is an `f64`, because over a long motion many small numbers are added
/// to a large one.
///
/// **Example.** One of two tips is off by 3 along X and 4 along Y, the other is in its place: the error is 25.
pub fn pose_error(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
    // solution-begin
    let mut is_tip = vec![true; skeleton.len()];
    for parent in skeleton.joints().iter().filter_map(|joint| joint.parent) {
        is_tip[parent.0] = false;
    }
    let tips = skeleton.joints().iter().filter(|joint| is_tip[joint.id.0]);
    let error = |joint: &Joint| original[joint.id].position.distance_squared(interpolated[joint.id].position);
    tips.map(|joint| f64::from(error(joint))).sum()
    // solution-else
    // let _ = (skeleton, original, interpolated); // Keeps the compiler quiet for now. Delete this line when you start.
    // 0.0
    // solution-end
}

/// Part 2 (5 points): what it costs to remove a keyframe.
///
/// **In:** the keyframe `frame`, and the keyframes next to it: `before` < `frame` < `after`. `errors.between(start, end, i)`
/// is the error (part 1) of frame `i` when it is interpolated between the keyframes `start` and `end`.
///
/// **Out:** by how much the accumulated error, the sum over all frames, grows when `frame` is no keyframe any more.
///
/// Then not only `frame` itself is interpolated. All frames from `before` to `after` are, and those between the old
/// keyframes now in another way than up to now.
///
/// **Example.** With the keyframes 2, 3, 4, removing 3 costs `errors.between(2, 4, 3)`. With the keyframes 2, 4, 5,
/// removing 4 costs `errors.between(2, 5, 3) + errors.between(2, 5, 4) - errors.between(2, 4, 3)`.
pub fn removal_cost(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    // solution-begin
    let gap = |start, end| (start + 1..end).map(|i| errors.between(start, end, i)).sum::<f64>();
    gap(before, after) - gap(before, frame) - gap(frame, after)
    // solution-else
    // let _ = (before, frame, after, errors); // As above.
    // 0.0
    // solution-end
}

/// Part 3 (5 points): which frames stay keyframes.
///
/// **In:** how many frames the motion has, how many keyframes are wanted, and `costs.of(before, frame, after)`: what it
/// costs to remove the keyframe `frame` while its neighbours are `before` and `after` (part 2).
///
/// **Out:** the keyframes that stay, in ascending order.
///
/// Begin with all frames. As long as there are more than `count`, remove the one that costs least, and of several that cost
/// the same the earliest. The first and the last frame always stay, even when `count` is 0 or 1. When there
/// are no more than `count` frames, all stay.
///
/// Mind that a removal changes what it would cost to remove the keyframes next to it.
///
/// **Example.** Of 5 frames 3 are to stay. At first removing 1, 2, 3 costs 4, 1, 2: frame 2 goes. The neighbours of 1 are now
/// 0 and 3, those of 3 are 1 and 4, and it costs 6 and 7: frame 1 goes. There remain 0, 3, 4.
pub fn reduce(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    // solution-begin
    let surplus = frame_count.saturating_sub(count.max(2));
    let mut stays = vec![true; frame_count];
    for removal in Removals::new(frame_count, costs).take(surplus) {
        stays[removal.frame] = false;
    }
    (0..frame_count).filter(|&frame| stays[frame]).collect()
    // solution-else
    // let _ = (count, costs); // As above.
    // (0..frame_count).collect()
    // solution-end
}
// solution-begin

/// Removes one keyframe after the other, always the one that costs least.
///
/// Only the two neighbours of a removed keyframe get new costs. All costs lie in a heap; those that were replaced stay in
/// it and are passed over when they come up. For n frames that makes about n log n steps, where looking at all costs
/// again for every removal makes n².
#[derive(Debug)]
pub struct Removals<'a> {
    costs: &'a RemovalCosts<'a>,
    neighbours: Vec<Neighbours>,
    heap: std::collections::BinaryHeap<Candidate>,
}

/// A keyframe that was removed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Removal {
    /// Which one.
    pub frame: usize,
    /// What that cost.
    pub cost: f64,
}

/// The keyframes next to a keyframe.
#[derive(Clone, Copy, Debug)]
struct Neighbours {
    before: usize,
    after: usize,
    /// How often they have changed: a candidate with another number is out of date.
    version: u32,
}

#[derive(Clone, Copy, Debug)]
struct Candidate {
    frame: usize,
    cost: f64,
    version: u32,
}

impl<'a> Removals<'a> {
    /// From the first removal on, until only the first and the last frame are left.
    pub fn new(frame_count: usize, costs: &'a RemovalCosts<'a>) -> Self {
        let neighbours =
            |frame: usize| Neighbours { before: frame.wrapping_sub(1), after: frame + 1, version: 0 };
        let inner = 1..frame_count.saturating_sub(1);
        let candidate = |frame| Candidate::new(frame, costs.of(frame - 1, frame, frame + 1), 0);
        let heap = inner.map(candidate).collect();
        Removals { costs, neighbours: (0..frame_count).map(neighbours).collect(), heap }
    }

    fn refresh(&mut self, frame: usize) {
        if frame == 0 || frame + 1 == self.neighbours.len() {
            return;
        }
        let Neighbours { before, after, version } = &mut self.neighbours[frame];
        *version += 1;
        let cost = self.costs.of(*before, frame, *after);
        self.heap.push(Candidate::new(frame, cost, *version));
    }
}

impl Iterator for Removals<'_> {
    type Item = Removal;

    fn next(&mut self) -> Option<Removal> {
        loop {
            let Candidate { frame, cost, version } = self.heap.pop()?;
            let Neighbours { before, after, version: current } = self.neighbours[frame];
            if version != current {
                continue;
            }
            // No candidate of this frame counts any more.
            self.neighbours[frame].version += 1;
            self.neighbours[before].after = after;
            self.neighbours[after].before = before;
            self.refresh(before);
            self.refresh(after);
            return Some(Removal { frame, cost });
        }
    }
}

impl Candidate {
    fn new(frame: usize, cost: f64, version: u32) -> Candidate {
        // Of zeros, −0 would come before 0. What is no number has a sign as well, and with a minus it would come first.
        let cost = if cost.is_nan() { f64::NAN.copysign(1.0) } else { cost + 0.0 };
        Candidate { frame, cost, version }
    }
}

/// The largest is the one that costs least, and of several the earliest: a heap gives its largest item first. What is no
/// number comes last.
impl Ord for Candidate {
    fn cmp(&self, other: &Candidate) -> std::cmp::Ordering {
        other.cost.total_cmp(&self.cost).then(other.frame.cmp(&self.frame))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Candidate) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Candidate) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}
// solution-end
