//! Attributes that once told the linker what to do.
//!
//! expect: does-not-compile

#![feature(link_args)]
#[link_args = "-T evil.ld"]
unsafe extern "C" {}
