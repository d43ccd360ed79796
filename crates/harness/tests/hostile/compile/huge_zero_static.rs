//! A static of 1280 MiB without any contents: nothing to write into the program, but more memory than it may have.
//!
//! place: before local_quaternion
//! expect: graded 0 | graded 10; part1 crashed | too-expensive-to-compile memory

use std::mem::MaybeUninit;

static HUGE: MaybeUninit<[u8; 5 << 28]> = MaybeUninit::uninit();

fn attack() {
    std::hint::black_box(&HUGE);
}
