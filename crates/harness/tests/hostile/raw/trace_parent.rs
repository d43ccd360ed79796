//! Stops, reads and writes the program that asks.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let parent = system_call(110, [0; 3]) as usize;
    // ptrace: attach, seize; then pidfd_open, kcmp, process_madvise.
    for (number, arguments) in [(101, [16, parent, 0]), (101, [0x4206, parent, 0]), (434, [parent, 0, 0])] {
        if parent > 0 && system_call(number, arguments) >= 0 {
            panic!("{number} {arguments:?}");
        }
    }
    let mut buffer = [0_u8; 16];
    let local = [address(&mut buffer), 16];
    if parent > 0 && system_call(310, [parent, address(&local), 1]) > 0 {
        panic!("process_vm_readv");
    }
}
