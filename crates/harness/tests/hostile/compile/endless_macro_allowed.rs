//! The same macro, with a limit of its own. The limit belongs to the whole program, so that it does not count here.
//!
//! expect: does-not-compile "recursion limit"

#![recursion_limit = "1000000000"]
macro_rules! endless {
    () => { endless!(); };
}
endless!();
