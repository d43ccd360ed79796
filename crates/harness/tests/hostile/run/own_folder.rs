//! Writes beside its own program, and replaces the program.
//!
//! expect: graded 15

fn attack() {
    if std::fs::write("@MARK@-beside", "I was here").is_ok() {
        panic!("beside");
    }
    if let Ok(program) = std::env::current_exe() {
        if std::fs::remove_file(&program).is_ok() || std::fs::write(&program, "I was here").is_ok() {
            panic!("{}", program.display());
        }
    }
}
