//! The layers as Linux has them.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::Path;

use crate::unix::spec::Spec;
use crate::{Confinement, Layers, Limits};

mod cgroup;
mod check;
mod confine;
mod landlock_rules;
mod namespaces;
mod offers;
mod private_root;
mod system_calls;
mod user;

pub use check::arguments as check_arguments;
pub use confine::confine;
pub use offers::offers;

use cgroup::Cgroups;
use namespaces::Namespaces;
use user::Users;

/// What is set up once and used by every program.
#[derive(Default)]
pub struct Resources {
    namespaces: Option<Namespaces>,
    cgroups: Option<Cgroups>,
    users: Option<Users>,
    tasks: Option<u64>,
}

impl Resources {
    pub fn open(launcher: &Path, layers: Layers) -> Result<Resources, String> {
        // The launcher waits outside of the process namespace, but in the same groups.
        let waiting = u32::from(layers.namespaces);
        Ok(Resources {
            namespaces: layers.namespaces.then(|| Namespaces::open(launcher)).transpose()?,
            cgroups: layers.cgroup.then(|| Cgroups::open(waiting)).transpose()?,
            users: layers.own_user.then(Users::pick),
            tasks: (!layers.namespaces).then(user::task_limit),
        })
    }

    /// Fills in what depends on the slot, and gives the slot its folder.
    pub fn prepare(&self, slot: u32, confinement: &Confinement, spec: &mut Spec) -> io::Result<()> {
        let layers = spec.layers;
        let threads = u64::from(confinement.limits.threads);
        if let Some(namespaces) = &self.namespaces {
            spec.namespaces = namespaces.descriptors();
        }
        if let Some(cgroups) = &self.cgroups {
            spec.join_cgroups(&cgroups.files(slot, &confinement.limits)?);
        }
        if let Some(users) = &self.users {
            let user = users.of_slot(slot)?;
            user::give_folder(confinement, user, layers.namespaces)?;
            spec.user = Some(user);
            spec.tasks = Some(threads);
        } else if layers.namespaces && !user::is_root() {
            // Counted in the program's own user namespace.
            spec.tasks = Some(threads);
        } else {
            spec.tasks = self.tasks;
        }
        Ok(())
    }

    /// Whether the system has ended a program of this slot since the last call, to get memory back.
    pub fn killed_for_memory(&self, slot: u32, limits: &Limits) -> bool {
        self.cgroups.as_ref().is_some_and(|cgroups| cgroups.killed(slot, limits))
    }
}

/// The roles of the launcher that only Linux has.
pub fn enter_if_asked(first: &OsStr, arguments: impl Iterator<Item = OsString>) {
    namespaces::hold_if_asked(first);
    check::check_if_asked(first, arguments);
}
