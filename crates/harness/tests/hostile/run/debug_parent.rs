//! Looks into the program that asks with a debugger.
//!
//! expect: graded 15

fn attack() {
    let parent = std::os::unix::process::parent_id().to_string();
    for debugger in ["/usr/bin/gdb", "/usr/bin/strace"] {
        if std::process::Command::new(debugger).args(["-p", &parent]).spawn().is_ok() {
            panic!("{debugger}");
        }
    }
}
