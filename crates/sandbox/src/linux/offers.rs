//! Which layers this machine offers, each tried by running a program behind it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{Finding, Layer, Layers, Sandbox};

use super::user;

/// Tries each layer. `reads` are paths that programs will have to read.
pub fn offers(launcher: &Path, reads: &[PathBuf]) -> Vec<Finding> {
    let attempt = |layers: Layers| Sandbox::with_layers(launcher.to_path_buf(), layers).map(drop);
    let attempt = |layers: Layers| attempt(layers).map_err(|unavailable| unavailable.why);
    let base = Layers::of(&[Layer::Limits, Layer::Seccomp]);
    let namespaces = attempt(base.with(Layer::Namespaces));
    let own_user = if !user::is_root() {
        Err("only root can become another user".to_owned())
    } else if namespaces.is_ok() {
        attempt(base.with(Layer::Namespaces).with(Layer::OwnUser))
    } else {
        reachable(reads.iter().map(PathBuf::as_path).chain([launcher]))
            .and_then(|()| attempt(base.with(Layer::OwnUser)))
    };
    let found = [
        (Layer::Namespaces, namespaces),
        (Layer::OwnUser, own_user),
        (Layer::Cgroup, attempt(base.with(Layer::Cgroup))),
        (Layer::Landlock, attempt(base.with(Layer::Landlock))),
        (Layer::Seccomp, attempt(base)),
        (Layer::Limits, attempt(Layers::of(&[Layer::Limits]))),
    ];
    found.into_iter().map(|(layer, result)| finding(layer, result.err())).collect()
}

fn reachable<'a>(mut paths: impl Iterator<Item = &'a Path>) -> Result<(), String> {
    match paths.find_map(|path| Some((path, user::barrier(path)?))) {
        None => Ok(()),
        Some((path, barrier)) => {
            Err(format!("another user cannot reach {}: {} is shut", path.display(), barrier.display()))
        }
    }
}

fn finding(layer: Layer, problem: Option<String>) -> Finding {
    let remedy = problem.is_some().then(|| remedy(layer)).flatten();
    Finding { layer, available: problem.is_none(), problem, remedy }
}

/// What a person can do to get `layer` on this machine.
fn remedy(layer: Layer) -> Option<String> {
    let is_root = user::is_root();
    let text = match layer {
        Layer::Namespaces if is_root => {
            "Probably this is a container. Give it the right to mount (docker run --cap-add SYS_ADMIN --security-opt apparmor=unconfined), or use a virtual machine, or run as an ordinary user on the host."
        }
        Layer::Namespaces if is_on("kernel/apparmor_restrict_unprivileged_userns", "1") => {
            "Ubuntu's AppArmor refuses namespaces to ordinary users. To allow them until the next start: sudo sysctl kernel.apparmor_restrict_unprivileged_userns=0"
        }
        Layer::Namespaces if is_on("kernel/unprivileged_userns_clone", "0") => {
            "Namespaces are switched off for ordinary users. To allow them until the next start: sudo sysctl kernel.unprivileged_userns_clone=1"
        }
        Layer::Namespaces if is_on("user/max_user_namespaces", "0") => {
            "Namespaces are switched off for ordinary users. To allow them until the next start: sudo sysctl user.max_user_namespaces=10000"
        }
        Layer::Namespaces => {
            "It needs Linux 5.12 with user namespaces. In a container they are often refused: run on the host, or as root with the right to mount."
        }
        Layer::OwnUser if is_root && !has_all_users() => {
            "This container has too few user numbers: it runs without root on its host. Run it as root, or without a container."
        }
        Layer::OwnUser if is_root => {
            "Put the Rust toolchain and the folders in question where others may enter them (for example below /opt, mode 755), or allow namespaces."
        }
        Layer::Cgroup if is_root => {
            "Mount the control groups writable (in a container: --cgroupns=private and --privileged)."
        }
        // Nobody should become root for these two.
        Layer::OwnUser | Layer::Cgroup => return None,
        Layer::Landlock => {
            "It needs Linux 5.13, built with CONFIG_SECURITY_LANDLOCK and started with landlock among the lsm= modules. An old container runtime may also refuse it: update it."
        }
        Layer::Seccomp => "It needs a kernel with CONFIG_SECCOMP_FILTER, on x86-64, ARM 64 or RISC-V 64.",
        Layer::Limits => "Every Linux has these. Look for what refuses to start the program itself.",
    };
    Some(text.to_owned())
}

/// Whether this is no user namespace, or one with all users.
fn has_all_users() -> bool {
    let map = fs::read_to_string("/proc/self/uid_map").unwrap_or_default();
    map.split_whitespace().eq(["0", "0", "4294967295"])
}

fn is_on(name: &str, value: &str) -> bool {
    fs::read_to_string(Path::new("/proc/sys").join(name)).is_ok_and(|text| text.trim() == value)
}
