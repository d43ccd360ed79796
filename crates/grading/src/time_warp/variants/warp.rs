//! Part 3.

use std::marker::PhantomData;
use std::ops::Range;

use skeleton::acclaim::Posture;

use super::{Way, right_frame};

/// What each makes of a motion that has frames.
macro_rules! ways {
    ($($(#[$doc:meta])* $name:ident($postures:ident, $count:ident) $body:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Way for $name {
                fn warp($postures: &[Posture], $count: usize) -> Vec<Posture> {
                    if $postures.is_empty() { Vec::new() } else { $body }
                }
            }
        )*
    };
}

fn right(postures: &[Posture], new_count: usize) -> impl Iterator<Item = Posture> {
    (0..new_count).map(move |frame| right_frame(postures, frame, new_count))
}

/// Other frames than those that were asked for, each as it should be.
fn right_frames(postures: &[Posture], frames: Range<usize>, new_count: usize) -> Vec<Posture> {
    frames.map(|frame| right_frame(postures, frame, new_count)).collect()
}

ways! {
    /// Right, and then one frame more.
    OneMore(postures, count) {
        right(postures, count).chain(postures.last().cloned()).collect()
    };

    /// Right, but for the last frame.
    OneLess(postures, count) right(postures, count).take(count.saturating_sub(1)).collect();

    /// As if one frame more had been asked for.
    WarpedToOneMore(postures, count) right(postures, count + 1).collect();

    /// As if one frame less had been asked for.
    WarpedToOneLess(postures, count) right(postures, count.saturating_sub(1)).collect();

    /// From the second new frame on, and one behind the last.
    FromOne(postures, count) right_frames(postures, 1..count + 1, count);

    /// From the second new frame on, to the last.
    FromOneOneLess(postures, count) right_frames(postures, 1..count, count);

    /// As many frames as before, in the places that new ones have.
    OldCount(postures, count) right_frames(postures, 0..postures.len(), count);

    /// The new motion ends as the old one does.
    LastKept(postures, count) {
        let mut warped: Vec<Posture> = right(postures, count).collect();
        if let (Some(new), Some(old)) = (warped.last_mut(), postures.last()) {
            new.clone_from(old);
        }
        warped
    };

    /// The first frames of the old motion, as many as there are.
    CutOff(postures, count) postures.iter().take(count).cloned().collect();

    /// Frame by frame the old motion, and then its last frame until there are enough.
    CutOrFilled(postures, count) (0..count).map(|frame| postures[frame.min(postures.len() - 1)].clone()).collect();

    /// The same, and then the whole motion again.
    CutOrRepeated(postures, count) (0..count).map(|frame| postures[frame % postures.len()].clone()).collect();
}

/// One old frame for each new one: the one before (0), the one after (1), or the nearer one, where half-way is nearer to the
/// one after (2) or to the one before (3).
pub struct OneOldFrame<const WHICH: u8>;

impl<const WHICH: u8> Way for OneOldFrame<WHICH> {
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        let is_before = match WHICH {
            0 => true,
            1 => false,
            2 => t < 0.5,
            _ => t <= 0.5,
        };
        if is_before { from.clone() } else { to.clone() }
    }
}

/// Half of the frame before and half of the one after.
pub struct HalfAndHalf;

impl Way for HalfAndHalf {
    fn blend(from: &Posture, to: &Posture, _: f32) -> Posture {
        solutions::time_warp::blend(from, to, 0.5)
    }
}

/// Parts 1 and 2 are right, and part 3 does not call them: it goes another way.
pub struct OnlyInWarp<W>(PhantomData<W>);

impl<W: Way> Way for OnlyInWarp<W> {
    fn warp(postures: &[Posture], new_count: usize) -> Vec<Posture> {
        W::warp(postures, new_count)
    }
}
