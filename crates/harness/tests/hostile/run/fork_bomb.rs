//! Starts itself again and again, each of which waits. (It stops at 500.)
//!
//! expect: graded 15

use std::process::{Command, Stdio};

fn attack() {
    let program = std::env::current_exe().unwrap_or_else(|_| "/proc/self/exe".into());
    let mut started = Vec::new();
    for _ in 0..500 {
        match Command::new(&program).stdin(Stdio::piped()).stdout(Stdio::null()).spawn() {
            Ok(child) => started.push(child),
            Err(_) => break,
        }
    }
    if !started.is_empty() {
        panic!("{} processes", started.len());
    }
}
