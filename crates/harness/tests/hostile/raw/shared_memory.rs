//! Leaves memory, messages and semaphores behind for the next submission.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    const CREATE: usize = 0o1000 | 0o666;
    for (name, number, arguments) in [
        ("shmget", 29, [0x464b_4c42, 4096, CREATE]),
        ("msgget", 68, [0x464b_4c42, CREATE, 0]),
        ("semget", 64, [0x464b_4c42, 1, CREATE]),
    ] {
        if system_call(number, arguments) >= 0 {
            panic!("{name}");
        }
    }
    let queue = c"fk-lab-queue";
    if system_call(240, [address(queue), 0o102, 0o666]) >= 0 {
        panic!("mq_open");
    }
}
