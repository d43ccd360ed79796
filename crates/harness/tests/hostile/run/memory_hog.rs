//! Fills the memory until there is none.
//!
//! expect: graded 10; part1 crashed | graded 10; part1 timed-out
//! quick: yes

fn attack() {
    let mut held = Vec::new();
    loop {
        held.push(std::hint::black_box(vec![1_u8; 1 << 24]));
    }
}
