//! A macro that calls itself without end.
//!
//! expect: does-not-compile "recursion limit"

macro_rules! endless {
    () => { endless!(); };
}
endless!();
