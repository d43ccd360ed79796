//! A program that looks from the inside whether the layers hold. The launcher is that program too.

use std::ffi::{OsStr, OsString};
use std::net::UdpSocket;
use std::path::Path;
use std::process::exit;
use std::{fs, thread};

use nix::sys::resource::{Resource, getrlimit};

use crate::{Layer, Layers};

use super::user::is_root;

/// The launcher's argument when it is to look around.
const CHECK: &str = "--check-sandbox";

/// The arguments with which the launcher looks whether `layers` hold.
pub fn arguments(layers: Layers) -> Option<Vec<OsString>> {
    let names =
        Layer::ALL.into_iter().filter(|layer| layers.has(*layer)).map(|layer| layer.to_string().into());
    Some([OsString::from(CHECK)].into_iter().chain(names).collect())
}

pub fn check_if_asked(first: &OsStr, layers: impl Iterator<Item = OsString>) {
    if first != CHECK {
        return;
    }
    for name in layers {
        let layer = Layer::ALL.into_iter().find(|layer| *layer.to_string() == name);
        if !layer.is_some_and(holds) {
            eprintln!("{} is set up, but does not hold", name.display());
            exit(1);
        }
    }
    // What honest programs need.
    if thread::Builder::new().spawn(|| ()).is_ok_and(|thread| thread.join().is_ok()) {
        exit(0);
    }
    eprintln!("a confined program cannot start a thread");
    exit(1);
}

fn holds(layer: Layer) -> bool {
    match layer {
        Layer::Namespaces => !Path::new("/etc").exists() && !Path::new("/proc/self/status").exists(),
        Layer::OwnUser => !is_root(),
        // To be seen from outside only: who cannot join does not start.
        Layer::Cgroup => true,
        Layer::Landlock => fs::read_dir("/").is_err(),
        Layer::Seccomp => UdpSocket::bind("0.0.0.0:0").is_err(),
        Layer::Limits => getrlimit(Resource::RLIMIT_MEMLOCK).is_ok_and(|(_, most)| most == 0),
    }
}
