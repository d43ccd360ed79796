//! Becomes another program.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let program = c"/bin/sh";
    let arguments = [address(program), 0];
    system_call(59, [address(program), address(&arguments), address(&arguments[1])]);
}
