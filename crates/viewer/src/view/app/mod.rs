//! What the viewer shows of one motion at a moment: the state that keys and mouse change, and the scene that follows
//! from it.

mod aim;
mod editing;
mod fill;
mod plot;
mod sister;
#[cfg(test)]
mod tests;
mod warp;

use std::sync::Arc;

use glam::Vec3;
use skeleton::Joint;

use crate::camera::Camera;
use crate::live::student::Points;
use crate::motion::stage::{Moment, Stage, tips};
use crate::scene::Style;
use crate::view::answers::Answers;
use crate::view::player::Player;
use crate::view::warp::Warp;
use crate::window::keys::Action;

use aim::Aim;
pub use editing::{EditSettings, Editing};
pub use sister::Sister;

/// Whose functions move the figure.
#[derive(Clone, Copy)]
pub enum Shown<'a> {
    /// The reference solution's.
    Reference,
    /// The student's, with the reference's figure beside them as the goal.
    Student(&'a dyn Answers),
}

/// What is drawn, and how. All of it can be changed by keys, or on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Bodies in the light, or lines.
    pub style: Style,
    /// Whether the goal is shown beside the student's figure.
    pub ghost: bool,
    /// Whether joints have axes.
    pub axes: bool,
    /// Whether the exercise is about the bones for which the joints stand, where they stand for any.
    pub bones: bool,
    /// Whether the tips of the figure leave traces.
    pub traces: bool,
    /// Whether the camera moves along with the figure.
    pub follow: bool,
    /// Whether the student's points are shown.
    pub points: bool,
    /// Whether the curve of a time warp is shown.
    pub curve: bool,
    /// Whether the keys are explained.
    pub help: bool,
    /// Whether it is a picture that nobody can do anything with, and not a window.
    pub still: bool,
    /// Whether there are words, a legend, a scale and a bar in the picture at all.
    pub words: bool,
    /// How large texts are: 1 is the size for an ordinary display.
    pub text_scale: f32,
    /// What is edited of the motion, and how that is shown.
    pub edit: EditSettings,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            style: Style::Lit,
            ghost: true,
            axes: true,
            bones: false,
            traces: true,
            follow: true,
            points: true,
            curve: true,
            help: false,
            still: false,
            words: true,
            text_scale: 1.0,
            edit: EditSettings::default(),
        }
    }
}

/// The state of the viewer for one motion.
#[derive(Clone, Debug)]
pub struct App {
    /// What is drawn, and how.
    pub settings: Settings,
    stage: Arc<Stage>,
    /// The file's name, and what tells the motion from others of this file.
    file: String,
    title: String,
    warnings: Vec<String>,
    /// Why the file cannot be read as it is now.
    unreadable: Vec<String>,
    player: Player,
    camera: Camera,
    /// From the followed point to the camera's target.
    offset: Vec3,
    aim: Aim,
    selected: Option<usize>,
    /// The End Sites, and leaves without one.
    tips: Vec<usize>,
    editing: Editing,
    /// Of an exercise on editing.
    sister: Option<Sister>,
    /// The points of functions that do not move this motion.
    points_of_other: Option<Points>,
    /// How it is warped.
    warp: Option<Warp>,
    /// Whether it is shown with a warped one, or is one; and the stretch that is warped of the other.
    paired: bool,
    stretch: Option<[usize; 2]>,
    memory: Memory,
}

/// What is used again for every picture.
#[derive(Clone, Debug, Default)]
struct Memory {
    /// The shown frame.
    now: Moment,
    /// A frame that has left its traces.
    past: Moment,
    points: Vec<Vec3>,
}

impl App {
    /// Shows `stage` from its frame 0. `title` is the file's name; `warnings` are shown with it.
    pub fn new(stage: Arc<Stage>, title: String, warnings: Vec<String>, size: (usize, usize)) -> App {
        let anchor = stage.anchor(0);
        let camera = stage.camera(anchor, &[], size);
        let mut app = App {
            settings: Settings::default(),
            player: Player::new(stage.frame_count(), stage.motion().playable_frame_time()),
            offset: camera.target - anchor,
            camera,
            tips: tips(stage.motion().skeleton().joints()),
            warp: stage.warp().map(Warp::new),
            stage,
            file: title,
            title: String::new(),
            warnings,
            unreadable: Vec::new(),
            aim: Aim::Meet,
            selected: None,
            editing: Editing::default(),
            sister: None,
            points_of_other: None,
            paired: false,
            stretch: None,
            memory: Memory::default(),
        };
        app.name();
        app
    }

    /// Shows another state of the same motion, whose file has changed. What can stay as it is does.
    pub fn replace(&mut self, stage: Arc<Stage>, warnings: Vec<String>) {
        let before = std::mem::replace(&mut self.stage, stage);
        let motion = self.stage.motion();
        self.tips = tips(motion.skeleton().joints());
        self.editing = Editing::default();
        self.player = self.player.for_motion(self.stage.frame_count(), motion.playable_frame_time());
        let (old, new) = (before.motion().skeleton().joints(), motion.skeleton().joints());
        self.selected = self.selected.and_then(|joint| same_joint(old, joint, new));

        let anchor = self.stage.anchor(self.frame());
        let moved = anchor.distance(before.anchor(self.frame()));
        let resized = (self.stage.size() / before.size() - 1.0).abs() > 0.2;
        // In another unit, turned, or at another place, the camera would look at nothing.
        let lost = resized || before.up() != self.stage.up();
        if old.is_empty() || lost || (!self.settings.follow && moved > self.stage.size()) {
            self.aim = Aim::Begin;
        }
        self.warnings = warnings;
        self.unreadable.clear();
        self.name();
    }

    /// The file cannot be read as it is now, for this reason; what could be read of it before stays.
    pub fn cannot_read(&mut self, why: &str) {
        self.unreadable = why.lines().map(str::to_owned).collect();
    }

    /// Why the file cannot be read as it is now, line by line; nothing when it can.
    pub fn unreadable(&self) -> &[String] {
        &self.unreadable
    }

    /// What there is to say about the file.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The motion that is shown.
    pub fn stage(&self) -> &Arc<Stage> {
        &self.stage
    }

    /// The file's name, and how the motion is warped.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Which frame is shown, and how it plays.
    pub fn player(&self) -> &Player {
        &self.player
    }

    /// The frame to show, from 0.
    pub fn frame(&self) -> usize {
        self.player.frame()
    }

    /// The joint that the user looks at.
    pub fn selected(&self) -> Option<usize> {
        self.selected
    }

    /// Looks at this joint, if the skeleton has it, or at none.
    pub fn select(&mut self, joint: Option<usize>) {
        self.selected = joint.filter(|joint| *joint < self.stage.motion().skeleton().len());
    }

    /// Goes to `frame`, or to the last one.
    pub fn go_to(&mut self, frame: usize) {
        self.player.go_to(frame);
    }

    /// A line for the window's title bar.
    pub fn window_title(&self) -> String {
        let playing = if self.player.is_playing() { " · playing" } else { "" };
        let edited = match self.interpolated() {
            None => String::new(),
            Some(representation) if self.settings.edit.automatic => {
                format!(" · {} keyframes, {representation}", self.keyframe_count())
            }
            Some(representation) => format!(" · interpolated, {representation}"),
        };
        let count = self.stage.moving_frames();
        format!("{} · frame {} / {count}{edited}{playing}", self.title, self.frame())
    }

    /// Plays, or does not.
    pub fn set_playing(&mut self, playing: bool) {
        self.player.set_playing(playing);
    }

    /// Lets `seconds` pass.
    pub fn advance(&mut self, seconds: f64) {
        self.player.advance(seconds);
    }

    /// Does what a key asks for. [`Action::Quit`] and [`Action::NextMotion`] are not up to one motion.
    pub fn act(&mut self, action: Action) {
        let settings = &mut self.settings;
        match action {
            Action::Step(frames) => self.player.step(frames),
            Action::First => self.player.go_to(0),
            Action::Last => self.player.go_to(usize::MAX),
            Action::Play => self.player.toggle(),
            Action::Reverse => self.player.reverse(),
            Action::Slower => self.player.change_speed(false),
            Action::Faster => self.player.change_speed(true),
            Action::Loop => self.player.toggle_loop(),
            Action::RangeStart => self.player.begin_range(),
            Action::RangeEnd => self.player.end_range(),
            Action::Frame => self.aim = Aim::Everything,
            Action::Follow => {
                settings.follow = !settings.follow;
                self.offset = self.camera.target - self.stage.anchor(self.player.frame());
            }
            Action::Interpolate => settings.edit.next_representation(),
            Action::Automatic => settings.edit.toggle_automatic(),
            Action::Keyframes(by) => self.change_keyframes(by),
            Action::Beside => settings.edit.beside = !settings.edit.beside,
            Action::Errors => settings.edit.errors = !settings.edit.errors,
            Action::Plot => settings.edit.plot = !settings.edit.plot,
            Action::Ghost => settings.ghost = !settings.ghost,
            Action::Traces => settings.traces = !settings.traces,
            Action::Axes => settings.axes = !settings.axes,
            Action::Look => {
                settings.style = match settings.style {
                    Style::Lit => Style::Lines,
                    Style::Lines => Style::Lit,
                }
            }
            Action::Points => settings.points = !settings.points,
            Action::Help => settings.help = !settings.help,
            Action::NextJoint => self.select_next(1),
            Action::PreviousJoint => self.select_next(-1),
            Action::NoJoint => self.selected = None,
            Action::NextMotion | Action::Quit => {}
        }
    }

    fn select_next(&mut self, by: isize) {
        let count = self.stage.motion().skeleton().len();
        if count == 0 {
            return;
        }
        self.selected = Some(match self.selected {
            None if by > 0 => 0,
            None => count - 1,
            Some(joint) => (joint as isize + by).rem_euclid(count as isize) as usize,
        });
    }
}

/// Where the joint `joint` of `old` is among `new` joints: by its name, and where names occur twice by its place.
fn same_joint(old: &[Joint], joint: usize, new: &[Joint]) -> Option<usize> {
    let wanted = old.get(joint)?;
    let is_same = |other: &Joint| other.name == wanted.name && other.is_end_site == wanted.is_end_site;
    match new.get(joint).is_some_and(is_same) {
        true => Some(joint),
        false => new.iter().position(is_same),
    }
}
