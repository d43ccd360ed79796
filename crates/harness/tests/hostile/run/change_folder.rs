//! Goes up, and reads and writes from there.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for _ in 0..20 {
        let _ = std::env::set_current_dir("..");
    }
    let secret = "@SECRET@".trim_start_matches('/');
    if std::fs::read(secret).is_ok() {
        panic!("read");
    }
}
