//! Part 2.

use glam::Quat;

use super::Way;

/// Above this cosine, two rotations are taken for the same.
const NEARLY_1: f32 = 0.9995;

/// The formula, with its weights from this angle.
fn arc(from: Quat, to: Quat, t: f32, angle: f32) -> Quat {
    (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
}

fn straight(from: Quat, to: Quat, t: f32) -> Quat {
    from * (1.0 - t) + to * t
}

/// The formula, or a straight line where it would divide by nearly nothing.
fn arc_or_straight(from: Quat, to: Quat, t: f32, cosine: f32) -> Quat {
    if cosine > NEARLY_1 { straight(from, to, t).normalize() } else { arc(from, to, t, cosine.acos()) }
}

/// Turns `to` round where the two point apart.
fn shorter(from: Quat, to: Quat) -> (Quat, f32) {
    let dot = from.dot(to);
    if dot < 0.0 { (-to, -dot) } else { (to, dot) }
}

/// What each gives for t between 0 and 1.
macro_rules! ways {
    ($($(#[$doc:meta])* $name:ident($from:ident, $to:ident, $t:ident) $body:block)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Way for $name {
                fn slerp($from: Quat, $to: Quat, t: f32) -> Quat {
                    let $t = t.clamp(0.0, 1.0);
                    $body
                }
            }
        )*
    };
}

ways! {
    /// Takes the two as they come.
    AsTheyCome(from, to, t) { arc_or_straight(from, to, t, from.dot(to)) }

    /// Turns both round where they point apart.
    BothTurnedRound(from, to, t) {
        let dot = from.dot(to);
        let (from, to) = if dot < 0.0 { (-from, -to) } else { (from, to) };
        arc_or_straight(from, to, t, from.dot(to))
    }

    /// Turns one round where they do not point apart.
    LongerWay(from, to, t) {
        let dot = from.dot(to);
        let (to, dot) = if dot > 0.0 { (-to, -dot) } else { (to, dot) };
        arc_or_straight(from, to, t, dot)
    }

    /// A straight line, and no arc.
    StraightLine(from, to, t) { straight(from, shorter(from, to).0, t).normalize() }

    /// The same, and no rotation.
    StraightLineInside(from, to, t) { straight(from, shorter(from, to).0, t) }

    /// Always the formula.
    AlwaysDivides(from, to, t) {
        let (to, cosine) = shorter(from, to);
        arc(from, to, t, cosine.acos())
    }

    /// Looks only whether the sine is zero: of a cosine above 1 there is no angle, and no sine either.
    DividesUnlessZero(from, to, t) {
        let (to, cosine) = shorter(from, to);
        let angle = cosine.acos();
        if angle.sin() == 0.0 { from } else { arc(from, to, t, angle) }
    }

    /// Looks whether the two are the same before it turns one round.
    NearBeforeShorter(from, to, t) {
        if from.dot(to) > NEARLY_1 {
            straight(from, to, t).normalize()
        } else {
            let (to, cosine) = shorter(from, to);
            arc(from, to, t, cosine.acos())
        }
    }

    /// Does not extend the t that it was given.
    Backwards(from, to, t) { solutions::interpolation::slerp(from, to, 1.0 - t) }
}

/// Turns one round and keeps the cosine from before.
pub struct OldCosine<const NORMALIZED: bool>;

impl<const NORMALIZED: bool> Way for OldCosine<NORMALIZED> {
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        normalized::<NORMALIZED>(arc_or_straight(from, shorter(from, to).0, t.clamp(0.0, 1.0), from.dot(to)))
    }
}

/// Takes twice the angle, as if the four numbers turned like the joint, or half of it.
pub struct OtherAngle<const DOUBLED: bool, const NORMALIZED: bool>;

impl<const DOUBLED: bool, const NORMALIZED: bool> Way for OtherAngle<DOUBLED, NORMALIZED> {
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        let t = t.clamp(0.0, 1.0);
        let (to, cosine) = shorter(from, to);
        if cosine > NEARLY_1 {
            return straight(from, to, t).normalize();
        }
        let angle = cosine.acos() * if DOUBLED { 2.0 } else { 0.5 };
        normalized::<NORMALIZED>(arc(from, to, t, angle))
    }
}

fn normalized<const NORMALIZED: bool>(q: Quat) -> Quat {
    if NORMALIZED { q.normalize() } else { q }
}

/// Goes on before the first and beyond the second.
pub struct GoesOn;

impl Way for GoesOn {
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        let (to, cosine) = shorter(from, to);
        arc_or_straight(from, to, t, cosine)
    }
}
