//! The skeleton and a summary of a motion, as text for the terminal.

mod bones;
mod joints;
mod numbers;
mod tree;

pub use numbers::{number, shortened};

use crate::motion::source::{Loaded, Source};
use crate::motion::time_map::TimeMap;
use crate::view::texts::write_warp;

/// What is printed of a motion: its name, its skeleton, a summary, and what is odd about the file. Of one that is warped, and
/// stands beside the original, only what is not the same.
pub fn report(source: &Source, loaded: &Loaded) -> String {
    let (title, motion) = (source.title(), loaded.stage.motion());
    if let Some(map) = loaded.stage.warp() {
        return format!("\n{}", warped(title, map, motion.playable_frame_time()));
    }
    let (tree, summary) = match loaded.stage.bones() {
        Some(bones) => (
            bones::tree(bones.motion().skeleton(), motion.skeleton()),
            bones::summary(source, bones.motion(), motion),
        ),
        None => (joints::tree(motion.skeleton()), joints::summary(motion)),
    };
    let warnings = match &loaded.warnings[..] {
        [] => "warnings         none\n".to_owned(),
        some => some.iter().map(|warning| format!("warning          {warning}\n")).collect(),
    };
    format!("{title}\n\n{tree}\n{summary}{warnings}")
}

/// What a time warp, with so many seconds from one frame to the next, makes of the motion `title`.
fn warped(mut title: String, map: TimeMap, seconds: f64) -> String {
    write_warp(&mut title, &map);
    let frames = map.frame_count();
    let facts = lines(&[
        ("frames", format!("{frames} ({})", numbering(frames))),
        ("duration", format!("{} s", number(frames as f64 * seconds, 2))),
    ]);
    format!("{title}\n\n{facts}")
}

/// One fact per line.
fn lines(facts: &[(&str, String)]) -> String {
    facts.iter().map(|(name, fact)| format!("{name:<16} {fact}\n")).collect()
}

/// How so many frames are numbered.
fn numbering(frames: usize) -> String {
    match frames {
        0 => "the file holds no frames: only the rest pose can be shown".into(),
        1 => "a single pose, frame 0".into(),
        _ => format!("numbered 0 to {}", frames - 1),
    }
}
