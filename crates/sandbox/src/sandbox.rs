//! The sandbox itself: which layers, and how a program is started behind them.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::Duration;

use crate::findings::{Finding, findings};
use crate::platform::Resources;
use crate::{Confinement, Layer, Layers, Limits};

/// Starts programs behind a fixed set of layers. Every program is behind all of them, or does not start.
///
/// Copies share what they have set up. It is taken down with the last of them.
#[derive(Clone)]
pub struct Sandbox(pub(crate) Arc<Inner>);

pub(crate) struct Inner {
    launcher: PathBuf,
    layers: Layers,
    /// Precedes what the launcher itself has to say. The program never sees it.
    token: String,
    pub(crate) resources: Resources,
}

/// Why programs cannot be confined here.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}", self.text())]
pub struct Unavailable {
    /// What was wanted.
    pub why: String,
    /// What this machine offers; empty when that was not asked for.
    pub findings: Vec<Finding>,
}

impl Sandbox {
    /// All layers that this machine offers, each of them tried. `launcher` is a program that calls
    /// [`enter_if_asked`](crate::enter_if_asked), mostly this one ([`std::env::current_exe`]); `reads` are paths that
    /// confined programs will have to read.
    ///
    /// # Errors
    ///
    /// When the layers that are there would not keep a hostile program in. The error says what is missing, and what
    /// to do.
    pub fn strongest(launcher: PathBuf, reads: &[PathBuf]) -> Result<Sandbox, Unavailable> {
        let findings = findings(&launcher, reads);
        let there =
            |layer: &Layer| findings.iter().any(|finding| finding.layer == *layer && finding.available);
        let layers: Vec<Layer> = Layer::ALL.into_iter().filter(there).collect();
        let layers = Layers::of(&layers);
        if !layers.is_sandboxed() {
            let why = "This machine offers too little to keep a hostile program in. It takes namespaces or landlock, and seccomp and limits.".to_owned();
            return Err(Unavailable { why, findings });
        }
        Sandbox::with_layers(launcher, layers).map_err(|error| Unavailable { findings, ..error })
    }

    /// Exactly `layers`, tried together.
    ///
    /// # Errors
    ///
    /// When one of them cannot be had.
    pub fn with_layers(launcher: PathBuf, layers: Layers) -> Result<Sandbox, Unavailable> {
        let unavailable = |why| Unavailable { why, findings: Vec::new() };
        let resources = Resources::open(&launcher, layers).map_err(unavailable)?;
        let sandbox = Sandbox::new(launcher, layers, resources);
        sandbox.check().map_err(unavailable)?;
        Ok(sandbox)
    }

    /// Limits where the system has them, and nothing else: a hostile program gets out. For files that one trusts, and for
    /// systems other than Linux.
    pub fn unsandboxed(launcher: PathBuf) -> Sandbox {
        let layers = if cfg!(unix) { Layers::of(&[Layer::Limits]) } else { Layers::default() };
        Sandbox::new(launcher, layers, Resources::default())
    }

    fn new(launcher: PathBuf, layers: Layers, resources: Resources) -> Sandbox {
        Sandbox(Arc::new(Inner { launcher, layers, token: token(), resources }))
    }

    /// The layers that every program is behind.
    pub fn layers(&self) -> Layers {
        self.0.layers
    }

    /// A command that runs `program` confined. Arguments may be appended; standard input, output and error are the
    /// caller's to choose. It may be used several times, one after the other. The process that it starts ends as
    /// the program does, and killing it ends everything. So does the end of the thread that started it.
    ///
    /// Programs of one `slot` share a user and must not run at the same time; those of different slots cannot reach
    /// one another.
    ///
    /// Time by the clock and the amount of output are not limited: that is up to the caller. Should the jail fail, it
    /// says so on standard error: [`setup_failure`](Sandbox::setup_failure).
    ///
    /// # Errors
    ///
    /// For a path that is not absolute, or a folder that cannot be given to the slot's user.
    pub fn command(&self, slot: u32, confinement: &Confinement, program: &Path) -> io::Result<Command> {
        confinement.check(program)?;
        self.platform_command(slot, confinement, program)
    }

    #[cfg(unix)]
    fn platform_command(&self, slot: u32, confinement: &Confinement, program: &Path) -> io::Result<Command> {
        use crate::unix::{ENTER, spec::Spec};

        let mut spec = Spec::new(self.0.layers, confinement, program);
        self.0.resources.prepare(slot, confinement, &mut spec)?;
        let mut command = Command::new(&self.0.launcher);
        command.arg(ENTER).arg(&self.0.token).arg(spec.encode().map_err(io::Error::other)?);
        command.env_clear().envs(confinement.environment.iter().map(|(name, value)| (name, value)));
        Ok(command)
    }

    #[cfg(not(unix))]
    fn platform_command(&self, _slot: u32, confinement: &Confinement, program: &Path) -> io::Result<Command> {
        let mut command = Command::new(program);
        command.env_clear().envs(confinement.environment.iter().map(|(name, value)| (name, value)));
        if let Some(folder) = &confinement.folder {
            command.current_dir(folder);
        }
        Ok(command)
    }

    /// What the launcher says in `stderr` when the jail could not be set up or the program not be started. `None` when
    /// the program ran. A program cannot forge this.
    pub fn setup_failure(&self, stderr: &[u8]) -> Option<String> {
        let text = String::from_utf8_lossy(stderr);
        let (_, reason) = text.split_once(&self.0.token)?;
        Some(reason.lines().next().unwrap_or_default().trim().to_owned())
    }

    /// Runs a program behind all layers that looks whether they hold.
    fn check(&self) -> Result<(), String> {
        let Some(arguments) = crate::platform::check_arguments(self.0.layers) else { return Ok(()) };
        let limits = Limits {
            cpu: Duration::from_secs(10),
            wall: Duration::from_secs(10),
            memory: 1 << 30,
            threads: 8,
            output: 1 << 16,
            file_size: 0,
        };
        let mut read = crate::system_libraries();
        read.push(self.0.launcher.clone());
        let confinement = Confinement { read, folder: None, environment: Vec::new(), limits };
        let finished =
            self.run(0, &confinement, &self.0.launcher, &arguments).map_err(|error| error.to_string())?;
        if finished.status.is_some_and(|status| status.success()) {
            return Ok(());
        }
        let how = finished.status.map_or_else(|| "without an end".to_owned(), |status| status.to_string());
        let said = String::from_utf8_lossy(&finished.stderr).trim().to_owned();
        Err(if said.is_empty() { format!("the check ended with {how}") } else { said })
    }
}

impl fmt::Debug for Sandbox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Without the token.
        f.debug_struct("Sandbox").field("launcher", &self.0.launcher).field("layers", &self.0.layers).finish()
    }
}

impl Unavailable {
    fn text(&self) -> String {
        let missing = self.findings.iter().filter(|finding| !finding.available);
        let lines = missing.map(|finding| format!("\n{finding}"));
        format!("{}{}", self.why, lines.collect::<String>())
    }
}

/// Whoever does not know it cannot guess it: hashes under keys that the system's random source gave.
fn token() -> String {
    use std::hash::{BuildHasher, RandomState};
    let (one, two) = (RandomState::new(), RandomState::new());
    format!("sandbox-{:016x}{:016x}:", one.hash_one(1), two.hash_one(2))
}
