//! The machines and users that a sandbox meets, imitated on this one.

use std::collections::BTreeMap;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::Arc;
use std::{env, fs, io};

use libtest_mimic::{Arguments, Failed, Trial, run};
use nix::unistd::geteuid;
use sandbox::{Layer, Layers, Sandbox, Unavailable, system_libraries};
use seccompiler::{BpfProgram, SeccompAction, SeccompFilter, SeccompRule, apply_filter};

use crate::{cases, judge};

/// The folder beside the judge in which the toolchain lies.
pub const TOOLCHAIN: &str = "toolchain";

/// A user without rights.
const NOBODY: u32 = 54_321;

/// Who runs the sandbox, and on what kind of machine.
pub struct Mode {
    pub name: &'static str,
    needs_root: bool,
    /// Root plays the ordinary user by becoming one.
    is_user: bool,
    /// As in a container, or where an administrator has switched namespaces off.
    no_namespaces: bool,
    /// What must be found; the layers to ask for, if the machine offers more.
    layers: &'static [Layer],
    asks: bool,
}

use Layer::{Cgroup, Landlock, Limits, Namespaces, OwnUser, Seccomp};

pub const MODES: [Mode; 6] = [
    Mode {
        name: "root",
        needs_root: true,
        is_user: false,
        no_namespaces: false,
        layers: &[Namespaces, OwnUser, Cgroup, Landlock, Seccomp, Limits],
        asks: false,
    },
    Mode {
        name: "root in a container",
        needs_root: true,
        is_user: false,
        no_namespaces: true,
        layers: &[OwnUser, Cgroup, Landlock, Seccomp, Limits],
        asks: false,
    },
    Mode {
        name: "root in a container, toolchain out of reach",
        needs_root: true,
        is_user: false,
        no_namespaces: true,
        layers: &[Cgroup, Landlock, Seccomp, Limits],
        asks: true,
    },
    Mode {
        name: "root on a kernel without Landlock",
        needs_root: true,
        is_user: false,
        no_namespaces: false,
        layers: &[Namespaces, OwnUser, Cgroup, Seccomp, Limits],
        asks: true,
    },
    Mode {
        name: "user",
        needs_root: false,
        is_user: true,
        no_namespaces: false,
        layers: &[Namespaces, Landlock, Seccomp, Limits],
        asks: false,
    },
    Mode {
        name: "user without namespaces",
        needs_root: false,
        is_user: true,
        no_namespaces: true,
        layers: &[Landlock, Seccomp, Limits],
        asks: false,
    },
];

impl Mode {
    pub fn named(name: &str) -> &'static Mode {
        MODES.iter().find(|mode| mode.name == name).unwrap()
    }

    fn layers(&self) -> Layers {
        Layers::of(self.layers)
    }

    /// Some desktops let a user have control groups.
    pub fn possible_layers(&self) -> [Layers; 2] {
        let layers = self.layers();
        [layers, if self.is_user { layers.with(Cgroup) } else { layers }]
    }

    pub fn has(&self, layer: Layer) -> bool {
        self.layers().has(layer)
    }

    /// Makes this process find the machine that the mode is about.
    pub fn imitate(&self) {
        if self.no_namespaces {
            refuse_namespaces();
        }
    }

    /// The sandbox as a user gets it.
    pub fn sandbox(&self) -> Result<Sandbox, Unavailable> {
        let launcher = env::current_exe().unwrap();
        if self.asks {
            Sandbox::with_layers(launcher, self.layers())
        } else {
            Sandbox::strongest(launcher, &system_libraries())
        }
    }

    /// A process that judges one case in this mode.
    fn judge(&self, program: &Path, case: &str) -> Command {
        let mut command = Command::new(program);
        command.args([judge::ROLE, self.name, case]);
        if self.is_user && geteuid().is_root() {
            command.uid(NOBODY).gid(NOBODY);
        }
        command
    }

    /// Why this mode cannot be tried on this machine.
    fn obstacle(&self, program: &Path) -> Option<String> {
        if self.needs_root && !geteuid().is_root() {
            return Some("only root can try it".to_owned());
        }
        let found = self.judge(program, judge::LAYERS).output().unwrap();
        let found = String::from_utf8_lossy(&found.stdout);
        let wanted = self.layers().to_string();
        (found.trim() != wanted)
            .then(|| format!("it needs `{wanted}`, this machine offers `{}`", found.trim()))
    }
}

/// Runs every case in every mode.
pub fn run_all() -> ExitCode {
    let arguments = Arguments::from_args();
    // Where every user can reach it.
    let folder = tempfile::Builder::new().prefix("sandbox test ").tempdir_in("/tmp").unwrap();
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).unwrap();
    let program = folder.path().join("attacks");
    fs::copy(env::current_exe().unwrap(), &program).unwrap();

    // Should the compiler lie in a home that is shut, then it has another name here.
    let toolchain = folder.path().join(TOOLCHAIN);
    let can_compile = link_toolchain(&toolchain);

    let obstacles: BTreeMap<&str, String> =
        MODES.iter().filter_map(|mode| Some((mode.name, mode.obstacle(&program)?))).collect();
    let program: Arc<PathBuf> = program.into();
    let mut trials = Vec::new();
    for mode in &MODES {
        for case in cases::names() {
            let cannot_run =
                obstacles.contains_key(mode.name) || case == cases::COMPILER && can_compile.is_err();
            let program = Arc::clone(&program);
            let test = move || passes(mode.judge(&program, case));
            let name = format!("{}: {case}", mode.name);
            trials.push(Trial::test(name, test).with_ignored_flag(cannot_run));
        }
    }
    let conclusion = run(&arguments, trials);
    if let Err(error) = can_compile {
        eprintln!("NOT RUN: compiling: the toolchain cannot be linked to where all can reach it: {error}.");
    }
    for (mode, obstacle) in obstacles {
        eprintln!("NOT RUN: all tests as {mode}: {obstacle}.");
    }
    conclusion.exit_code()
}

/// Links what the compiler needs of its toolchain to `target`: a copy would take half a gigabyte.
fn link_toolchain(target: &Path) -> io::Result<()> {
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output()?.stdout;
    let sysroot = PathBuf::from(String::from_utf8_lossy(&sysroot).trim());
    link_folder(&sysroot.join("bin"), &target.join("bin"))?;
    link_folder(&sysroot.join("lib"), &target.join("lib"))
}

fn link_folder(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let to = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            link_folder(&entry.path(), &to)?
        } else {
            fs::hard_link(entry.path(), to)?
        }
    }
    Ok(())
}

fn passes(mut judge: Command) -> Result<(), Failed> {
    let output = judge.output().unwrap();
    if output.status.success() {
        return Ok(());
    }
    Err(format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
        .into())
}

/// What container runtimes refuse without the right to administer the system.
fn refuse_namespaces() {
    let calls =
        [libc::SYS_unshare, libc::SYS_setns, libc::SYS_mount, libc::SYS_pivot_root, libc::SYS_mount_setattr];
    let rules = calls.into_iter().map(|call| (call, Vec::<SeccompRule>::new())).collect();
    let refuse = SeccompAction::Errno(libc::EPERM.cast_unsigned());
    let architecture = env::consts::ARCH.try_into().unwrap();
    let filter = SeccompFilter::new(rules, SeccompAction::Allow, refuse, architecture).unwrap();
    let program: BpfProgram = filter.try_into().unwrap();
    apply_filter(&program).unwrap();
}
