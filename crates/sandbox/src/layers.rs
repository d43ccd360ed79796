//! The layers of protection, by name.

use std::fmt;

use serde::{Deserialize, Serialize};

/// One layer of protection.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// A private root, and own processes, network and IPC.
    Namespaces,
    /// An unprivileged user per slot.
    OwnUser,
    /// Memory and tasks counted per slot.
    Cgroup,
    /// Files, TCP and signals refused by Landlock.
    Landlock,
    /// System calls refused by seccomp.
    Seccomp,
    /// Resource limits of the process.
    Limits,
}

impl Layer {
    /// All of them, from the outermost inwards.
    pub const ALL: [Layer; 6] =
        [Layer::Namespaces, Layer::OwnUser, Layer::Cgroup, Layer::Landlock, Layer::Seccomp, Layer::Limits];
}

impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Layer::Namespaces => "namespaces",
            Layer::OwnUser => "own user",
            Layer::Cgroup => "cgroup",
            Layer::Landlock => "landlock",
            Layer::Seccomp => "seccomp",
            Layer::Limits => "limits",
        })
    }
}

/// Which layers protect. Its text is stable: `namespaces, own user, cgroup, landlock, seccomp, limits`, with those left
/// out that are missing, or `unsandboxed`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Layers {
    /// See [`Layer::Namespaces`].
    pub namespaces: bool,
    /// See [`Layer::OwnUser`].
    pub own_user: bool,
    /// See [`Layer::Cgroup`].
    pub cgroup: bool,
    /// See [`Layer::Landlock`].
    pub landlock: bool,
    /// See [`Layer::Seccomp`].
    pub seccomp: bool,
    /// See [`Layer::Limits`].
    pub limits: bool,
}

impl Layers {
    /// Those of `layers`, and no other.
    pub fn of(layers: &[Layer]) -> Layers {
        layers.iter().fold(Layers::default(), |all, layer| all.with(*layer))
    }

    /// Whether `layer` is one of them.
    pub fn has(mut self, layer: Layer) -> bool {
        *self.flag(layer)
    }

    /// Whether these keep a hostile program in: other files, system calls and the use of resources are all covered.
    pub fn is_sandboxed(self) -> bool {
        (self.landlock || self.namespaces) && self.seccomp && self.limits
    }

    /// These, and `layer` as well.
    pub fn with(mut self, layer: Layer) -> Layers {
        *self.flag(layer) = true;
        self
    }

    fn flag(&mut self, layer: Layer) -> &mut bool {
        match layer {
            Layer::Namespaces => &mut self.namespaces,
            Layer::OwnUser => &mut self.own_user,
            Layer::Cgroup => &mut self.cgroup,
            Layer::Landlock => &mut self.landlock,
            Layer::Seccomp => &mut self.seccomp,
            Layer::Limits => &mut self.limits,
        }
    }
}

impl fmt::Display for Layers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<String> =
            Layer::ALL.into_iter().filter(|layer| self.has(*layer)).map(|layer| layer.to_string()).collect();
        // Limits alone keep nobody in.
        f.pad(&if names.is_empty() || *self == Layers::of(&[Layer::Limits]) {
            "unsandboxed".to_owned()
        } else {
            names.join(", ")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_is_stable() {
        assert_eq!(
            Layers::of(&Layer::ALL).to_string(),
            "namespaces, own user, cgroup, landlock, seccomp, limits"
        );
        assert_eq!(Layers::default().to_string(), "unsandboxed");
        assert_eq!(Layers::of(&[Layer::Limits]).to_string(), "unsandboxed");
        assert_eq!(Layers::of(&[Layer::Limits, Layer::Landlock]).to_string(), "landlock, limits");
    }

    #[test]
    fn a_jail_needs_files_calls_and_resources_covered() {
        let base = [Layer::Seccomp, Layer::Limits];
        assert!(!Layers::of(&base).is_sandboxed());
        assert!(Layers::of(&base).with(Layer::Landlock).is_sandboxed());
        assert!(Layers::of(&base).with(Layer::Namespaces).is_sandboxed());
        assert!(!Layers::of(&[Layer::Landlock, Layer::Limits]).is_sandboxed());
        assert!(!Layers::of(&[Layer::Landlock, Layer::Seccomp]).is_sandboxed());
    }
}
