//! Starts a process by the newest call, whose flags a filter cannot see.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    // The flags, then the signal at the end: everything else is zero.
    let mut how = [0_u64; 11];
    how[4] = 17;
    match system_call(435, [address(&how), 88, 0]) {
        0 => std::process::exit(0),
        child if child > 0 => panic!("clone3"),
        _ => {}
    }
}
