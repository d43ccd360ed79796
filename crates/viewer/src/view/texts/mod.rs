//! The words in the picture: what is shown, what is wrong, what the colours mean, what the keys do.

mod joint;
mod legend;
mod number;
mod points;
mod state;

use std::fmt::Write;

use exam::fk::{LocalAnswer, PosedFrame};
use glam::Vec3;
use skeleton::Pose;

use crate::live::student::Standing;
use crate::scene::{Corner, Line, Off, Panel, Pool};
use crate::view::app::{App, Shown};
use crate::window::keys;

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
    /// Width and height of the picture, in pixels of an ordinary display.
    pub size: (f32, f32),
}

impl Facts<'_> {
    /// What the student's part 1 made of every joint in this frame, where it is known.
    fn student_locals(&self) -> Option<&[LocalAnswer]> {
        let Shown::Student(answers) = self.shown else { return None };
        answers.locals(self.app.frame()).filter(|_| self.standing.is_some_and(|standing| standing.current))
    }

    /// Whether the picture has at least this much room.
    fn has_room(&self, width: f32, height: f32) -> bool {
        self.size.0 >= width && self.size.1 >= height
    }
}

/// All texts, each in its corner.
pub fn panels(facts: &Facts, panels: &mut Pool<Panel>) {
    panels.clear();
    let settings = &facts.app.settings;
    state::write(facts, begin(panels, Corner::TopLeft));
    if settings.help {
        return help(facts, panels);
    }
    // A figure that is covered by words is of no use.
    let (room, roomy) = (facts.has_room(300.0, 300.0), facts.has_room(800.0, 450.0));
    if settings.points && room {
        let corner = if roomy { Corner::TopRight } else { Corner::BottomLeft };
        points::write(facts, begin(panels, corner));
    }
    if facts.app.selected().is_some() && room {
        joint::write(facts, begin(panels, Corner::TopRight));
    }
    if !settings.still {
        begin(panels, Corner::BottomRight).add(Line::Key("h"), "help");
    }
    if roomy {
        legend::write(facts, begin(panels, Corner::BottomLeft));
    }
}

fn begin(panels: &mut Pool<Panel>, corner: Corner) -> &mut Panel {
    let panel = panels.add();
    panel.begin(corner);
    panel
}

/// All keys, in two columns where one would be too high.
fn help(facts: &Facts, panels: &mut Pool<Panel>) {
    let count = keys::help().count();
    let first = if facts.has_room(0.0, 700.0) { count } else { count.div_ceil(2) };
    for (corner, from, to) in [(Corner::TopLeft, 0, first), (Corner::TopRight, first, count)] {
        let panel = begin(panels, corner);
        keys::help().take(to).skip(from).for_each(|(name, help)| panel.add(Line::Key(name), help));
    }
}

/// A length in the words of the scale bar.
pub fn write_units(text: &mut String, length: f32) {
    // A string takes whatever is written to it.
    let _ = write!(text, "{} units", Rounded(f64::from(length)));
}
