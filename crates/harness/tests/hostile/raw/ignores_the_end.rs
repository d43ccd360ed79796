//! Asks the kernel not to be told when its processor time is over or when it should end, and loops.
//!
//! with: system_calls
//! expect: graded 10; part1 timed-out

fn attack() {
    // SIG_IGN for SIGTERM, SIGXCPU, SIGHUP, SIGINT.
    let ignore = [1_u64, 0, 0, 0];
    for signal in [15, 24, 1, 2] {
        // The size of the set of signals is the fourth argument, which this hole gives as the number of the call. Refused,
        // that is: what counts is that nobody asks politely.
        system_call(13, [signal, address(&ignore), 0]);
    }
    loop {
        std::hint::spin_loop();
    }
}
