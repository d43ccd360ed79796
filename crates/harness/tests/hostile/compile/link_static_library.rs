//! Asks for a library that it would like to have brought along.
//!
//! expect: does-not-compile

#[link(name = "evil", kind = "static")]
unsafe extern "C" {
    pub safe fn evil() -> i32;
}
