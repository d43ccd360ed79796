//! What the launcher is told in one argument.
#![cfg_attr(not(target_os = "linux"), allow(dead_code))] // Other systems need a part of it.

use std::ffi::{OsStr, OsString};
use std::os::unix::ffi::{OsStrExt, OsStringExt};
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use serde::{Deserialize, Serialize};

use crate::{Confinement, Layers};

/// What the launcher is told. Paths are bytes: not every path is text.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Spec {
    /// The layers to set up: all of them, or the program does not start.
    pub layers: Layers,
    /// The process that starts the launcher. When it ends, all ends.
    pub parent: u32,
    program: Vec<u8>,
    read: Vec<Vec<u8>>,
    folder: Option<Vec<u8>>,
    /// Whole seconds.
    pub cpu: u64,
    /// Bytes of address space.
    pub memory: u64,
    /// Bytes of one file.
    pub file_size: u64,
    /// How many tasks the program's user may have, where that is a useful number.
    pub tasks: Option<u64>,
    /// The user and group that the program runs as, if not the launcher's.
    pub user: Option<u32>,
    /// Files of the control groups that the launcher joins by writing 0 to each.
    cgroups: Vec<Vec<u8>>,
    /// Numbers of the parent's descriptors of the namespaces to enter, in this order.
    pub namespaces: Vec<i32>,
}

impl Spec {
    pub fn new(layers: Layers, confinement: &Confinement, program: &Path) -> Spec {
        let limits = &confinement.limits;
        Spec {
            layers,
            parent: std::process::id(),
            program: bytes(program),
            read: confinement.read.iter().map(|path| bytes(path)).collect(),
            folder: confinement.folder.as_deref().map(bytes),
            cpu: limits.cpu.as_secs().saturating_add(u64::from(limits.cpu.subsec_nanos() > 0)),
            memory: limits.memory,
            file_size: limits.file_size,
            tasks: None,
            user: None,
            cgroups: Vec::new(),
            namespaces: Vec::new(),
        }
    }

    pub fn program(&self) -> &Path {
        path(&self.program)
    }

    pub fn read(&self) -> impl Iterator<Item = &Path> {
        self.read.iter().map(|bytes| path(bytes))
    }

    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref().map(path)
    }

    pub fn cgroups(&self) -> impl Iterator<Item = &Path> {
        self.cgroups.iter().map(|bytes| path(bytes))
    }

    pub fn join_cgroups(&mut self, files: &[PathBuf]) {
        self.cgroups = files.iter().map(|file| bytes(file)).collect();
    }

    /// As one argument: letters, digits, `-` and `_`.
    pub fn encode(&self) -> Result<OsString, postcard::Error> {
        Ok(URL_SAFE_NO_PAD.encode(postcard::to_stdvec(self)?).into())
    }

    pub fn decode(argument: &OsStr) -> Option<Spec> {
        let bytes = URL_SAFE_NO_PAD.decode(argument.as_bytes()).ok()?;
        postcard::from_bytes(&bytes).ok()
    }
}

fn bytes(path: &Path) -> Vec<u8> {
    path.as_os_str().to_owned().into_vec()
}

fn path(bytes: &[u8]) -> &Path {
    Path::new(OsStr::from_bytes(bytes))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::{Layer, Limits};

    #[test]
    fn what_is_told_is_understood() {
        let limits = Limits {
            cpu: Duration::from_millis(1500),
            wall: Duration::MAX,
            memory: u64::MAX,
            threads: 3,
            output: 4,
            file_size: 5,
        };
        let odd = PathBuf::from(OsString::from_vec(b"/not text \xff\n".to_vec()));
        let folder = Some(PathBuf::from("/with spaces"));
        let confinement =
            Confinement { read: vec![odd.clone(), "/b".into()], folder, environment: Vec::new(), limits };
        let layers = Layers::of(&[Layer::Cgroup, Layer::Seccomp]);
        let mut told = Spec::new(layers, &confinement, Path::new("/program"));
        told.namespaces = vec![7, 8];
        told.join_cgroups(&[PathBuf::from("/sys/tasks")]);
        let heard = Spec::decode(&told.encode().unwrap()).unwrap();
        assert_eq!(format!("{told:?}"), format!("{heard:?}"));
        assert_eq!(heard.layers, layers);
        assert_eq!(heard.read().collect::<Vec<_>>(), [odd.as_path(), Path::new("/b")]);
        assert_eq!((heard.cpu, heard.memory), (2, u64::MAX));
    }

    #[test]
    fn nonsense_is_not() {
        for text in ["", "A", "AAAA", "not base64!", "////"] {
            assert!(Spec::decode(OsStr::new(text)).is_none(), "{text}");
        }
    }
}
