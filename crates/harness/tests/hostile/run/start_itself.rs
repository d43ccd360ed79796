//! Starts its own program again.
//!
//! expect: graded 15

fn attack() {
    let program = std::env::current_exe().unwrap_or_else(|_| "/proc/self/exe".into());
    for program in [program, "./worker".into(), "@OUT@/.scratch/0/worker".into(), "@OUT@/.scratch/1/worker".into()] {
        if std::process::Command::new(program).stdin(std::process::Stdio::null()).status().is_ok() {
            panic!("started");
        }
    }
}
