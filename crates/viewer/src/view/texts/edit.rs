//! What is interpolated, how far it is off, and whose work it is.

use skeleton::Representation;

use super::Facts;
use super::number::Rounded;
use crate::edit::{Edited, Maker, Makers, NotEdited};
use crate::scene::{Line, Panel};
use crate::view::app::Editing;

/// So many pictures may come without a result before that is told: words that come and go at once would flicker.
const PATIENCE: u32 = 15;

pub fn write(facts: &Facts, editing: &Editing, panel: &mut Panel) {
    let settings = &facts.app.settings;
    let Some(representation) = settings.edit.interpolated() else { return };
    heading(facts, panel);
    // Why a student's functions gave no answer is told with them.
    let told = |failure: &NotEdited| facts.app.sister().is_some() && matches!(failure, NotEdited::Failed(_));
    if let Some(failure) = editing.failure.as_ref().filter(|failure| !told(failure)) {
        panel.add(Line::Trouble, failure);
        if matches!(**failure, NotEdited::TooLong { .. }) && !settings.still {
            panel.add(Line::Text, "[ and ] set a stretch, i interpolates it (k must be off)");
        }
    }
    match &editing.edited {
        Some(edited) => {
            maker(facts, representation, edited.makers, panel);
            errors(facts, edited, panel);
        }
        None if editing.failure.is_none() => panel.add(Line::Text, format_args!("by {representation}")),
        None => {}
    }
    match editing.progress.filter(|_| editing.waited > PATIENCE) {
        Some((done, of)) if of > 0 => {
            panel.add(Line::Quiet, format_args!("calculating… {} %", 100 * done.min(of) / of));
        }
        Some(_) => panel.add(Line::Quiet, "calculating…"),
        None => {}
    }
    if settings.edit.plot && !facts.has_room_for_plot() {
        let what = if settings.still { "picture" } else { "window" };
        panel.add(Line::Quiet, format_args!("the plot needs a larger {what}"));
    }
    if editing.stale
        && editing.edited.is_some()
        && editing.failure.as_ref().is_some_and(|failure| !told(failure))
    {
        panel.add(Line::Quiet, "the last result stays");
    }
}

/// What the user has to do first, when something is to be shown that there is not.
pub fn write_hint(facts: &Facts, panel: &mut Panel) {
    let what = match (facts.app.settings.edit.errors, facts.app.settings.edit.plot) {
        (true, true) => "error vectors and the plot",
        (true, false) => "error vectors",
        _ => "the plot",
    };
    panel.add(Line::Quiet, format_args!("for {what}, edit the motion: press i or k"));
}

fn heading(facts: &Facts, panel: &mut Panel) {
    let (app, frames) = (facts.app, facts.app.stage().moving_frames());
    let ((start, end), automatic) = (app.ends(), app.settings.edit.automatic);
    match frames {
        0 => panel.add(Line::Heading, "no frames to interpolate"),
        1 => panel.add(Line::Heading, "one frame: nothing to interpolate"),
        _ if automatic && app.keyframe_count() == frames => {
            panel.add(Line::Heading, format_args!("all {frames} frames are keyframes"));
        }
        _ if automatic => {
            panel.add(Line::Heading, format_args!("{} keyframes of {frames} frames", app.keyframe_count()));
        }
        _ if end - start < 2 => {
            panel.add(Line::Heading, format_args!("no frames between {start} and {end}"));
            if !app.settings.still {
                panel.add(Line::Text, "[ and ] set the stretch to interpolate");
            }
        }
        _ => panel
            .add(Line::Heading, format_args!("frames {start} to {end}: {} interpolated", end - start - 1)),
    }
}

fn maker(facts: &Facts, representation: Representation, makers: Makers, panel: &mut Panel) {
    let whose = match (makers.keyframes, makers.between) {
        (Maker::Reference, Maker::Reference) if !facts.is_roomy() => "by the reference solution",
        (Maker::Reference, Maker::Reference) => "interpolated by the reference solution",
        (Maker::Reference, Maker::Student) => "interpolated by your functions",
        (Maker::Student, Maker::Reference) => "keyframes by your functions",
        (Maker::Student, Maker::Student) => "all by your functions",
    };
    panel.add(Line::Text, format_args!("{representation}, {whose}"));
}

fn errors(facts: &Facts, edited: &Edited, panel: &mut Panel) {
    if edited.interpolated == 0 {
        return;
    }
    let (error, distance) = (Rounded(edited.error), Rounded(edited.distance));
    if !facts.is_roomy() {
        return panel.add(Line::Text, format_args!("{distance} units off, error {error} units²"));
    }
    panel.add(Line::Key("error"), format_args!("{error} units², in all frames"));
    panel.add(Line::Key("tips"), format_args!("{distance} units off (root mean square)"));
    let frame = facts.app.frame();
    if edited.pose(frame).is_some() {
        panel.add(Line::Key("here"), format_args!("{} units²", Rounded(edited.error_of(frame))));
    } else if edited.keyframes.binary_search(&frame).is_ok() {
        panel.add(Line::Key("here"), "a keyframe: as in the original");
    } else {
        panel.add(Line::Key("here"), "outside of the stretch: as in the original");
    }
}
