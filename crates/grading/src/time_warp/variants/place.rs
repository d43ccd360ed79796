//! Part 1.

use skeleton::acclaim::Between;

use super::Way;

/// What is at a place of the old motion, as it should be.
fn at(place: f64, old_count: usize) -> Between {
    let last = old_count - 1;
    let before = place.floor() as usize;
    let t = place - before as f64;
    let after = if t > 0.0 { before + 1 } else { before };
    Between { before: before.min(last), after: after.min(last), t: t as f32 }
}

/// The right place.
fn place(new_frame: usize, old_count: usize, new_count: usize) -> f64 {
    new_frame as f64 * old_count as f64 / new_count as f64
}

/// Between the frame before a place and the one that follows it, wherever the place is.
fn from_next(place: f64, old_count: usize, t: f32) -> Between {
    let (before, last) = (place.floor() as usize, old_count - 1);
    Between { before: before.min(last), after: (before + 1).min(last), t }
}

/// How far the new motion has got at this frame.
fn share(new_frame: usize, new_count: usize) -> f32 {
    (new_frame as f64 / new_count as f64) as f32
}

/// What each gives for a frame of the new motion.
macro_rules! ways {
    ($($(#[$doc:meta])* $name:ident($frame:ident, $old:ident, $new:ident) $body:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Way for $name {
                fn place($frame: usize, $old: usize, $new: usize) -> Between {
                    $body
                }
            }
        )*
    };
}

ways! {
    /// The first frame is the first, and the last is the last.
    BothEndsKept(frame, old, new) {
        at(frame as f64 * (old - 1) as f64 / (new.max(2) - 1) as f64, old)
    };

    /// Steps between the old frames, and frames of the new motion.
    OneOffOld(frame, old, new) at(frame as f64 * (old - 1) as f64 / new as f64, old);

    /// Frames of the old motion, and steps between the new ones.
    OneOffNew(frame, old, new) at(frame as f64 * old as f64 / (new.max(2) - 1) as f64, old);

    /// How many frames there are in each other's place, and then nothing behind the last frame.
    UpsideDown(frame, old, new) at(place(frame, new, old), old);

    /// The same, with frames that are not there.
    UpsideDownUnbound(frame, old, new) {
        let place = place(frame, new, old);
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    };

    /// The same, with only the frame after kept within the motion.
    UpsideDownHalfBound(frame, old, new) {
        let place = place(frame, new, old);
        let after = (place.ceil() as usize).min(old - 1);
        Between { before: place.floor() as usize, after, t: place.fract() as f32 }
    };

    /// The middle of a frame is the middle of another.
    MiddleOfFrames(frame, old, new) {
        at(((frame as f64 + 0.5) * old as f64 / new as f64 - 0.5).max(0.0), old)
    };

    /// The ratio as a whole number.
    WholeRatio(frame, old, new) { let whole = (frame * (old / new)).min(old - 1); Between { before: whole, after: whole, t: 0.0 } };

    /// The frame after is that behind the place, whether there is one or not.
    PastTheEnd(frame, old, new) {
        let place = place(frame, old, new);
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    };

    /// The frame after is the next one, whether there is one or not.
    NextPastTheEnd(frame, old, new) {
        let place = place(frame, old, new);
        let before = place.floor() as usize;
        Between { before, after: before + 1, t: place.fract() as f32 }
    };

    /// After the last frame comes the first.
    RoundAgain(frame, old, new) {
        let place = place(frame, old, new);
        let before = place.floor() as usize;
        Between { before, after: (before + 1) % old, t: place.fract() as f32 }
    };

    /// What is behind the last frame goes on from the last two.
    GoesOn(frame, old, new) {
        let place = place(frame, old, new);
        let before = (place.floor() as usize).min(old.saturating_sub(2));
        Between { before, after: (before + 1).min(old - 1), t: (place - before as f64) as f32 }
    };

    /// How far it is back from the frame after.
    FromAfter(frame, old, new) { let right = at(place(frame, old, new), old); Between { t: 1.0 - right.t, ..right } };

    /// The same, where the frame after is always the next one.
    FromNext(frame, old, new) {
        let place = place(frame, old, new);
        let before = place.floor() as usize;
        Between { before, after: (before + 1).min(old - 1), t: 1.0 - place.fract() as f32 }
    };

    /// The place less the frame after.
    LessAfter(frame, old, new) {
        let place = place(frame, old, new);
        Between { t: (place - place.ceil()) as f32, ..at(place, old) }
    };

    /// The place, of which nothing was taken off.
    WholePlace(frame, old, new) {
        let place = place(frame, old, new);
        Between { t: place as f32, ..at(place, old) }
    };

    /// The same, where the frame after is always the next one.
    WholePlaceToNext(frame, old, new) {
        let place = place(frame, old, new);
        from_next(place, old, place as f32)
    };

    /// What is left over by a division that was not finished.
    Remainder(frame, old, new) {
        Between { t: (frame * old % new) as f32, ..at(place(frame, old, new), old) }
    };

    /// The same, where the frame after is always the next one.
    RemainderToNext(frame, old, new) from_next(place(frame, old, new), old, (frame * old % new) as f32);

    /// How far the new motion has got.
    Share(frame, old, new) Between { t: share(frame, new), ..at(place(frame, old, new), old) };

    /// The same, where the frame after is always the next one.
    ShareToNext(frame, old, new) from_next(place(frame, old, new), old, share(frame, new));

    /// The frame before, whole.
    RoundedDown(frame, old, new) Between { t: 0.0, ..at(place(frame, old, new), old) };

    /// The frame after, whole.
    RoundedUp(frame, old, new) at(place(frame, old, new).ceil(), old);

    /// The nearest frame, whole; half-way the one after.
    Rounded(frame, old, new) at((place(frame, old, new) + 0.5).floor(), old);

    /// The same; half-way the one before.
    RoundedTiesDown(frame, old, new) at((place(frame, old, new) - 0.5).ceil(), old);
}

/// With too few digits for millions of frames: a product by a ratio (0), a quotient of a product (1), a part of the new
/// motion times the old one (2), a quotient by the other ratio (3), or a short ratio in a long product (4).
pub struct FewDigits<const FORMULA: u8>;

impl<const FORMULA: u8> Way for FewDigits<FORMULA> {
    fn place(frame: usize, old_count: usize, new_count: usize) -> Between {
        let (new_frame, old, new) = (frame as f32, old_count as f32, new_count as f32);
        let place = match FORMULA {
            0 => old / new * new_frame,
            1 => new_frame * old / new,
            2 => new_frame / new * old,
            3 => new_frame / (new / old),
            _ => return at(f64::from(old / new) * frame as f64, old_count),
        };
        at(f64::from(place), old_count)
    }
}
