//! Writes a program into memory and becomes it.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let empty = c"";
    let descriptor = system_call(319, [address(empty), 0, 0]);
    if descriptor < 0 {
        return;
    }
    let text = b"#!/bin/sh\nexit 0\n";
    system_call(1, [descriptor as usize, address(text), text.len()]);
    let arguments = [address(empty), 0];
    // The fifth argument, which asks for an empty path, cannot be given by this hole: /proc names the file instead.
    let path = format!("/proc/self/fd/{descriptor}\0");
    let result = system_call(59, [address(path.as_bytes()), address(&arguments), address(&arguments[1])]);
    assert!(result < 0, "{result}");
}
