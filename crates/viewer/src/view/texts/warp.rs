//! How a motion is warped.

use std::fmt::{self, Write};

use super::Facts;
use super::number::{Rounded, count};
use crate::motion::time_map::TimeMap;
use crate::scene::{Line, Panel};

/// Adds to a file's name what the warp makes of the motion.
pub fn write_title(title: &mut String, map: &TimeMap) {
    let (new, old) = map.speed();
    // A string takes whatever is written to it.
    let _ = match *map {
        TimeMap::Whole { old: 0, .. } => write!(title, ", no frames to warp"),
        TimeMap::Whole { .. } => write!(title, ", {old} → {}", count(new, "frame", "frames")),
        TimeMap::Stretch { first, last, .. } => write!(title, ", frames {first}–{last}: {old} → {new}"),
    };
}

/// Where the shown frame is in the original, and how much slower the motion is.
pub fn write(facts: &Facts, panel: &mut Panel) {
    let Some(map) = facts.app.time_map().filter(|map| map.frame_count() > 0) else { return };
    let (place, speed) = (map.position(facts.app.frame()), Speed(map));
    match map {
        TimeMap::Whole { .. } => {
            panel.add(Line::Text, format_args!("= frame {place:.2} of the original, {speed}"));
        }
        TimeMap::Stretch { first, last, .. } => {
            panel.add(Line::Text, format_args!("= frame {place:.2} of the original"));
            panel.add(Line::Text, format_args!("{speed} between its frames {first} and {last}"));
        }
    }
}

/// How much slower or faster time passes where it is warped, in words.
struct Speed(TimeMap);

impl fmt::Display for Speed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (new, old) = self.0.speed();
        match () {
            () if new == old => f.write_str("as fast"),
            () if new > old => write!(f, "{}× slower", Rounded(new as f64 / old as f64)),
            () => write!(f, "{}× faster", Rounded(old as f64 / new as f64)),
        }
    }
}
