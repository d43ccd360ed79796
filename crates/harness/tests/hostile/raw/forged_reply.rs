//! Finds the mark that tells replies from print on the stack, and forges a reply of four thousand million bytes.
//!
//! with: system_calls
//! expect: graded 10; part1 crashed | graded 10; part1 timed-out

use std::io::Write;

fn attack() {
    let here = 0_u8;
    let start = address(&here) & !15;
    let mut forged = Vec::new();
    for place in (start..start + 16 * 1024).step_by(4) {
        let mark: &[u8; 16] = transmute(place);
        if mark[0] == 0 {
            forged.extend_from_slice(mark);
            forged.extend_from_slice(&[0xff; 4]);
        }
    }
    let _ = std::io::stdout().write_all(&forged);
    let _ = std::io::stdout().flush();
    loop {
        std::hint::spin_loop();
    }
}
