//! A static of 1280 MiB of zeros: nothing to write into the program, but more memory than it may have.
//!
//! place: before local_quaternion
//! expect: graded 10; part1 crashed | graded 0

static HUGE: [u8; 5 << 28] = [0; 5 << 28];

fn attack() {
    std::hint::black_box(&HUGE);
}
