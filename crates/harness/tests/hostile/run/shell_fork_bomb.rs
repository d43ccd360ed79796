//! The shell's shortest program, which fills a machine with itself. (It sleeps after the third step.)
//!
//! expect: graded 15

fn attack() {
    let bomb = "f() { [ \"$1\" -gt 3 ] && exec sleep 60; f $(($1 + 1)) & f $(($1 + 1)) & }; f 0";
    if std::process::Command::new("/bin/sh").args(["-c", bomb]).spawn().is_ok() {
        panic!("started");
    }
}
