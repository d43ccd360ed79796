//! Shows a motion moved by the student's functions: `cargo view`.

fn main() -> std::process::ExitCode {
    viewer::command::run()
}
