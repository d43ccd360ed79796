//! The system calls of a program with threads, and no others.
//!
//! Everything that is not listed fails as if this kernel had no such call. Libraries then fall back on older ones; above
//! all, threads are started by `clone`, whose flags can be looked at, instead of `clone3`. A call by the numbers of
//! another architecture (32-bit) ends the process.

use std::collections::BTreeMap;

use libc::c_long;
use seccompiler::{
    BackendError, BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter,
    SeccompRule,
};

use crate::unix::Context;

type Rules = BTreeMap<i64, Vec<SeccompRule>>;

/// The filter for this process, known by its number. Only a program with a folder may write files at all.
pub fn filter(own_process: u32, writes: bool) -> Result<BpfProgram, String> {
    let rules = rules(own_process, writes).context("list the system calls")?;
    let nothing = SeccompAction::Errno(libc::ENOSYS.cast_unsigned());
    let architecture = std::env::consts::ARCH.try_into().context("filter system calls")?;
    let filter = SeccompFilter::new(rules, nothing, SeccompAction::Allow, architecture);
    filter.and_then(TryInto::try_into).context("build the filter of system calls")
}

/// Binds this process for ever.
pub fn obey(filter: &BpfProgram) -> Result<(), String> {
    seccompiler::apply_filter(filter).context("filter system calls")
}

fn rules(own_process: u32, writes: bool) -> Result<Rules, BackendError> {
    let mut rules = Rules::new();
    let always = ALWAYS.iter().chain(ALWAYS_OLD).chain(if writes { WRITING } else { &[] });
    let always = always.chain(if writes { WRITING_OLD } else { &[] });
    for call in always {
        rules.insert(*call, Vec::new());
    }
    for (call, argument, values) in ONLY_WITH {
        let allowed = values.iter().map(|value| only_if(*argument, SeccompCmpOp::Eq, *value));
        rules.insert(*call, allowed.collect::<Result<_, _>>()?);
    }
    // Asking for limits, not setting them: the pointer to new ones is null.
    let asks = SeccompCondition::new(2, SeccompCmpArgLen::Qword, SeccompCmpOp::Eq, 0)?;
    rules.insert(libc::SYS_prlimit64, vec![SeccompRule::new(vec![asks])?]);
    // Threads, not processes.
    let thread = (libc::CLONE_THREAD | libc::CLONE_VM).cast_unsigned().into();
    rules.insert(libc::SYS_clone, vec![only_if(0, SeccompCmpOp::MaskedEq(thread), thread)?]);
    // Signals to itself: this is how a program aborts.
    rules.insert(libc::SYS_tgkill, vec![only_if(0, SeccompCmpOp::Eq, own_process.into())?]);
    if writes {
        // No set-user bits.
        rules.insert(libc::SYS_fchmod, vec![only_if(1, SeccompCmpOp::MaskedEq(0o7000), 0)?]);
    } else {
        let write = SeccompCmpOp::MaskedEq(WRITE_FLAGS);
        for (call, flags) in OPENING {
            rules.insert(*call, vec![only_if(*flags, write.clone(), 0)?]);
        }
    }
    Ok(rules)
}

fn only_if(argument: u8, operator: SeccompCmpOp, value: u64) -> Result<SeccompRule, BackendError> {
    // All these arguments are 32 bits wide.
    let condition = SeccompCondition::new(argument, SeccompCmpArgLen::Dword, operator, value)?;
    SeccompRule::new(vec![condition])
}

/// Reading files by name, memory, threads, time, signals to itself, and what a program is started by.
const ALWAYS: &[c_long] = &[
    libc::SYS_brk,
    libc::SYS_clock_getres,
    libc::SYS_clock_gettime,
    libc::SYS_clock_nanosleep,
    libc::SYS_close,
    libc::SYS_dup,
    // Only to start the program: what can be executed at all is for Landlock and the private root to say.
    libc::SYS_execve,
    libc::SYS_exit,
    libc::SYS_exit_group,
    libc::SYS_faccessat,
    libc::SYS_faccessat2,
    libc::SYS_fstat,
    libc::SYS_futex,
    libc::SYS_getcwd,
    libc::SYS_getdents64,
    libc::SYS_getegid,
    libc::SYS_geteuid,
    libc::SYS_getgid,
    libc::SYS_getpid,
    libc::SYS_getrandom,
    libc::SYS_getrusage,
    libc::SYS_gettid,
    libc::SYS_gettimeofday,
    libc::SYS_getuid,
    libc::SYS_lseek,
    libc::SYS_madvise,
    libc::SYS_mmap,
    libc::SYS_mprotect,
    libc::SYS_mremap,
    libc::SYS_munmap,
    libc::SYS_nanosleep,
    libc::SYS_newfstatat,
    libc::SYS_pipe2,
    libc::SYS_ppoll,
    libc::SYS_pread64,
    libc::SYS_pwrite64,
    libc::SYS_read,
    libc::SYS_readlinkat,
    libc::SYS_readv,
    libc::SYS_restart_syscall,
    libc::SYS_rseq,
    libc::SYS_rt_sigaction,
    libc::SYS_rt_sigprocmask,
    libc::SYS_rt_sigreturn,
    libc::SYS_sched_getaffinity,
    libc::SYS_sched_yield,
    libc::SYS_set_robust_list,
    libc::SYS_set_tid_address,
    libc::SYS_sigaltstack,
    libc::SYS_statx,
    libc::SYS_sysinfo,
    libc::SYS_uname,
    libc::SYS_write,
    libc::SYS_writev,
];

/// What only a program with a folder may do. Landlock and the private root keep it inside.
const WRITING: &[c_long] = &[
    libc::SYS_copy_file_range,
    libc::SYS_eventfd2,
    libc::SYS_fadvise64,
    libc::SYS_fallocate,
    libc::SYS_fdatasync,
    libc::SYS_flock,
    libc::SYS_fstatfs,
    libc::SYS_fsync,
    libc::SYS_ftruncate,
    libc::SYS_linkat,
    libc::SYS_mkdirat,
    libc::SYS_msync,
    libc::SYS_openat,
    libc::SYS_renameat2,
    libc::SYS_sendfile,
    libc::SYS_statfs,
    libc::SYS_umask,
    libc::SYS_unlinkat,
];

/// The older forms of the same, which newer architectures do without.
#[cfg(target_arch = "x86_64")]
const ALWAYS_OLD: &[c_long] = &[
    libc::SYS_access,
    libc::SYS_arch_prctl,
    libc::SYS_dup2,
    libc::SYS_getrlimit,
    libc::SYS_lstat,
    libc::SYS_pipe,
    libc::SYS_poll,
    libc::SYS_readlink,
    libc::SYS_stat,
];
#[cfg(target_arch = "x86_64")]
const WRITING_OLD: &[c_long] = &[
    libc::SYS_link,
    libc::SYS_mkdir,
    libc::SYS_open,
    libc::SYS_rename,
    libc::SYS_renameat,
    libc::SYS_rmdir,
    libc::SYS_unlink,
];
#[cfg(not(target_arch = "x86_64"))]
const ALWAYS_OLD: &[c_long] = &[];
#[cfg(not(target_arch = "x86_64"))]
const WRITING_OLD: &[c_long] = &[];

/// The calls that open a file, and which argument holds the flags.
#[cfg(target_arch = "x86_64")]
const OPENING: &[(c_long, u8)] = &[(libc::SYS_openat, 2), (libc::SYS_open, 1)];
#[cfg(not(target_arch = "x86_64"))]
const OPENING: &[(c_long, u8)] = &[(libc::SYS_openat, 2)];

const WRITE_FLAGS: u64 = (libc::O_WRONLY | libc::O_RDWR | libc::O_CREAT | libc::O_TRUNC) as u64;

/// Calls of which one argument may have these values only.
const ONLY_WITH: &[(c_long, u8, &[u64])] = &[
    // No owner or signal of a descriptor: that would be a way to send signals.
    (
        libc::SYS_fcntl,
        1,
        &[
            libc::F_DUPFD as u64,
            libc::F_DUPFD_CLOEXEC as u64,
            libc::F_GETFD as u64,
            libc::F_SETFD as u64,
            libc::F_GETFL as u64,
            libc::F_SETFL as u64,
            libc::F_GETLK as u64,
            libc::F_SETLK as u64,
            libc::F_SETLKW as u64,
        ],
    ),
    // "Is this a terminal?", and closing on exec.
    (libc::SYS_ioctl, 1, &[libc::TCGETS, libc::FIOCLEX]),
    // Names of threads and of memory.
    (libc::SYS_prctl, 0, &[libc::PR_SET_NAME as u64, libc::PR_GET_NAME as u64, libc::PR_SET_VMA as u64]),
];
