//! The functions that edit the motion, where these are a student's.

use super::Facts;
use crate::edit::{Edited, Keys};
use crate::live::package::Package;
use crate::live::student::Status;
use crate::scene::{Line, Panel};
use crate::view::app::Sister;

pub fn write(facts: &Facts, sister: &Sister, panel: &mut Panel) {
    let (app, still) = (facts.app, facts.app.settings.still);
    let works = app.editing().is_some_and(|editing| editing.progress.is_some());
    match &sister.standing.status {
        Status::Compiling => panel.add(Line::Text, "compiling your functions…"),
        Status::Asking if works => panel.add(Line::Text, "asking your functions…"),
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
    if app.editing().is_none() {
        panel.add(Line::Text, "the original: the reference solution's figure");
        if !still {
            panel.add(Line::Quiet, hint(sister.package));
        }
    }
    match facts.edited {
        Some(edited) if app.is_outdated() && edited.interpolated > 0 => {
            panel.add(Line::Quiet, "pale: by your last version that worked");
        }
        Some(edited) if !app.is_outdated() && sister.package == Package::Keyframes => {
            count(facts, edited, panel);
        }
        _ => {}
    }
}

/// Whether there is nothing to tell of an edited motion, because the functions cannot be asked or gave no answer.
pub fn has_told_all(facts: &Facts) -> bool {
    let failed = |sister: &Sister| matches!(sister.standing.status, Status::Failed(_));
    facts.edited.is_none() && facts.app.sister().is_some_and(failed)
}

/// What to press in order to see what the functions do.
fn hint(package: Package) -> &'static str {
    match package {
        Package::Keyframes => "press k: your functions choose the keyframes",
        _ => "press i: your functions make the frames between",
    }
}

/// Whether there are as many keyframes as were wanted.
fn count(facts: &Facts, edited: &Edited, panel: &mut Panel) {
    let Keys::Automatic(wanted) = edited.wish.keys else { return };
    let (kept, frames) = (edited.keyframes.len(), facts.app.stage().moving_frames());
    if kept == wanted {
        return;
    }
    match kept == frames {
        // That is what they do before they are begun.
        true => panel.add(Line::Text, "your reduce keeps all frames as keyframes"),
        false => {
            panel.add(Line::Trouble, format_args!("your reduce keeps {kept} keyframes instead of {wanted}"))
        }
    }
}
