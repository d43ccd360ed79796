//! The functions that edit the motion, where these are a student's.

use super::Facts;
use crate::live::package::Package;
use crate::live::student::Status;
use crate::scene::{Line, Panel};
use crate::view::app::Sister;

pub fn write(facts: &Facts, sister: &Sister, panel: &mut Panel) {
    let (standing, still) = (&sister.standing, facts.app.settings.still);
    let wanted = facts.app.wish().is_some();
    match &standing.status {
        Status::Compiling => panel.add(Line::Text, "compiling your functions…"),
        Status::Asking if wanted => panel.add(Line::Text, "asking your functions…"),
        Status::Failed(trouble) => {
            panel.add(Line::Trouble, &trouble.headline);
            trouble.details.iter().for_each(|line| panel.add(Line::Trouble, line));
            if facts.edited.is_none() {
                panel.add(Line::Text, "Only the original is shown.");
            }
            if !still {
                panel.add(Line::Text, "Mend it and save: this window follows.");
            }
        }
        Status::Asking | Status::Answered => {}
    }
    if !wanted {
        panel.add(Line::Text, "the original: the reference solution's figure");
        if !still {
            panel.add(Line::Quiet, hint(sister.package));
        }
    }
    let Some(edited) = facts.edited else { return };
    if !standing.current && edited.interpolated > 0 {
        panel.add(Line::Quiet, "pale: by your last version that worked");
    }
    let (kept, frames) = (edited.keyframes.len(), facts.app.stage().motion().frame_count());
    if sister.package == Package::Keyframes && facts.app.settings.edit.automatic && standing.current {
        let asked = facts.app.keyframe_count();
        match kept == asked {
            true => {}
            false if kept == frames => panel.add(Line::Trouble, "your reduce keeps all frames"),
            false => {
                panel.add(Line::Trouble, format_args!("your reduce keeps {kept} frames instead of {asked}"))
            }
        }
    }
}

/// What to press in order to see what the functions do.
fn hint(package: Package) -> &'static str {
    match package {
        Package::Keyframes => "press k: your functions choose the keyframes",
        Package::Fk | Package::Interpolation => "press i: your functions make the frames between",
    }
}
