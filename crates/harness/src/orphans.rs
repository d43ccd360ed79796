//! What is left of confined programs that had to be killed.
//!
//! When the launcher of a confined program is killed, the dead program becomes an orphan. The system's first process
//! buries orphans; in many containers it does not, or is this very program. Then the dead stay in their control group until
//! it is full, and the next submissions can start nothing. So this program takes the orphans itself.
//!
//! Orphans are told from children that somebody here waits for by their process group: every launcher leads one of its
//! own, and an orphan is in one that it does not lead.

#[cfg(target_os = "linux")]
pub use linux::{adopt, bury};

/// Makes this process the one that gets orphans.
#[cfg(not(target_os = "linux"))]
pub fn adopt() {}

/// Buries the dead among them.
#[cfg(not(target_os = "linux"))]
pub fn bury() {}

#[cfg(target_os = "linux")]
mod linux {
    use std::fs;

    use nix::sys::prctl::set_child_subreaper;
    use nix::sys::wait::{WaitPidFlag, waitpid};
    use nix::unistd::{Pid, getpgrp, getpid};

    /// Makes this process the one that gets orphans.
    pub fn adopt() {
        // Where that is refused, the first process gets them, as ever.
        let _ = set_child_subreaper(true);
    }

    /// Buries the dead among them.
    pub fn bury() {
        // Orphans go to a program's first thread.
        let own = getpid();
        let children = fs::read_to_string(format!("/proc/self/task/{own}/children")).unwrap_or_default();
        for number in children.split_whitespace().filter_map(|number| number.parse().ok()) {
            let stat = fs::read_to_string(format!("/proc/{number}/stat")).unwrap_or_default();
            if is_dead_orphan(number, &stat).unwrap_or(false) {
                let _ = waitpid(Pid::from_raw(number), Some(WaitPidFlag::WNOHANG));
            }
        }
    }

    /// `stat` is a line of proc_pid_stat(5): number, name in brackets, state, parent, process group and so on.
    fn is_dead_orphan(number: i32, stat: &str) -> Option<bool> {
        let mut fields = stat.rsplit_once(") ")?.1.split(' ');
        let (state, parent, group) = (fields.next()?, fields.next()?, fields.next()?);
        let (parent, group): (i32, i32) = (parent.parse().ok()?, group.parse().ok()?);
        let is_own = parent == getpid().as_raw();
        Some(is_own && state == "Z" && group != number && group != getpgrp().as_raw())
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn only_the_dead_of_other_groups_are_orphans() {
            let (own, group) = (getpid(), getpgrp());
            let is = |stat: String| is_dead_orphan(77, &stat).unwrap();
            assert!(is(format!("77 (a) Z name) Z {own} 76 76 0 -1")));
            assert!(!is(format!("77 (name) S {own} 76 76 0 -1")), "it lives");
            assert!(!is(format!("77 (name) Z {own} 77 77 0 -1")), "a launcher, which is waited for");
            assert!(
                !is(format!("77 (name) Z {own} {group} 1 0 -1")),
                "started by this program, which waits for it"
            );
            assert!(!is("77 (name) Z 1 76 76 0 -1".to_owned()), "somebody else's");
            assert_eq!(is_dead_orphan(77, ""), None);
        }
    }
}
