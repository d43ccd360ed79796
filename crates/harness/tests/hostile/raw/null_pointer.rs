//! Reads from the address zero.
//!
//! with: system_calls
//! expect: graded 10; part1 crashed

fn attack() {
    let nothing: &u64 = transmute(8_usize);
    std::hint::black_box(*nothing);
}
