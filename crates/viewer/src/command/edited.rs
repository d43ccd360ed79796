//! Motions as they are edited, for pictures: everything is asked before anything is drawn.

use std::path::Path;
use std::sync::Arc;

use crate::edit::{NotEdited, ReferenceHand};
use crate::live::board::Board;
use crate::live::package::Package;
use crate::live::sister::Now;
use crate::live::student::{Standing, Status};
use crate::live::version::Version;
use crate::live::worker::{self, Trouble};
use crate::view::app::{App, Sister};
use crate::view::gallery::Gallery;

/// Edits all motions as their settings say, by the reference.
pub fn by_reference(gallery: &mut Gallery) {
    for app in gallery.apps_mut() {
        app.edit(&mut ReferenceHand::default());
        tell_refusal(app);
    }
}

/// Edits all motions as their settings say, with the student's functions of the exercise `package` in their part of it, and
/// says in the terminal what is wrong with them.
pub fn by_student(package: Package, workspace: &Path, gallery: &mut Gallery) {
    let version = Version::default();
    let built = worker::compile(package, workspace, &version).map_err(Arc::new);
    if let Err(trouble) = &built {
        tell(trouble);
    }
    let graded = built.as_ref().ok().map(|program| Board::of(&mut program.silent_worker(), package));
    let board = graded.map(Arc::new);
    for app in gallery.apps_mut() {
        let trouble = match &built {
            Err(trouble) => Some(Arc::clone(trouble)),
            Ok(program) => {
                let mut student =
                    Now::new(package, &version, program.worker(), Box::new(ReferenceHand::default()));
                app.edit(student.hand());
                tell_refusal(app);
                let trouble = student.trouble();
                trouble.iter().for_each(|trouble| tell(trouble));
                trouble
            }
        };
        let current = trouble.is_none();
        let status = trouble.map_or(Status::Answered, Status::Failed);
        let standing = Standing { status, current, board: board.clone(), former: None, grading: false };
        app.show_sister(Some(Sister { package, standing }));
    }
}

/// Says in the terminal why a motion is not edited, where that is not up to a student's functions: a picture may have no
/// words.
fn tell_refusal(app: &App) {
    let failure = app.editing().and_then(|editing| editing.failure.as_deref());
    if let Some(failure) = failure.filter(|failure| !matches!(failure, NotEdited::Failed(_))) {
        eprintln!("{}: only the original is shown: {failure}", app.title());
    }
}

fn tell(trouble: &Trouble) {
    super::tell(trouble, "only the original is shown");
}
