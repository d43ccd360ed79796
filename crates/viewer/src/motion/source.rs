//! A motion's files, and how they are to be read.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use parser::{acclaim, bvh};
use skeleton::acclaim::Columns;
use skeleton::{Channel, Joint, Motion, PositionChannels};
use thiserror::Error;

use crate::motion::bones::Bones;
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;
use crate::motion::upright::Up;

/// Where a motion comes from. It can be read again when a file has changed.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file: a BVH file, an Acclaim motion (`.amc`), or an Acclaim skeleton (`.asf`) by itself.
    pub path: PathBuf,
    /// The Acclaim skeleton that an Acclaim motion moves.
    pub skeleton: Option<PathBuf>,
    /// Frames per second of a motion whose file does not say so.
    pub rate: f64,
    /// What position channels do to OFFSETs.
    pub positions: PositionChannels,
    /// The axis that points up; `None` finds it out.
    pub up: Option<Up>,
    /// How the motion is warped, if it is.
    pub warp: Option<Warping>,
}

/// How a motion of any length is to be warped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Warping {
    /// How many frames the motion gets, or the stretch; `None` is twice as many as there are.
    pub frames: Option<usize>,
    /// The keyframes between which it is warped; `None` is the whole motion.
    pub keyframes: Option<(usize, usize)>,
}

/// Frames per second that most recordings in Acclaim files have. The files do not say it.
pub const USUAL_RATE: f64 = 120.0;

/// What a file held.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The motion.
    pub stage: Arc<Stage>,
    /// What is odd about the file.
    pub warnings: Vec<String>,
}

/// Why a motion cannot be shown.
#[derive(Debug, Error)]
pub enum Unreadable {
    /// No BVH file.
    #[error(transparent)]
    Bvh(#[from] bvh::FileError),
    /// No Acclaim file.
    #[error(transparent)]
    Acclaim(#[from] acclaim::FileError),
    /// Bones that cannot be shown as joints.
    #[error("{title}: {error}")]
    Bones {
        /// The file.
        title: String,
        /// Why.
        error: acclaim::ConvertError,
    },
    /// The motion has no frames, and so no keyframes between which it could be warped.
    #[error("{title}: there are no frames, and so nothing to warp")]
    NoFrames {
        /// The file.
        title: String,
    },
    /// The motion does not have the keyframes between which it is to be warped.
    #[error("{title}: between frames {0} and {1} there is nothing to warp: the motion has frames 0 to {last}", .keyframes.0, .keyframes.1)]
    Keyframes {
        /// The file.
        title: String,
        /// What was asked for.
        keyframes: (usize, usize),
        /// The last frame.
        last: usize,
    },
}

/// Whether a file's name ends in `.` and this, in upper or lower case.
pub fn ends_in(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending))
}

impl Source {
    /// The motion in the file `path`, as most are meant.
    pub fn new(path: impl Into<PathBuf>) -> Source {
        Source {
            path: path.into(),
            skeleton: None,
            rate: USUAL_RATE,
            positions: PositionChannels::Replace,
            up: None,
            warp: None,
        }
    }

    /// The file's name, for people and terminals.
    pub fn title(&self) -> String {
        let name = self.path.file_name().unwrap_or(self.path.as_os_str());
        parser::printable(&name.to_string_lossy())
    }

    /// All files that are read.
    pub fn files(&self) -> Vec<PathBuf> {
        [&self.path].into_iter().chain(&self.skeleton).cloned().collect()
    }

    /// Whether it is one of bones, in Acclaim files.
    pub fn has_bones(&self) -> bool {
        ends_in(&self.path, "asf") || ends_in(&self.path, "amc")
    }

    /// Reads the files.
    ///
    /// # Errors
    ///
    /// When they are no motion: with the place and what was expected there.
    pub fn read(&self) -> Result<Loaded, Unreadable> {
        let loaded = if self.has_bones() { self.read_bones()? } else { self.read_joints()? };
        match &self.warp {
            None => Ok(loaded),
            Some(warping) => self.warped(loaded, warping),
        }
    }

    /// The same, for a motion whose original was read just before: a warped one is made of that.
    ///
    /// # Errors
    ///
    /// When the files are no motion, or the motion has not the keyframes between which it is to be warped.
    pub fn read_behind(&self, original: Option<&Arc<Stage>>) -> Result<Loaded, Unreadable> {
        match (&self.warp, original) {
            (Some(warping), Some(original)) => {
                // What is odd about the file is told beside.
                self.warped(Loaded { stage: original.clone(), warnings: Vec::new() }, warping)
            }
            _ => self.read(),
        }
    }

    fn read_joints(&self) -> Result<Loaded, Unreadable> {
        let bvh::Reading { motion, warnings } = bvh::read_file(&self.path)?;
        let mut warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        if self.positions == PositionChannels::Replace && collapses(&motion) {
            warnings.push(COLLAPSED.into());
        }
        let stage = Arc::new(Stage::with_up(motion, self.positions, self.up));
        Ok(Loaded { stage, warnings })
    }

    fn read_bones(&self) -> Result<Loaded, Unreadable> {
        let file = self.skeleton.as_deref().unwrap_or(&self.path);
        let acclaim::SkeletonReading { skeleton, warnings } = acclaim::read_skeleton_file(file)?;
        let mut told: Vec<String> = warnings.iter().map(|warning| self.of_skeleton(warning)).collect();
        let motion = if self.skeleton.is_some() {
            let acclaim::MotionReading { motion, warnings } =
                acclaim::read_motion_file(&self.path, &skeleton)?;
            told.extend(warnings.iter().map(ToString::to_string));
            motion
        } else {
            skeleton::acclaim::Motion::new(Columns::new(skeleton), 0, Vec::new())
                .map_err(|error| self.bones(error.into()))?
        };
        let joints = acclaim::to_joints(&motion, 1.0 / self.rate).map_err(|error| self.bones(error))?;
        let bones = Bones::new(motion, joints.skeleton());
        let stage = Stage::with_up(joints, PositionChannels::Replace, self.up).with_bones(bones);
        Ok(Loaded { stage: Arc::new(stage), warnings: told })
    }

    /// A warning about the skeleton, whose file is another one than that of the motion.
    fn of_skeleton(&self, warning: &acclaim::Warning) -> String {
        match self.skeleton.as_ref().and_then(|skeleton| skeleton.file_name()) {
            Some(name) => format!("in {}, {warning}", parser::printable(&name.to_string_lossy())),
            None => warning.to_string(),
        }
    }

    fn bones(&self, error: acclaim::ConvertError) -> Unreadable {
        Unreadable::Bones { title: self.title(), error }
    }

    /// The same, warped.
    fn warped(&self, loaded: Loaded, warping: &Warping) -> Result<Loaded, Unreadable> {
        let old = loaded.stage.moving_frames();
        let Some(map) = warping.of(old) else {
            let keyframes = warping.keyframes.unwrap_or_default();
            return Err(match old.checked_sub(1) {
                Some(last) => Unreadable::Keyframes { title: self.title(), keyframes, last },
                None => Unreadable::NoFrames { title: self.title() },
            });
        };
        Ok(Loaded { stage: Arc::new(loaded.stage.warped(map)), ..loaded })
    }
}

impl Warping {
    /// The warp of a motion of `old` frames; `None` when it does not have the keyframes.
    pub fn of(&self, old: usize) -> Option<TimeMap> {
        let Some(keyframes) = self.keyframes else {
            let new = self.frames.unwrap_or(old.saturating_mul(2));
            return Some(TimeMap::Whole { old, new });
        };
        let new = self.frames.unwrap_or(keyframes.0.abs_diff(keyframes.1).saturating_mul(2));
        TimeMap::stretch(old, keyframes, new)
    }
}
const COLLAPSED: &str = "position channels put most joints upon their parents, as in files that add them to the OFFSETs: try --positions add";

/// Whether most position channels below the root hold next to nothing where there is an OFFSET.
fn collapses(motion: &Motion) -> bool {
    let frame = motion.frame(0);
    let moved = |joint: &&Joint| {
        let channels = joint.channels.iter().filter(|channel| matches!(channel, Channel::Position(_)));
        !joint.is_root() && channels.count() == 3 && joint.offset.length() > 0.0
    };
    let joints = motion.skeleton().joints().iter().zip(&frame.local_positions);
    let (mut all, mut lost) = (0, 0);
    for (joint, position) in joints.filter(|(joint, _)| moved(joint)) {
        all += 1;
        lost += usize::from(position.length() < 0.01 * joint.offset.length());
    }
    motion.frame_count() > 0 && all >= 3 && 2 * lost > all
}

/// What is shown in place of a file that could not be read yet: nothing.
pub fn nothing() -> Arc<Stage> {
    Arc::new(Stage::new(Motion::default(), PositionChannels::Replace))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use skeleton::Skeleton;

    use super::*;

    #[test]
    fn channels_that_are_meant_to_be_added_are_noticed() {
        let positions = ["Xposition", "Yposition", "Zposition"].map(|word| Channel::from_word(word).unwrap());
        let motion = |value: f32| {
            let mut skeleton = Skeleton::new();
            let mut parent = skeleton.add_joint(None, "r", Vec3::ZERO, positions).unwrap();
            for _ in 0..4 {
                parent = skeleton.add_joint(Some(parent), "j", Vec3::Y * 10.0, positions).unwrap();
            }
            Motion::new(skeleton, 1, 0.1, vec![value; 15]).unwrap()
        };
        assert!(collapses(&motion(0.0)));
        assert!(!collapses(&motion(10.0)));
        assert!(!collapses(&Motion::default()));
    }
}
