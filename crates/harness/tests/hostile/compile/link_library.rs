//! Asks for a library of the machine's own, to call what is in it.
//!
//! expect: does-not-compile

#[link(name = "c")]
unsafe extern "C" {
    pub safe fn getppid() -> i32;
}
