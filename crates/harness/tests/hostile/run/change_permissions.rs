//! Changes who may read a file. Landlock alone would let it.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "changed"

use std::os::unix::fs::PermissionsExt;

fn attack() {
    for path in ["@OUTSIDE@/changeable", "@SECRET@", "@OUT@", "."] {
        let open = std::fs::Permissions::from_mode(0o777);
        if std::fs::set_permissions(path, open).is_ok() {
            panic!("changed {path}");
        }
    }
}
