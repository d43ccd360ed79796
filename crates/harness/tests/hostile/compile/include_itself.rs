//! Includes its own file again and again.
//!
//! expect: does-not-compile "recursion limit"

mod again {
    include!("fk.rs");
}
