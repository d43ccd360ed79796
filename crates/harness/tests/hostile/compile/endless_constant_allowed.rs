//! A constant that is never ready, where the compiler's objection is waived.
//!
//! expect: too-expensive-to-compile time
//! quick: yes

#![allow(long_running_const_eval)]
const NEVER: u64 = {
    let mut i: u64 = 0;
    while i < u64::MAX {
        i += 1;
    }
    i
};
