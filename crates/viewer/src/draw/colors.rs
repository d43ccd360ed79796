//! What colour things have.

use crate::draw::canvas::Color;
use crate::scene::{Off, Side, Stroke, Tint, Trail};

/// Edges around letters, so that they can be read on anything.
pub(super) const PAPER: Color = Color(0xF4_F6_F7);

/// What is written on the picture itself.
pub(super) const INK: Color = Color(0x22_2A_35);

/// Behind texts, and the share of the picture that it hides.
pub(super) const BACKDROP: Color = Color(0x1D_24_2E);
pub(super) const BACKDROP_OPACITY: f32 = 0.82;

/// On it: ordinary words, less important ones, what is right or done, and what asks to be looked at.
pub(super) const PLAIN: Color = Color(0xE6_EA_EE);
pub(super) const QUIET: Color = Color(0xB9_C2_CC);
pub(super) const RIGHT: Color = Color(0x7F_D4_FF);
pub(super) const WARNING: Color = Color(0xFF_C2_4B);

/// The border of a joint's square, of a dark one, and of the frame around the selected one.
const SQUARE_BORDER: Color = Color(0x3B_0F_63);
const LIGHT_BORDER: Color = Color(0xFF_D9_D2);

/// What is not up to date is mixed with this.
pub(super) const PALE: Color = Color(0xDD_E0_E3);

/// The colours, chosen so that they stay apart for colour-blind eyes, in their lightness if not in their hue.
pub fn color_of(tint: Tint) -> Color {
    match tint {
        Tint::Joint => Color(0x8A_2B_D8),
        Tint::Bone(Side::Left) => Color(0xD9_7A_18),
        Tint::Bone(Side::Right) => Color(0x2F_7F_D0),
        Tint::Bone(Side::Middle) => Color(0x39_43_50),
        // What the light makes of them, by and large.
        Tint::Body(Side::Left) => Color(0xF0_9E_58),
        Tint::Body(Side::Right) => Color(0x4A_97_E6),
        Tint::Body(Side::Middle) => Color(0xEB_E7_DC),
        Tint::Off(Off::Right) => Color(0x8A_2B_D8),
        Tint::Off(Off::Little) => Color(0xFF_E4_5C),
        Tint::Off(Off::Some) => Color(0xE0_44_2E),
        Tint::Off(Off::Much) => Color(0x3A_0A_0A),
        Tint::Ghost => Color(0x0E_8F_83),
        Tint::Error => Color(0xE6_00_B8),
        Tint::Keyframe => Color(0x2C_F0_4A),
        Tint::X => Color(0xC8_1E_1E),
        Tint::Y => Color(0x2F_B3_44),
        Tint::Z => Color(0x22_3F_D6),
        Tint::Ink => INK,
    }
}

/// The colour of a curve on the backdrop: yellow and blue, which nearly everybody tells apart.
pub(super) fn curve(stroke: Stroke) -> Color {
    match stroke {
        Stroke::Solid => Color(0xFF_D1_4A),
        Stroke::Dashed => RIGHT,
        Stroke::Faint => QUIET,
    }
}

/// How a joint's square looks: what fills it, its border, and how large it is, 1 for one in its right place. Size tells
/// what colours tell, so that nobody depends on them.
pub(super) fn square_of(off: Off) -> (Color, Color, f32) {
    let fill = color_of(Tint::Off(off));
    match off {
        Off::Right => (fill, SQUARE_BORDER, 1.0),
        Off::Little => (fill, Color(0x4A_3C_00), 1.2),
        Off::Some => (fill, Color(0x50_08_00), 1.45),
        Off::Much => (fill, LIGHT_BORDER, 1.75),
    }
}

/// The colour of a trail: that of its side, darker. Where it has none, one that can be told from the others and is neither.
pub(super) fn trail(trail: &Trail) -> Color {
    const OTHERS: [Color; 5] =
        [Color(0xC0_30_5A), Color(0x2A_86_48), Color(0x6E_4C_CC), Color(0x8A_6A_10), Color(0x4C_40_3A)];
    match trail.side {
        Side::Left => Color(0xB8_5C_0A),
        Side::Right => Color(0x1C_5E_AC),
        Side::Middle => OTHERS[trail.index % OTHERS.len()],
    }
}
