//! A constant that is never ready.
//!
//! expect: does-not-compile "constant evaluation is taking a long time"

const NEVER: u64 = {
    let mut i: u64 = 0;
    while i < u64::MAX {
        i += 1;
    }
    i
};
