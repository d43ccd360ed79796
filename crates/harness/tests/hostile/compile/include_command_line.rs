//! Reads the compiler's command line from `/proc`, and with it where everything lies.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "--edition"

const STOLEN: &[u8] = include_bytes!("/proc/self/cmdline");
const _: () = match std::str::from_utf8(STOLEN) {
    Ok(text) => panic!("{}", text),
    Err(_) => {}
};
