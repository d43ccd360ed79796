//! Gives a file away, or takes it.
//!
//! expect: graded 15

fn attack() {
    for path in ["@OUTSIDE@/changeable", "@SECRET@", "."] {
        if std::os::unix::fs::chown(path, Some(12345), Some(12345)).is_ok() {
            panic!("{path}");
        }
    }
}
