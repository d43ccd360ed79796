//! Is its own module.
//!
//! expect: does-not-compile "circular modules"

#[path = "fk.rs"]
mod again;
