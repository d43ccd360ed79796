//! Calls itself without end.
//!
//! expect: graded 10; part1 crashed
//! quick: yes

fn attack() {
    fn deeper(n: u64) -> u64 {
        std::hint::black_box(deeper(std::hint::black_box(n) + 1)) + 1
    }
    std::hint::black_box(deeper(0));
}
