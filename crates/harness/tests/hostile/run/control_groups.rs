//! Lifts its own limits, where those are files.
//!
//! expect: graded 15

fn attack() {
    for file in ["/sys/fs/cgroup/cgroup.procs", "/sys/fs/cgroup/pids/tasks", "/sys/fs/cgroup/memory/tasks", "/proc/self/oom_score_adj", "/proc/self/uid_map"] {
        if std::fs::OpenOptions::new().append(true).open(file).is_ok() {
            panic!("{file}");
        }
    }
}
