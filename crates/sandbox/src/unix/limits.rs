//! Resource limits of the process.

use nix::sys::resource::{Resource, getrlimit, rlim_t, setrlimit};

use super::spec::Spec;

/// Open files. Compilers open some dozens.
const OPEN_FILES: u64 = 256;

/// Bytes of the first thread's stack, the usual size. Without an end it would grow into everything.
const STACK: u64 = 8 << 20;

/// Sets all limits. Afterwards this process may be unable to get more memory.
pub fn apply(spec: &Spec) -> nix::Result<()> {
    no_core_dump()?;
    let file_size = if spec.folder().is_some() { spec.file_size } else { 0 };
    // A signal at the first number, the end at the second.
    set(Resource::RLIMIT_CPU, spec.cpu, spec.cpu.saturating_add(1))?;
    for (resource, limit) in [
        (Resource::RLIMIT_FSIZE, file_size),
        (Resource::RLIMIT_NOFILE, OPEN_FILES),
        (Resource::RLIMIT_STACK, STACK),
    ] {
        set(resource, limit, limit)?;
    }
    #[cfg(target_os = "linux")]
    apply_more(spec)?;
    set(Resource::RLIMIT_AS, spec.memory, spec.memory)
}

/// What not every Unix has.
#[cfg(target_os = "linux")]
fn apply_more(spec: &Spec) -> nix::Result<()> {
    for resource in
        [Resource::RLIMIT_MEMLOCK, Resource::RLIMIT_MSGQUEUE, Resource::RLIMIT_RTPRIO, Resource::RLIMIT_NICE]
    {
        set(resource, 0, 0)?;
    }
    spec.tasks.map_or(Ok(()), |tasks| set(Resource::RLIMIT_NPROC, tasks, tasks))
}

/// One byte rather than none: Linux then also starts no program that gathers core dumps.
pub fn no_core_dump() -> nix::Result<()> {
    set(Resource::RLIMIT_CORE, 1, 1)
}

/// Never more than is allowed now.
fn set(resource: Resource, soft: rlim_t, hard: rlim_t) -> nix::Result<()> {
    let (_, most) = getrlimit(resource)?;
    setrlimit(resource, soft.min(most), hard.min(most))
}
