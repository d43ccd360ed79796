//! A static larger than any address.
//!
//! expect: does-not-compile

static HUGE: [[u64; 1 << 40]; 1 << 40] = [[0; 1 << 40]; 1 << 40];
