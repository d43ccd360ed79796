//! The words in the picture: what is shown, what is wrong, what the colours mean, what the keys do.

mod bone;
mod bones;
mod edit;
mod joint;
mod legend;
mod number;
mod points;
mod sister;
mod state;
mod warp;
mod warped;

use std::fmt::Write;

use exam::fk::LocalAnswer;
use glam::Vec3;
use grading::PartState;
use skeleton::Pose;

use crate::edit::Edited;
use crate::live::mover::Mover;
use crate::live::student::{Details, Points, Posed, Standing};
use crate::scene::{Corner, Line, Off, Panel, Pool};
use crate::view::app::{App, Shown};
use crate::window::keys;

pub use bone::OfBones;
use number::Rounded;
pub use number::count;
pub use warp::write_title as write_warp;

/// What the words are about.
pub struct Facts<'a> {
    pub app: &'a App,
    pub shown: Shown<'a>,
    /// How things stand with the student's functions, when they are shown.
    pub standing: Option<&'a Standing>,
    /// What they made of the frame.
    pub posed: Option<&'a Posed>,
    /// The figure to look at, when there is one.
    pub solid: Option<&'a Pose>,
    /// The right pose.
    pub reference: &'a Pose,
    /// The frame's angles, in degrees, and positions relative to the parents.
    pub angles: &'a [f32],
    pub local_positions: &'a [Vec3],
    /// The bones of the frame, where the exercise is about these and one of them is to be explained.
    pub bones: Option<OfBones<'a>>,
    /// How far the joint that is farthest off is off.
    pub worst: Off,
    /// How many joints the picture does not show.
    pub outside: usize,
    /// The motion with interpolated frames, where the figures show it.
    pub edited: Option<&'a Edited>,
    /// Width and height of the picture, in pixels of an ordinary display.
    pub size: (f32, f32),
}

impl Facts<'_> {
    /// What single parts of the student's made of this frame, where it is known.
    fn details(&self) -> Option<&Details> {
        let Shown::Student(answers) = self.shown else { return None };
        answers.details(self.app.frame()).filter(|_| self.standing.is_some_and(|standing| standing.current))
    }

    /// What the student's part 1 made of every joint in this frame, where it is known.
    fn student_locals(&self) -> Option<&[LocalAnswer]> {
        match self.details()? {
            Details::Locals(locals) => Some(locals),
            Details::Visits(_) | Details::Blended { .. } => None,
        }
    }

    /// Whether the student has begun a part (from 0), as far as is known.
    fn is_begun(&self, part: usize) -> bool {
        let board = self.standing.and_then(|standing| standing.board.as_ref());
        let row = board.and_then(|board| board.rows.get(part));
        row.is_none_or(|row| row.state != PartState::NotStarted)
    }

    /// Whether the student is known to have begun any part; while points are counted again, before the last save. Before that
    /// nothing is wrong yet.
    fn is_known_begun(&self) -> bool {
        let board = self.standing.and_then(|standing| standing.board.as_ref().or(standing.former.as_ref()));
        board.is_some_and(|board| board.rows.iter().any(|row| row.state != PartState::NotStarted))
    }

    /// Whether what is shown is what the exercise on bones makes of the motion.
    fn is_of_bones(&self) -> bool {
        match self.shown {
            Shown::Student(answers) => answers.mover().needs_bones(),
            Shown::Reference => self.app.settings.bones && self.edited.is_none(),
        }
    }

    /// Whether what is shown is a student's warped motion.
    fn is_of_warp(&self) -> bool {
        match self.shown {
            Shown::Student(answers) => match answers.mover() {
                Mover::TimeWarp => true,
                Mover::Fk | Mover::Acclaim => false,
            },
            Shown::Reference => false,
        }
    }

    /// The points of the student's functions, whatever they do.
    fn points(&self) -> Option<Points> {
        let sisters = self.app.sister().map(|sister| &sister.standing);
        let own = sisters.or(self.standing).map(Standing::points);
        own.or_else(|| self.app.points_of_other().cloned())
    }

    /// Whether there is room for words beside the figure.
    fn is_roomy(&self) -> bool {
        self.has_room(800.0, 450.0)
    }

    /// Whether there is room for a plot beside what is more important. The curve of a warp takes less.
    fn has_room_for_plot(&self) -> bool {
        let (width, height) = if self.app.time_map().is_some() { (440.0, 440.0) } else { (720.0, 440.0) };
        self.has_room(width, height)
    }

    /// Where there is room for points. Beside each other two figures have little of it: there the original has them, whose
    /// picture is emptier.
    fn corner_for_points(&self) -> Option<Corner> {
        let warped = self.app.time_map().is_some();
        match () {
            () if self.is_roomy() => Some(Corner::TopRight),
            () if !self.app.is_paired() => self.has_room(300.0, 300.0).then_some(Corner::BottomLeft),
            () => (!warped && self.has_room(440.0, 560.0)).then_some(Corner::BottomRight),
        }
    }

    /// Whether the picture has at least this much room.
    fn has_room(&self, width: f32, height: f32) -> bool {
        self.size.0 >= width && self.size.1 >= height
    }
}

/// All texts, each in its corner. Gives how many of them come before a plot; `None` when there is none beside them.
pub fn panels(facts: &Facts, panels: &mut Pool<Panel>) -> Option<usize> {
    panels.clear();
    let settings = &facts.app.settings;
    state::write(facts, begin(panels, Corner::TopLeft));
    if settings.help {
        help(facts, panels);
        return None;
    }
    let edit = &settings.edit;
    if sister::has_told_all(facts) {
        // Nothing is edited, and why is told above.
    } else if let Some(editing) = facts.app.editing() {
        edit::write(facts, editing, begin(panels, Corner::TopLeft));
    } else if (edit.errors || edit.plot) && !settings.still && !facts.app.is_paired() {
        edit::write_hint(facts, begin(panels, Corner::TopLeft));
    }
    if !settings.still {
        begin(panels, Corner::BottomRight).add(Line::Key("h"), "help");
    }
    let before_plot = panels.len();
    // A figure that is covered by words is of no use.
    let (room, roomy) = (facts.has_room(300.0, 300.0), facts.is_roomy());
    if let Some(corner) = facts.corner_for_points().filter(|_| settings.points) {
        points::write(facts, corner != Corner::TopRight, begin(panels, corner));
    }
    if facts.app.selected().is_some() && room {
        let panel = begin(panels, Corner::TopRight);
        match facts.bones {
            Some(_) if facts.is_of_warp() => warped::write_joint(facts, panel),
            Some(bones) => bone::write(facts, bones, panel),
            None => joint::write(facts, panel),
        }
    }
    if roomy {
        legend::write(facts, begin(panels, Corner::BottomLeft));
    }
    facts.has_room_for_plot().then_some(before_plot)
}

fn begin(panels: &mut Pool<Panel>, corner: Corner) -> &mut Panel {
    let panel = panels.add();
    panel.begin(corner);
    panel
}

/// All keys, in two columns where one would be too high. Of a pair that has little room each has one of them.
fn help(facts: &Facts, panels: &mut Pool<Panel>) {
    let count = keys::help().count();
    if facts.app.is_paired() && !facts.is_roomy() {
        let half = count.div_ceil(2);
        let (from, to) = if facts.app.time_map().is_some() { (half, count) } else { (0, half) };
        return keys_between(from, to, begin(panels, Corner::TopLeft));
    }
    // With a line for each, and what stands above.
    let first = if facts.has_room(0.0, 20.0 * count as f32 + 160.0) { count } else { count.div_ceil(2) };
    for (corner, from, to) in [(Corner::TopLeft, 0, first), (Corner::TopRight, first, count)] {
        keys_between(from, to, begin(panels, corner));
    }
}

fn keys_between(from: usize, to: usize, panel: &mut Panel) {
    keys::help().take(to).skip(from).for_each(|(name, help)| panel.add(Line::Key(name), help));
}

/// A number as people read it.
pub fn write_number(text: &mut String, number: f64) {
    // A string takes whatever is written to it.
    let _ = write!(text, "{}", Rounded(number));
}

/// A length in the words of the scale bar.
pub fn write_units(text: &mut String, length: f32) {
    // A string takes whatever is written to it.
    let _ = write!(text, "{} units", Rounded(f64::from(length)));
}
