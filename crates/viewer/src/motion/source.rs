//! A motion's file, and how it is to be read.

use std::path::PathBuf;
use std::sync::Arc;

use parser::bvh;
use skeleton::{Motion, PositionChannels};

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
        let stage = Arc::new(Stage::with_up(motion, self.positions, self.up));
        Ok(Loaded { stage, warnings: warnings.iter().map(ToString::to_string).collect() })
    }
}

/// What is shown in place of a file that could not be read yet: nothing.
pub fn nothing() -> Arc<Stage> {
    Arc::new(Stage::new(Motion::default(), PositionChannels::Replace))
}
