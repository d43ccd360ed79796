//! A static of 512 MiB that is not zero, which would be written into the program.
//!
//! expect: too-expensive-to-compile | does-not-compile

#[used]
static HUGE: [u8; 1 << 29] = [1; 1 << 29];
