//! Prints by the attribute with which the compiler's developers look at types.
//!
//! expect: does-not-compile

#![feature(rustc_attrs)]
#[rustc_layout(debug)]
pub type Shown = u8;
