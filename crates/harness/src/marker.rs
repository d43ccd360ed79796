//! Everything that marking one exercise on this machine needs, made ready once.

use std::path::{Path, PathBuf};

use grading::{Exam, Rubric};
use results::{CheckInfo, PartInfo, RunInfo, SCHEMA, Shard};
use sandbox::Sandbox;

use crate::Error;
use crate::batch::CompileAndAsk;
use crate::compile::Compiler;
use crate::exercise::Exercise;
use crate::kit::Kit;
use crate::limits::LimitArgs;
use crate::mark::Examiner;
use crate::picture::Portrait;
use crate::toolchain::{Linker, Toolchain};

/// What marking needs.
#[derive(Debug)]
pub struct Marker {
    /// The exercise.
    pub exercise: &'static Exercise,
    toolchain: Toolchain,
    kit: Kit,
    /// Where the compiler and the students' functions run.
    pub sandbox: Sandbox,
    limits: LimitArgs,
    seed: u64,
    /// The questions and the right answers.
    pub exam: Exam,
    portrait: Option<Portrait>,
}

/// How students' code is kept in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protection {
    /// By all that the machine offers; not at all is an error.
    Strongest,
    /// By nothing but limits. Only for files that one trusts.
    None,
}

impl Marker {
    /// Finds the toolchain, builds the libraries and tries the sandbox. `scratch` is the folder in which submissions
    /// will be compiled.
    ///
    /// # Errors
    ///
    /// When one of them is not to be had.
    pub fn new(
        workspace: &Path,
        exercise: &'static Exercise,
        seed: u64,
        limits: LimitArgs,
        protection: Protection,
        scratch: &Path,
    ) -> Result<Marker, Error> {
        let toolchain = Toolchain::find(workspace)?;
        let kit = Kit::build(workspace, &toolchain)?;
        let launcher = launcher()?;
        let sandbox = match protection {
            Protection::Strongest => Sandbox::strongest(launcher, &reads(&toolchain, &kit, scratch))?,
            Protection::None => Sandbox::unsandboxed(launcher),
        };
        let exam = exercise.exam(seed);
        let portrait = exercise.portrait.map(|portrait| portrait()).transpose()?;
        Ok(Marker { exercise, toolchain, kit, sandbox, limits, seed, exam, portrait })
    }

    /// The way from a source to a verdict.
    pub fn marking(&self) -> CompileAndAsk<'_> {
        CompileAndAsk {
            compiler: Compiler {
                exercise: self.exercise,
                toolchain: &self.toolchain,
                kit: &self.kit,
                sandbox: &self.sandbox,
                limits: self.limits.compile(),
            },
            examiner: Examiner {
                exam: &self.exam,
                portrait: self.portrait.as_ref(),
                sandbox: &self.sandbox,
                limits: self.limits.run(),
                patience: self.limits.patience(),
            },
        }
    }

    /// What stands at the head of the results.
    pub fn info(&self, shard: Option<Shard>) -> RunInfo {
        let versions = [("fk-lab", env!("CARGO_PKG_VERSION")), ("rustc", &self.toolchain.version)];
        let layers = self.sandbox.layers();
        RunInfo {
            schema: SCHEMA,
            exercise: self.exercise.name().to_owned(),
            title: self.exercise.rubric().title.to_owned(),
            parts: parts(self.exercise.rubric()),
            seed: self.seed,
            versions: versions.map(|(name, version)| (name.to_owned(), version.to_owned())).into(),
            limits: self.limits.in_words(),
            sandboxed: layers.is_sandboxed(),
            sandbox: layers.to_string(),
            shard,
            reference_picture: self.portrait.as_ref().map(|portrait| portrait.reference.clone()),
        }
    }
}

/// Everything that the sandbox must be able to show to the compiler, the linker and the workers.
pub(crate) fn reads(toolchain: &Toolchain, kit: &Kit, scratch: &Path) -> Vec<PathBuf> {
    let mut reads = vec![toolchain.sysroot.clone(), kit.dependencies.clone(), scratch.to_path_buf()];
    reads.extend(kit.host.iter().flat_map(|host| [host.program.clone(), host.exam.clone()]));
    if let Linker::Direct { system, .. } = &toolchain.linker {
        reads.extend(system.iter().cloned());
    }
    reads
}

/// This program, which the sandbox starts once more to confine another.
pub(crate) fn launcher() -> Result<PathBuf, Error> {
    std::env::current_exe().map_err(|error| Error::read(Path::new("this program"), error))
}

fn parts(rubric: &Rubric) -> Vec<PartInfo> {
    let parts = rubric.parts.iter().map(|part| PartInfo {
        id: part.id.to_owned(),
        function: part.function.to_owned(),
        title: part.title.to_owned(),
        points: part.points(),
        checks: part
            .checks
            .iter()
            .map(|check| CheckInfo {
                id: check.id.to_owned(),
                title: check.title.to_owned(),
                points: check.points,
            })
            .collect(),
    });
    parts.collect()
}
