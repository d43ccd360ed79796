//! Asks for a million million bytes at once.
//!
//! expect: graded 10; part1 crashed

fn attack() {
    std::hint::black_box(vec![1_u8; 1 << 40]);
}
