//! A motion's file, and how it is to be read.

use std::path::PathBuf;
use std::sync::Arc;

use parser::bvh;
use skeleton::{Channel, Joint, Motion, PositionChannels};

use crate::motion::stage::Stage;
use crate::motion::upright::Up;

/// Where a motion comes from. It can be read again when the file has changed.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file.
    pub path: PathBuf,
    /// What position channels do to OFFSETs.
    pub positions: PositionChannels,
    /// The axis that points up; `None` finds it out.
    pub up: Option<Up>,
}

/// What a file held.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The motion.
    pub stage: Arc<Stage>,
    /// What is odd about the file.
    pub warnings: Vec<String>,
}

impl Source {
    /// The file's name, for people and terminals.
    pub fn title(&self) -> String {
        let name = self.path.file_name().unwrap_or(self.path.as_os_str());
        parser::printable(&name.to_string_lossy())
    }

    /// Reads the file.
    ///
    /// # Errors
    ///
    /// When it is no motion: with the place and what was expected there.
    pub fn read(&self) -> Result<Loaded, bvh::FileError> {
        let bvh::Reading { motion, warnings } = bvh::read_file(&self.path)?;
        let mut warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        if self.positions == PositionChannels::Replace && collapses(&motion) {
            warnings.push(COLLAPSED.into());
        }
        let stage = Arc::new(Stage::with_up(motion, self.positions, self.up));
        Ok(Loaded { stage, warnings })
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
