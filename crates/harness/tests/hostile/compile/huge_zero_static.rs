//! A static of 2 GiB of zeros: nothing to write, but more than a program may have.
//!
//! place: before local_quaternion
//! expect: graded 10; part1 crashed | graded 0 | does-not-compile | too-expensive-to-compile memory

static HUGE: [u8; 1 << 31] = [0; 1 << 31];
fn attack() {
    std::hint::black_box(&HUGE);
}
