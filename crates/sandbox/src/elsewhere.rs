//! Systems that this crate has no jail for.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::{Finding, Layer, Layers, Limits};

#[derive(Default)]
pub struct Resources {}

impl Resources {
    pub fn open(_launcher: &Path, layers: Layers) -> Result<Resources, String> {
        let possible = if cfg!(unix) { Layers::of(&[Layer::Limits]) } else { Layers::default() };
        if layers == possible { Ok(Resources {}) } else { Err(WHY.to_owned()) }
    }

    #[cfg(unix)]
    pub fn prepare(
        &self,
        _slot: u32,
        _confinement: &crate::Confinement,
        _spec: &mut crate::unix::spec::Spec,
    ) -> std::io::Result<()> {
        Ok(())
    }

    pub fn killed_for_memory(&self, _slot: u32, _limits: &Limits) -> bool {
        false
    }
}

pub fn check_arguments(_layers: Layers) -> Option<Vec<OsString>> {
    None
}

const WHY: &str = "only Linux has this";

pub fn offers(_launcher: &Path, _reads: &[PathBuf]) -> Vec<Finding> {
    let finding = |layer: Layer| {
        let available = cfg!(unix) && layer == Layer::Limits;
        let remedy = "Run in a virtual machine or a container with Linux.".to_owned();
        Finding {
            layer,
            available,
            problem: (!available).then(|| WHY.to_owned()),
            remedy: (!available).then_some(remedy),
        }
    };
    Layer::ALL.into_iter().map(finding).collect()
}
