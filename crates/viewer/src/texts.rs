//! The words in the window: what is shown, what is wrong, what the colours mean, what the keys do.

use glam::Vec3;
use skeleton::Pose;

use crate::app::Shown;
use crate::keys;
use crate::scene::{Corner, Line, Panel, Pool, Side, Tint};
use crate::stage::Stage;
use crate::student::Status;

/// What the words are about.
pub struct Facts<'a> {
    pub stage: &'a Stage,
    pub title: &'a str,
    pub warnings: &'a [String],
    pub frame: usize,
    pub playing: bool,
    pub shown: Shown<'a>,
    /// The figure to look at, when there is one.
    pub solid: Option<&'a Pose>,
    /// How many of its joints the picture does not show.
    pub outside: usize,
    pub ghost: bool,
    pub axes: bool,
    pub help: bool,
    /// Whether the picture is large enough for a legend.
    pub roomy: bool,
}

/// All texts, each in its corner.
pub fn panels(facts: &Facts, panels: &mut Pool<Panel>) {
    panels.clear();
    let mut add = |corner, lines: Vec<Words>| {
        let panel = panels.add();
        panel.begin(corner);
        lines.into_iter().for_each(|(line, text)| panel.add(line, text));
    };
    add(Corner::TopLeft, state(facts));
    if facts.help {
        add(Corner::TopLeft, help());
    } else {
        add(Corner::BottomRight, vec![(Line::Key("h"), "help".into())]);
        if facts.roomy {
            add(Corner::BottomLeft, legend(facts));
        }
    }
}

type Words = (Line, String);

fn state(facts: &Facts) -> Vec<Words> {
    let motion = facts.stage.motion();
    let mut lines = vec![(Line::Heading, facts.title.to_owned())];
    let seconds = motion.playable_frame_time();
    match motion.frame_count() {
        0 if motion.skeleton().channel_count() == 0 => {
            lines.push((Line::Trouble, "nothing in this file moves: its rest pose is shown".into()));
        }
        0 => lines.push((Line::Trouble, "this file has no frames: its rest pose is shown".into())),
        1 => lines.push((Line::Text, "frame 0 / 1: only one frame, nothing to play".into())),
        count => {
            let playing = match facts.playing {
                true => format!("playing, {} frames per second", rounded(1.0 / seconds)),
                false => "paused".into(),
            };
            let time = facts.frame as f64 * seconds;
            lines.push((Line::Text, format!("frame {} / {count}    {time:.2} s    {playing}", facts.frame)));
        }
    }
    lines.extend(facts.warnings.iter().map(|warning| (Line::Trouble, warning.clone())));
    if facts.stage.is_too_coarse() {
        lines.push((
            Line::Trouble,
            "the coordinates in this file are too large for single precision: the figure is distorted".into(),
        ));
    }
    lines.extend(functions(facts));
    lines.extend(undrawn(facts));
    lines.extend(angles(facts));
    lines
}

/// What cannot be seen of the figure to look at.
fn undrawn(facts: &Facts) -> Vec<Words> {
    let Some(pose) = facts.solid else { return Vec::new() };
    let whose = match facts.shown {
        Shown::Reference => "the",
        Shown::Student { .. } => "your",
    };
    let (joints, outside, lost) = (pose.len(), facts.outside, nowhere(pose));
    let mut lines = Vec::new();
    if outside > 0 {
        lines.push((
            Line::Trouble,
            format!("{outside} of {whose} {joints} joints are outside of the picture: press f to see all"),
        ));
    }
    if lost > 0 {
        lines.push((
            Line::Trouble,
            format!("NaN or infinity as the place of {lost} of {whose} {joints} joints: not drawn"),
        ));
    }
    lines
}

fn functions(facts: &Facts) -> Vec<Words> {
    let Shown::Student { status, .. } = facts.shown else {
        return vec![(Line::Text, "the reference solution's figure".into())];
    };
    let mut lines = Vec::new();
    match status {
        Status::Compiling => lines.push((Line::Text, "compiling your functions…".into())),
        Status::Asking => lines.push((Line::Text, "asking your functions…".into())),
        Status::Answered => lines.push((Line::Text, "your functions' figure".into())),
        Status::Failed(trouble) => {
            lines.push((Line::Trouble, trouble.headline.clone()));
            lines.extend(trouble.details.iter().map(|line| (Line::Trouble, line.clone())));
        }
    }
    lines
}

/// Whether the student's functions take the right number of angles.
fn angles(facts: &Facts) -> Option<Words> {
    let Shown::Student { posed: Some(posed), .. } = facts.shown else { return None };
    match (posed.taken, posed.available) {
        (0, 1..) => Some((Line::Text, "part 1 takes no angles of the frame yet".into())),
        (taken, available) if taken != available => Some((
            Line::Trouble,
            format!(
                "part 1 takes {taken} angles of this frame, which holds {available}: each joint takes its own three, or none"
            ),
        )),
        _ => None,
    }
}

fn legend(facts: &Facts) -> Vec<Words> {
    let mut lines = Vec::new();
    let mut add = |tint, text: &str| lines.push((Line::Legend(tint), text.to_owned()));
    add(Tint::Joint, "joint");
    if facts.stage.has_sides() {
        add(Tint::Bone(Side::Left), "left");
        add(Tint::Bone(Side::Right), "right");
    } else {
        add(Tint::Bone(Side::Middle), "bone");
    }
    if facts.axes {
        add(Tint::X, "local X axis");
        add(Tint::Y, "local Y axis");
        add(Tint::Z, "local Z axis");
    }
    if facts.ghost && matches!(facts.shown, Shown::Student { .. }) {
        add(Tint::Ghost, "the goal");
    }
    let cell = f64::from(facts.stage.ground().cell);
    lines.push((Line::Text, format!("grid: {} units of the file", rounded(cell))));
    lines
}

fn help() -> Vec<Words> {
    keys::help().map(|(name, help)| (Line::Key(name), help.to_owned())).collect()
}

/// How many joints have no place.
fn nowhere(pose: &Pose) -> usize {
    let places = pose.transforms().iter().map(|transform| transform.position);
    places.filter(|place: &Vec3| !place.is_finite()).count()
}

/// A number with at most three digits that matter behind the point.
fn rounded(number: f64) -> String {
    if !(1e-3..1e7).contains(&number.abs()) {
        return format!("{number:.0e}");
    }
    let digits = (2 - number.abs().max(1e-9).log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{number:.digits$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (number, text) in
            [(0.5, "0.5"), (20.0, "20"), (119.97, "120"), (29.97, "30"), (0.002, "0.002"), (2e11, "2e11")]
        {
            assert_eq!(rounded(number), text);
        }
        assert_eq!(rounded(59.94), "59.9");
        assert_eq!(rounded(1.0 / 0.0083333), "120");
    }
}
