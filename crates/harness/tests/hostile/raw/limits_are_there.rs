//! Looks which limits it has: processor time, address space, size of files, processes, core dumps.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    for resource in [0, 9, 1, 4] {
        let mut now = [0_u64; 2];
        if system_call(97, [resource, address(&mut now), 0]) == 0 && now[1] == u64::MAX {
            panic!("{resource} has no limit");
        }
    }
}
