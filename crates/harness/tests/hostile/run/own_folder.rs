//! Writes beside its own program, and replaces the program.
//!
//! expect: graded 15

fn attack() {
    if std::fs::File::create("@MARK@-beside").is_ok() {
        panic!("beside");
    }
    if let Ok(program) = std::env::current_exe() {
        if std::fs::remove_file(&program).is_ok() || std::fs::File::create(&program).is_ok() {
            panic!("{}", program.display());
        }
    }
}
