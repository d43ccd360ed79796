//! A static of 1280 MiB without any contents: nothing to write into the program, but more memory than anybody may have.
//!
//! place: before local_quaternion
//! expect: does-not-compile "more memory than available" | too-expensive-to-compile memory

use std::mem::MaybeUninit;

static HUGE: MaybeUninit<[u8; 5 << 28]> = MaybeUninit::uninit();

fn attack() {
    std::hint::black_box(&HUGE);
}
