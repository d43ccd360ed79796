//! Runs one case in one mode, in a process of its own.

use std::ffi::OsString;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;
use std::{env, fs};

use sandbox::{Confinement, Finished, Layer, Limits, Sandbox, system_libraries};
use tempfile::TempDir;

use crate::attacker;
use crate::cases;
use crate::modes::Mode;

pub const ROLE: &str = "judge";
pub const HARNESS: &str = "harness";
/// Instead of a case: prints the layers that are found.
pub const LAYERS: &str = "layers";

pub const MIB: u64 = 1 << 20;
/// Stands in files and in the environment, and must not get out.
pub const SECRET: &str = "the-secret-of-somebody-else";

pub fn run(mode: &str, case: &str) {
    let mode = Mode::named(mode);
    mode.imitate();
    if case == LAYERS {
        match mode.sandbox() {
            Ok(sandbox) => println!("{}", sandbox.layers()),
            Err(error) => println!("{error}"),
        }
        return;
    }
    cases::judge(case, &Scene::new(mode, Path::new("/tmp")));
}

/// What a harness does that is about to be killed: it starts a program that never ends.
pub fn be_a_harness(mode: &str, folder: &str) {
    let mode = Mode::named(mode);
    mode.imitate();
    let scene = Scene::new(mode, Path::new(folder));
    let mut command = scene.command("sleep", &[]);
    command.stdin(Stdio::null()).status().unwrap();
}

/// A sandbox, and around it what an attacker may be after.
pub struct Scene {
    pub mode: &'static Mode,
    pub sandbox: Sandbox,
    pub confinement: Confinement,
    pub home: TempDir,
}

impl Scene {
    /// Its files are in a new folder in `folder`, which all may enter.
    fn new(mode: &'static Mode, folder: &Path) -> Scene {
        let sandbox = mode.sandbox().unwrap();
        assert!(mode.possible_layers().contains(&sandbox.layers()));
        let home = tempfile::Builder::new().prefix("home of judge ").tempdir_in(folder).unwrap();
        // Any user may come in here: only the sandbox keeps them out.
        open_to_all(home.path());
        for folder in ["outside", "folder", "library"] {
            fs::create_dir(home.path().join(folder)).unwrap();
            open_to_all(&home.path().join(folder));
        }
        for file in ["outside/secret", "library/readable", "folder/here"] {
            fs::write(home.path().join(file), SECRET).unwrap();
            fs::set_permissions(home.path().join(file), fs::Permissions::from_mode(0o666)).unwrap();
        }
        let limits = Limits {
            cpu: Duration::from_secs(10),
            wall: Duration::from_secs(30),
            memory: 512 * MIB,
            threads: 16,
            output: 1 << 20,
            file_size: MIB,
        };
        let mut read = system_libraries();
        read.extend([env::current_exe().unwrap(), home.path().join("library")]);
        let folder = Some(home.path().join("folder"));
        let environment = vec![("GIVEN".into(), "yes".into())];
        Scene { mode, sandbox, confinement: Confinement { read, folder, environment, limits }, home }
    }

    /// A path in the judge's home.
    pub fn path(&self, name: &str) -> PathBuf {
        self.home.path().join(name)
    }

    pub fn secret(&self) -> String {
        self.path("outside/secret").to_str().unwrap().to_owned()
    }

    pub fn command(&self, attack: &str, arguments: &[&str]) -> Command {
        self.command_as(&self.confinement, attack, arguments)
    }

    pub fn command_as(&self, confinement: &Confinement, attack: &str, arguments: &[&str]) -> Command {
        let mut command = self.sandbox.command(1, confinement, &env::current_exe().unwrap()).unwrap();
        command.args([attacker::ROLE, attack]).args(arguments);
        command
    }

    pub fn run(&self, attack: &str, arguments: &[&str]) -> Finished {
        self.run_as(&self.confinement, attack, arguments)
    }

    pub fn run_as(&self, confinement: &Confinement, attack: &str, arguments: &[&str]) -> Finished {
        self.run_in(&self.sandbox, 1, confinement, attack, arguments)
    }

    pub fn run_in(
        &self,
        sandbox: &Sandbox,
        slot: u32,
        confinement: &Confinement,
        attack: &str,
        arguments: &[&str],
    ) -> Finished {
        let words = [attacker::ROLE, attack].into_iter().chain(arguments.iter().copied());
        let words: Vec<OsString> = words.map(OsString::from).collect();
        let program = env::current_exe().unwrap();
        let finished = sandbox.run(slot, confinement, &program, &words).unwrap();
        let output = [&finished.stdout[..], &finished.stderr[..]].concat();
        assert!(!String::from_utf8_lossy(&output).contains(SECRET), "the secret got out");
        finished
    }

    /// The attack must be refused, with a folder to write and without.
    pub fn refuses(&self, attack: &str, arguments: &[&str]) {
        self.refuses_as(&self.confinement, attack, arguments);
        let confinement = Confinement { folder: None, ..self.confinement.clone() };
        self.refuses_as(&confinement, attack, arguments);
    }

    pub fn refuses_as(&self, confinement: &Confinement, attack: &str, arguments: &[&str]) {
        let finished = self.run_as(confinement, attack, arguments);
        let said = text(&finished);
        let is_refused = finished.stdout.starts_with(attacker::REFUSED.as_bytes());
        assert!(is_refused && finished.status.unwrap().success(), "{:?}: {said}", finished.status);
    }

    /// Whether a program's threads are counted apart from those of others.
    pub fn counts_threads(&self) -> bool {
        [Layer::Namespaces, Layer::OwnUser, Layer::Cgroup].into_iter().any(|layer| self.has(layer))
    }

    pub fn has(&self, layer: Layer) -> bool {
        self.mode.has(layer)
    }
}

pub fn text(finished: &Finished) -> String {
    let output = [&finished.stdout[..], &finished.stderr[..]].concat();
    String::from_utf8_lossy(&output).into_owned()
}

fn open_to_all(folder: &Path) {
    fs::set_permissions(folder, fs::Permissions::from_mode(0o777)).unwrap();
}
