//! Reads the environment of the first process, and with it whatever the machine was started with.
//!
//! expect: does-not-compile "couldn't read"

const STOLEN: &[u8] = include_bytes!("/proc/1/environ");
const _: () = match std::str::from_utf8(STOLEN) {
    Ok(text) => panic!("{}", text),
    Err(_) => {}
};
