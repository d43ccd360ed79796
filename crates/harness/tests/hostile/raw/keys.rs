//! Leaves a key behind in the kernel for the next submission.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let (kind, name) = (c"user", c"fk-lab");
    // add_key wants five arguments; request_key, which is like it, gets by with three and keyctl with two.
    if system_call(249, [address(kind), address(name), 0]) >= 0 || system_call(250, [0, usize::MAX - 2, 1]) >= 0 {
        panic!("keys");
    }
}
