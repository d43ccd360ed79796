//! Hands system calls to the kernel in a ring, which no filter sees.
//!
//! with: system_calls
//! expect: graded 15
//! quick: yes

fn attack() {
    let mut parameters = [0_u8; 120];
    let ring = system_call(425, [8, address(&mut parameters), 0]);
    if ring >= 0 {
        panic!("io_uring");
    }
}
