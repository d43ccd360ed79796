//! Reads the environment that it was started with, by `/proc` and by the library.
//!
//! expect: graded 15

fn attack() {
    if let Some(stolen) = std::env::var_os("FK_LAB_PLANTED").or_else(|| std::env::var_os("HOME")) {
        panic!("{stolen:?}");
    }
    if let Ok(stolen) = std::fs::read("/proc/self/environ") {
        panic!("{}", String::from_utf8_lossy(&stolen));
    }
}
