//! What the colours mean.

use super::Facts;
use super::number::Rounded;
use crate::scene::{Line, Off, Panel, Side, Style, Tint};

pub fn write(facts: &Facts, panel: &mut Panel) {
    let (app, stage) = (facts.app, facts.app.stage());
    let students = facts.standing.is_some();
    if students && facts.worst > Off::Right {
        off(panel);
    } else {
        panel.add(Line::Legend(Tint::Joint), "joint");
    }
    let bone = match app.settings.style {
        Style::Lit => Tint::Body,
        Style::Lines => Tint::Bone,
    };
    if stage.has_sides() {
        panel.add(Line::Legend(bone(Side::Left)), "left");
        panel.add(Line::Legend(bone(Side::Right)), "right");
    } else {
        panel.add(Line::Legend(bone(Side::Middle)), "bone");
    }
    if app.settings.axes {
        panel.add(Line::Legend(Tint::X), "local X axis");
        panel.add(Line::Legend(Tint::Y), "local Y axis");
        panel.add(Line::Legend(Tint::Z), "local Z axis");
    }
    if app.settings.ghost && students {
        panel.add(Line::Legend(Tint::Ghost), "the goal");
    }
    if facts.edited.is_some() {
        if app.settings.ghost {
            panel.add(Line::Legend(Tint::Ghost), "the original");
        }
        if app.settings.edit.errors {
            panel.add(Line::Legend(Tint::Error), "arrow: to the original's tip");
        }
        panel.add(Line::Legend(Tint::Keyframe), "keyframe");
    }
    let cell = f64::from(stage.ground().cell);
    panel.add(Line::Text, format_args!("grid: {} units of the file", Rounded(cell)));
}

/// How far joints are off, in shares of the figure's size.
fn off(panel: &mut Panel) {
    let percent = |share: f32| Rounded(f64::from(share) * 100.0);
    panel.add(Line::Legend(Tint::Off(Off::Right)), "joint in its place");
    panel.add(
        Line::Legend(Tint::Off(Off::Little)),
        format_args!("up to {} % of the figure off", percent(Off::LITTLE)),
    );
    panel.add(Line::Legend(Tint::Off(Off::Some)), format_args!("up to {} % off", percent(Off::SOME)));
    panel.add(Line::Legend(Tint::Off(Off::Much)), "more");
}
