//! A constant by a function that calls itself twice, fifty deep.
//!
//! expect: too-expensive-to-compile time | does-not-compile "constant evaluation is taking a long time"

#[allow(long_running_const_eval)]
const fn slow(n: u64) -> u64 {
    if n < 2 { n } else { slow(n - 1) + slow(n - 2) }
}
#[allow(long_running_const_eval)]
const NEVER: u64 = slow(60);
