//! As whom the harness runs, and with what the system lets it have.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, exit};

use nix::unistd::Uid;
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
};

use crate::planted::give_to;
use crate::undertaker;

/// Makes this program one that is refused namespaces, and then the program that its arguments name.
const REFUSED: &str = "FK_LAB_TEST_WITHOUT_NAMESPACES";

/// An ordinary user whom nobody else is likely to be.
const USER: u32 = 61_847;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// As an ordinary user, although the tests run as root.
    pub as_user: bool,
    /// Whether the system gives out namespaces.
    pub namespaces: bool,
    /// As the first process of a container, which gets all orphans and has nobody to bury them.
    pub first: bool,
}

impl Mode {
    /// As the tests themselves run.
    pub const PLAIN: Mode = Mode { as_user: false, namespaces: true, first: false };

    pub const ALL: [(&str, Mode); 5] = [
        ("as_it_is", Mode::PLAIN),
        ("without_namespaces", Mode { namespaces: false, ..Mode::PLAIN }),
        ("as_an_ordinary_user", Mode { as_user: true, ..Mode::PLAIN }),
        ("as_an_ordinary_user_without_namespaces", Mode { as_user: true, namespaces: false, ..Mode::PLAIN }),
        ("as_the_first_process", Mode { first: true, ..Mode::PLAIN }),
    ];

    /// Why this cannot be had here.
    pub fn missing(self) -> Option<&'static str> {
        if Uid::effective().is_root() {
            return None;
        }
        let user = "only root can become another user; the tests run as an ordinary one already";
        if self.as_user { Some(user) } else { self.first.then_some("only root can become the first process") }
    }

    /// Makes `base` ready for the user who will run the harness.
    pub fn prepare(self, base: &Path) {
        if self.as_user {
            for folder in ["rust", "cargo", "home"] {
                fs::create_dir(base.join(folder)).unwrap();
            }
            give_to(base, USER);
            if !target().exists() {
                fs::create_dir_all(target()).unwrap();
                give_to(&target(), USER);
            }
        }
    }

    /// The harness, in this mode.
    pub fn harness(self, base: &Path) -> Command {
        let mut words = vec![std::env::current_exe().unwrap()];
        if self.as_user {
            // The toolchain mostly lies in root's own folder, where nobody else can read: it is shown in another place.
            let script = "mount --bind \"$1\" \"$2/rust\" && mount --bind \"$3\" \"$2/cargo\" && shift 3 && exec \"$@\"";
            words.extend(
                ["unshare", "--mount", "--propagation", "private", "sh", "-ec", script, "sh"]
                    .map(PathBuf::from),
            );
            words.extend([sysroot(), base.to_path_buf(), cargo_home()]);
            let user = format!("--reuid={USER}");
            let group = format!("--regid={USER}");
            words.extend(["setpriv", &user, &group, "--clear-groups"].map(PathBuf::from));
        }
        if self.first {
            words.extend(["unshare", "--pid", "--fork", "--mount-proc"].map(PathBuf::from));
        }
        if !self.namespaces {
            words.push(std::env::current_exe().unwrap());
        }
        words.push(env!("CARGO_BIN_EXE_harness").into());
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).env(undertaker::WANTED, "1");
        if self.as_user {
            let rust = base.join("rust/bin");
            command
                .env("PATH", format!("{}:/usr/bin:/bin:/usr/sbin:/sbin", rust.display()))
                .env("CARGO", rust.join("cargo"))
                .env("CARGO_HOME", base.join("cargo"))
                .env("CARGO_NET_OFFLINE", "true")
                .env("CARGO_TARGET_DIR", target())
                .env("HOME", base.join("home"))
                .env_remove("RUSTUP_HOME");
        }
        if !self.namespaces {
            command.env(REFUSED, "1");
        }
        command
    }
}

/// Where the libraries are built for the other user, once.
fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("of-an-ordinary-user")
}

fn sysroot() -> PathBuf {
    let output =
        Command::new("rustc").args(["--print", "sysroot"]).current_dir(env!("CARGO_MANIFEST_DIR")).output();
    PathBuf::from(String::from_utf8(output.unwrap().stdout).unwrap().trim_end())
}

fn cargo_home() -> PathBuf {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    home.unwrap_or_else(|| std::env::home_dir().unwrap().join(".cargo"))
}

/// Becomes what the arguments name, without namespaces, when the environment asks for it.
pub fn become_refused_if_asked() {
    if std::env::var_os(REFUSED).is_none() {
        return;
    }
    refuse_namespaces();
    let mut words = std::env::args_os().skip(1);
    let error = Command::new(words.next().unwrap()).args(words).env_remove(REFUSED).exec();
    eprintln!("cannot go on: {error}");
    exit(1);
}

/// As systems do that give ordinary users no namespaces, and containers that give root none.
fn refuse_namespaces() {
    // CLONE_NEWTIME, NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET.
    const FLAGS: [u64; 8] =
        [0x80, 0x2_0000, 0x200_0000, 0x400_0000, 0x800_0000, 0x1000_0000, 0x2000_0000, 0x4000_0000];
    let rule = |flag| {
        let flag =
            SeccompCondition::new(0, SeccompCmpArgLen::Qword, SeccompCmpOp::MaskedEq(flag), flag).unwrap();
        SeccompRule::new(vec![flag]).unwrap()
    };
    let some = FLAGS.map(rule).to_vec();
    let permission = [
        (libc::SYS_clone, some),
        (libc::SYS_unshare, Vec::new()),
        (libc::SYS_setns, Vec::new()),
        (libc::SYS_mount, Vec::new()),
        (libc::SYS_pivot_root, Vec::new()),
    ];
    refuse(permission.into(), libc::EPERM);
    // Its flags lie where no filter can see them; whoever is told that it is unknown uses `clone`.
    refuse([(libc::SYS_clone3, Vec::new())].into(), libc::ENOSYS);
}

fn refuse(calls: BTreeMap<i64, Vec<SeccompRule>>, error: i32) {
    let arch = std::env::consts::ARCH.try_into().unwrap();
    let action = SeccompAction::Errno(error.unsigned_abs());
    let filter = SeccompFilter::new(calls, SeccompAction::Allow, action, arch).unwrap();
    let program: BpfProgram = filter.try_into().unwrap();
    seccompiler::apply_filter(&program).unwrap();
}
