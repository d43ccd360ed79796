//! Files, TCP and signals, refused by Landlock.

use std::path::Path;

use landlock::{
    ABI, Access, AccessFs, AccessNet, BitFlags, PathBeneath, PathFd, Ruleset, RulesetAttr, RulesetCreated,
    RulesetCreatedAttr, RulesetError, RulesetStatus, Scope,
};

use crate::unix::Context;
use crate::unix::spec::Spec;

/// The newest rules that this is written for (Linux 6.12). An older kernel enforces those that it knows; what it leaves
/// open (TCP, signals, cutting files off) the system calls' filter shuts as well.
const VERSION: ABI = ABI::V6;

/// Opens the files of `spec` and makes the rules. They bind nobody yet.
pub fn rules(spec: &Spec) -> Result<RulesetCreated, String> {
    let mut rules = deny_all().context("make Landlock rules")?;
    for path in spec.read() {
        let what =
            if path.is_dir() { AccessFs::from_read(VERSION) } else { AccessFs::ReadFile | AccessFs::Execute };
        rules = allow(rules, path, what)?;
    }
    match spec.folder() {
        Some(folder) => allow(rules, folder, in_folder()),
        None => Ok(rules),
    }
}

/// Binds this process for ever.
pub fn obey(rules: RulesetCreated) -> Result<(), String> {
    let status = rules.restrict_self().context("obey the Landlock rules")?;
    match status.ruleset {
        RulesetStatus::NotEnforced => Err("this kernel does not enforce Landlock".to_owned()),
        RulesetStatus::FullyEnforced | RulesetStatus::PartiallyEnforced => Ok(()),
    }
}

fn deny_all() -> Result<RulesetCreated, RulesetError> {
    Ruleset::default()
        .handle_access(AccessFs::from_all(VERSION))?
        .handle_access(AccessNet::from_all(VERSION))?
        .scope(Scope::from_all(VERSION))?
        .create()
}

fn allow(rules: RulesetCreated, path: &Path, what: BitFlags<AccessFs>) -> Result<RulesetCreated, String> {
    let name = format!("open {}", path.display());
    let file = PathFd::new(path).context(&name)?;
    rules.add_rule(PathBeneath::new(file, what)).context(&name)
}

/// Ordinary files and folders, but no programs, links, sockets or devices.
fn in_folder() -> BitFlags<AccessFs> {
    AccessFs::ReadFile
        | AccessFs::ReadDir
        | AccessFs::WriteFile
        | AccessFs::Truncate
        | AccessFs::MakeReg
        | AccessFs::MakeDir
        | AccessFs::RemoveFile
        | AccessFs::RemoveDir
        | AccessFs::Refer
}
