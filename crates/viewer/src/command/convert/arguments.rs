//! The options about motions as files.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::command::keyframes::MEANINGLESS;
use crate::command::targets::Target;
use crate::motion::source::ends_in;

/// A motion as another file.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "New motions")]
pub struct OutArguments {
    /// Writes the motion as another file, and opens no window: as .bvh, as .amc with its skeleton in an .asf beside it, or
    /// that .asf alone; warped with --warp. From .bvh to .bvh, and with --keyframes, it is reduced to keyframes and all frames
    /// between them are interpolated, so that every program plays it
    #[arg(long, value_name = "MOTION", group = "reduction")]
    out: Option<PathBuf>,

    /// Lets --out take the place of files that are there already, though never of FILE
    #[arg(long, requires = "out", conflicts_with_all = MEANINGLESS)]
    overwrite: bool,
}

/// What a new file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Format {
    /// Joints and their motion.
    Bvh,
    /// A motion of bones, and in the other file these bones.
    Amc {
        /// The file with the bones.
        skeleton: PathBuf,
    },
    /// Bones alone.
    Asf,
}

impl OutArguments {
    /// What is to be written; empty when nothing is said about it.
    pub fn targets(&self) -> Vec<Target<'_>> {
        let Some(path) = self.path() else { return Vec::new() };
        let target = |path, what, endings| Target {
            path,
            option: "--out",
            what,
            endings,
            may_replace: self.overwrite,
        };
        let mut targets = vec![target(path.into(), "new motion", &["bvh", "amc", "asf"][..])];
        if let Format::Amc { skeleton } = Format::of(path) {
            targets.push(target(skeleton.into(), "new skeleton", &["asf"]));
        }
        targets
    }

    /// Where the motion goes.
    pub fn path(&self) -> Option<&Path> {
        self.out.as_deref()
    }
}

impl Format {
    /// That of a file with this name.
    pub fn of(path: &Path) -> Format {
        match path {
            path if ends_in(path, "amc") => Format::Amc { skeleton: path.with_extension("asf") },
            path if ends_in(path, "asf") => Format::Asf,
            _ => Format::Bvh,
        }
    }
}
