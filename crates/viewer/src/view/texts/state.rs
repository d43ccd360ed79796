//! Which motion and frame is shown, whose functions move it, and what is wrong.

use glam::Vec3;

use super::number::Rounded;
use super::{Facts, bones, warped};
use crate::live::student::{Extra, Posed, Status};
use crate::motion::upright::Up;
use crate::scene::{Line, Panel};
use crate::view::app::Shown;

pub fn write(facts: &Facts, panel: &mut Panel) {
    panel.add(Line::Heading, facts.app.title());
    let unreadable = facts.app.unreadable();
    unreadable.iter().for_each(|line| panel.add(Line::Trouble, line));
    if facts.app.stage().motion().skeleton().is_empty() && !unreadable.is_empty() {
        return panel.add(Line::Text, "Mend the file and save it: this window follows.");
    }
    if !unreadable.is_empty() {
        panel.add(Line::Text, "The last state of the file that could be read stays.");
    }
    frame(facts, panel);
    super::warp::write(facts, panel);
    for warning in facts.app.warnings() {
        panel.add(Line::Trouble, warning);
    }
    let stage = facts.app.stage();
    if stage.is_too_coarse() {
        panel.add(
            Line::Trouble,
            "the coordinates in this file are too large for single precision: the figure is distorted",
        );
    }
    match stage.up() {
        Up::Y => {}
        Up::X => panel.add(Line::Quiet, "X is up in this file"),
        Up::Z => panel.add(Line::Quiet, "Z is up in this file"),
    }
    functions(facts, panel);
    undrawn(facts, panel);
    match facts.posed.filter(|_| facts.standing.is_none_or(|standing| standing.current)) {
        Some(Posed { extra: Extra::Angles { taken, available }, .. }) => angles(*taken, *available, panel),
        Some(Posed { extra: Extra::Bones(places), .. }) => bones::visited(facts, places, panel),
        Some(Posed { extra: Extra::Warp { given, place, bones }, .. }) => {
            warped::write(facts, (*given, *place, *bones), panel)
        }
        None => {}
    }
    bones::in_other_orders(facts, panel);
}

fn frame(facts: &Facts, panel: &mut Panel) {
    let (player, motion) = (facts.app.player(), facts.app.stage().motion());
    let seconds = motion.playable_frame_time();
    let count = match facts.app.stage().moving_frames() {
        0 if motion.skeleton().channel_count() == 0 => {
            return panel.add(Line::Trouble, "nothing in this file moves: its rest pose is shown");
        }
        0 => return panel.add(Line::Trouble, "this file has no frames: its rest pose is shown"),
        1 => return panel.add(Line::Text, "frame 0 / 1: only one frame, nothing to play"),
        count => count,
    };
    let (frame, time) = (player.frame(), player.frame() as f64 * seconds);
    match player.is_playing() {
        true if player.is_waiting() => {
            panel.add(Line::Text, format_args!("frame {frame} / {count}    {time:.2} s    at the end"));
        }
        true => panel.add(
            Line::Text,
            format_args!(
                "frame {frame} / {count}    {time:.2} s    {} frames per second",
                Rounded(1.0 / seconds)
            ),
        ),
        false if facts.app.settings.still => {
            panel.add(Line::Text, format_args!("frame {frame} / {count}    {time:.2} s"));
        }
        false => panel.add(Line::Text, format_args!("frame {frame} / {count}    {time:.2} s    paused")),
    }
    let speed = Rounded(player.speed());
    let backwards = if player.is_backwards() { ", backwards" } else { "" };
    let once = if player.is_looping() { "" } else { ", once" };
    let (first, last) = player.range();
    if player.has_range() {
        panel.add(Line::Quiet, format_args!("speed {speed}×{backwards}{once}, frames {first} to {last}"));
    } else if player.speed() != 1.0 || !backwards.is_empty() || !once.is_empty() {
        panel.add(Line::Quiet, format_args!("speed {speed}×{backwards}{once}"));
    }
}

fn functions(facts: &Facts, panel: &mut Panel) {
    if let Some(sister) = facts.app.sister() {
        return super::sister::write(facts, sister, panel);
    }
    // Whose an edited motion is, is told with it.
    if facts.edited.is_some() {
        return;
    }
    let Some(standing) = facts.standing else {
        return panel.add(Line::Text, "the reference solution's figure");
    };
    let shown = facts.solid.is_some();
    match &standing.status {
        Status::Compiling => panel.add(Line::Text, "compiling your functions…"),
        Status::Asking => panel.add(Line::Text, "asking your functions…"),
        Status::Answered => panel.add(Line::Text, "your functions' figure"),
        Status::Failed(trouble) => {
            panel.add(Line::Trouble, &trouble.headline);
            trouble.details.iter().for_each(|line| panel.add(Line::Trouble, line));
            if !shown {
                panel.add(Line::Text, "Only the goal is shown.");
            }
            if !facts.app.settings.still {
                panel.add(Line::Text, "Mend it and save: this window follows.");
            }
        }
    }
    if shown && !standing.current {
        panel.add(Line::Quiet, "pale: the figure of your last version that worked");
    }
}

/// What cannot be seen of the figure to look at.
fn undrawn(facts: &Facts, panel: &mut Panel) {
    let Some(pose) = facts.solid else { return };
    let whose = match facts.shown {
        Shown::Reference => "the",
        Shown::Student(_) => "your",
    };
    if warped::is_missing(facts) {
        let line = if warped::is_known_begun(facts, 2) { Line::Trouble } else { Line::Text };
        return panel.add(line, "your part 3 gives no such frame: not drawn");
    }
    let (joints, outside) = (pose.len(), facts.outside);
    if outside > 0 {
        let is_trouble = facts.standing.is_none() || facts.is_known_begun();
        panel.add(
            if is_trouble { Line::Trouble } else { Line::Text },
            format_args!(
                "{outside} of {whose} {joints} joints are outside of the picture: press f to see all"
            ),
        );
    }
    let (lost, of, what) = match facts.posed.and_then(|posed| posed.places()) {
        Some(places) => {
            let (lost, visited) = bones::lost(places);
            (lost, visited, "bones")
        }
        None => {
            let places = pose.transforms().iter().map(|transform| transform.position);
            (places.filter(|place: &Vec3| !place.is_finite()).count(), joints, "joints")
        }
    };
    if lost > 0 {
        panel.add(
            Line::Trouble,
            format_args!("NaN or infinity as the place of {lost} of {whose} {of} {what}: not drawn"),
        );
    }
}

/// Whether the student's functions take the right number of angles.
fn angles(taken: usize, available: usize, panel: &mut Panel) {
    match (taken, available) {
        (0, 1..) => panel.add(Line::Text, "part 1 takes no angles of the frame yet"),
        (taken, available) if taken != available => panel.add(
            Line::Trouble,
            format_args!(
                "part 1 takes {taken} angles of this frame, which holds {available}: each joint takes its own three, or none"
            ),
        ),
        _ => {}
    }
}
