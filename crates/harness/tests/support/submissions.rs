//! Submissions of all kinds.

use std::fs;
use std::path::Path;

/// The reference solution.
pub const SOLUTION: &str = include_str!("../../../../solutions/src/fk.rs");

/// The file as it is handed out.
pub const TEMPLATE: &str = include_str!("../../../../solutions/templates/fk.rs");

/// The solution with one piece of code replaced.
pub fn solution_with(right: &str, wrong: &str) -> String {
    assert!(SOLUTION.contains(right), "the solution no longer contains {right:?}");
    SOLUTION.replace(right, wrong)
}

/// Right, wrong, panicking, not compiling, untouched, in turns.
pub fn source(number: usize) -> String {
    let source = match number % 6 {
        0 | 1 => SOLUTION.to_owned(),
        2 => solution_with("pose[parent].rotation * local,", "local * pose[parent].rotation,"),
        3 => solution_with("        return Quat::IDENTITY;\n", "        panic!(\"no\");\n"),
        4 => solution_with("pose[parent].rotation * local,", "pose[parent] * local,"),
        _ => TEMPLATE.to_owned(),
    };
    // What differs by a number only is not the same file.
    format!("{source}\nconst _: usize = {number};\n")
}

/// A dozen bare files, and one that is no submission.
pub fn write_some(folder: &Path) {
    write(folder, 12);
    fs::write(folder.join("300000999_Broken.zip"), "this is no archive").unwrap();
}

/// `count` bare files.
pub fn write(folder: &Path, count: usize) {
    fs::create_dir_all(folder).unwrap();
    for number in 0..count {
        let name = format!("{}_Student{number}.rs", 300_000_000 + number);
        fs::write(folder.join(name), source(number)).unwrap();
    }
}
