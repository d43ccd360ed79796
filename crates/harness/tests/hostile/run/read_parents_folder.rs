//! Follows the parent's own links: its folder, its program, its open files.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    let parent = std::os::unix::process::parent_id();
    for link in ["cwd", "exe", "root", "fd/0", "fd/3", "fd/4", "fd/5"] {
        if let Ok(stolen) = std::fs::read_link(format!("/proc/{parent}/{link}")) {
            panic!("{}", stolen.display());
        }
    }
}
