//! Moves the root of its file system.
//!
//! expect: graded 15

fn attack() {
    for folder in ["/", ".", "..", "@OUTSIDE@"] {
        if std::os::unix::fs::chroot(folder).is_ok() {
            panic!("{folder}");
        }
    }
}
