//! Makes links to a file that it may not read, from a folder in which everybody may.
//!
//! expect: graded 15
//! unprotected: graded; part1 partly-right "symbolic"

fn attack() {
    if std::os::unix::fs::symlink("@SECRET@", "@OUTSIDE@/@MARK@-symbolic").is_ok() {
        panic!("symbolic");
    }
    if std::fs::hard_link("@SECRET@", "@OUTSIDE@/@MARK@-hard").is_ok() {
        panic!("hard");
    }
}
