//! Writes over the code of the program, where the checks of the answers would be if there were any.
//!
//! with: system_calls
//! expect: graded 10; part1 crashed

fn attack() {
    let code = exam::worker::serve as *const () as usize;
    let place: &mut [u8; 16] = transmute(code);
    *place = [0xcc; 16];
}
