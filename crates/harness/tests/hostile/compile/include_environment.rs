//! Reads the compiler's environment from `/proc`.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "TMPDIR"

const STOLEN: &[u8] = include_bytes!("/proc/self/environ");
const _: () = match std::str::from_utf8(STOLEN) {
    Ok(text) => panic!("{}", text),
    Err(_) => {}
};
