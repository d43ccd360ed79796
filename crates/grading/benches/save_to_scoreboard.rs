//! From a saved edit to the scoreboard, as a ratio to the same `cargo test` with the grading left out.
//!
//! `cargo bench -p grading --bench save_to_scoreboard`
#![allow(clippy::unwrap_used)]

#[path = "../tests/support/mod.rs"]
mod support;

use std::time::{Duration, Instant};

use support::{Course, write};

const ROUNDS: usize = 15;

fn main() {
    let solution = include_str!("../../../solutions/src/fk.rs");
    let with = Course::open("bench with grading");
    let without = Course::open("bench without grading");
    let test = "//! Grades nothing.\n\nfn main() {\n    let _ = fk::FUNCTIONS;\n}\n";
    write(&without.folder.join("exercises/fk/tests/grade.rs"), test.as_bytes());
    let manifest = without.folder.join("exercises/fk/Cargo.toml");
    let plain = std::fs::read_to_string(&manifest).unwrap().replace("grading.workspace = true", "");
    write(&manifest, plain.as_bytes());

    // The first two runs build everything else.
    let mut times = [Vec::new(), Vec::new()];
    for round in 0..ROUNDS + 2 {
        for (course, times) in [&with, &without].into_iter().zip(&mut times) {
            let time = save_and_test(course, &format!("{solution}\n// Edit {round}.\n"));
            if round >= 2 {
                times.push(time);
            }
        }
    }
    let [with, without] = times.map(|mut times| {
        times.sort();
        times[times.len() / 2]
    });
    println!("saved edit to scoreboard: {} ms (median of {ROUNDS})", with.as_millis());
    println!("the same without grading: {} ms", without.as_millis());
    println!("ratio: {:.2} (target: at most 1.5)", with.as_secs_f64() / without.as_secs_f64());
}

fn save_and_test(course: &Course, source: &str) -> Duration {
    course.save(source);
    let start = Instant::now();
    let output = course.test_command().arg("--offline").output().unwrap();
    let time = start.elapsed();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    time
}
