//! Makes the code of the program writable, and writes over what answers. It can only harm itself.
//!
//! with: system_calls
//! expect: graded

fn attack() {
    let code = exam::worker::serve as *const () as usize;
    system_call(10, [code & !4095, 8192, 7]);
}
