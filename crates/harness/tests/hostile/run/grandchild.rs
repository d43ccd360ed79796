//! Leaves a process behind that has left its group and its terminal, and ignores requests to end.
//!
//! expect: graded 15

fn attack() {
    let stay = "trap '' TERM HUP INT; setsid sleep 60 >/dev/null 2>&1 </dev/null &";
    if std::process::Command::new("/bin/sh").args(["-c", stay]).status().is_ok() {
        panic!("left");
    }
}
