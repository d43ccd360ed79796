//! Lets its parent trace it.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    if system_call(101, [0; 3]) == 0 {
        panic!("PTRACE_TRACEME");
    }
}
