//! Makes name spaces of its own, in which it would be root.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    for flags in [0x1000_0000, 0x2_0000, 0x4000_0000, 0x1000_0000 | 0x2_0000, 0x2000_0000, 0x200_0000] {
        if system_call(272, [flags, 0, 0]) == 0 {
            panic!("{flags:x}");
        }
    }
}
