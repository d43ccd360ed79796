//! The words in the picture: what is shown, what is wrong, what the colours mean, what the keys do.

mod joint;
mod legend;
mod number;
mod points;
mod state;

use std::fmt::Write;

use exam::fk::PosedFrame;
use glam::Vec3;
use skeleton::Pose;

use crate::app::{App, Shown};
use crate::keys;
use crate::scene::{Corner, Line, Off, Panel, Pool};
use crate::student::Standing;

use number::Rounded;

/// What the words are about.
pub struct Facts<'a> {
    pub app: &'a App,
    pub shown: Shown<'a>,
    /// How things stand with the student's functions, when they are shown.
    pub standing: Option<&'a Standing>,
    /// What they made of the frame.
    pub posed: Option<&'a PosedFrame>,
    /// The figure to look at, when there is one.
    pub solid: Option<&'a Pose>,
    /// The right pose.
    pub reference: &'a Pose,
    /// The frame's angles, in degrees, and positions relative to the parents.
    pub angles: &'a [f32],
    pub local_positions: &'a [Vec3],
    /// How far the joint that is farthest off is off.
    pub worst: Off,
    /// How many joints the picture does not show.
    pub outside: usize,
    /// Whether the picture is large enough for a legend.
    pub roomy: bool,
}

/// All texts, each in its corner.
pub fn panels(facts: &Facts, panels: &mut Pool<Panel>) {
    panels.clear();
    let settings = &facts.app.settings;
    state::write(facts, begin(panels, Corner::TopLeft));
    if facts.app.selected().is_some() {
        joint::write(facts, begin(panels, Corner::TopRight));
    }
    if settings.help {
        help(begin(panels, Corner::TopLeft));
        return;
    }
    if settings.points {
        points::write(facts, begin(panels, Corner::TopRight));
    }
    begin(panels, Corner::BottomRight).add(Line::Key("h"), "help");
    if facts.roomy {
        legend::write(facts, begin(panels, Corner::BottomLeft));
    }
}

fn begin(panels: &mut Pool<Panel>, corner: Corner) -> &mut Panel {
    let panel = panels.add();
    panel.begin(corner);
    panel
}

fn help(panel: &mut Panel) {
    keys::help().for_each(|(name, help)| panel.add(Line::Key(name), help));
}

/// A length in the words of the scale bar.
pub fn write_units(text: &mut String, length: f32) {
    // A string takes whatever is written to it.
    let _ = write!(text, "{} units", Rounded(f64::from(length)));
}
