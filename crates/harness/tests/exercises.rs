//! Every exercise can be marked: its solution gets all points, and its template none.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::fs;
use std::path::Path;

use harness::exercise::{EXERCISES, Exercise};
use serde_json::Value;
use support::Harness;

#[test]
fn a_solution_gets_all_points_and_a_template_none() {
    for exercise in &EXERCISES {
        let folder = tempfile::tempdir().unwrap();
        let given = folder.path().join("given");
        fs::create_dir(&given).unwrap();
        fs::write(given.join("300000001_Right.rs"), solution(exercise)).unwrap();
        fs::write(given.join("300000002_Untouched.rs"), exercise.template).unwrap();

        let out = folder.path().join("out");
        let output = Harness::grade(&given, &out).args(["--exercise", exercise.name]).output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{}: {errors}", exercise.name);
        let results = fs::read(out.join("results.json")).unwrap();
        let results: Value = serde_json::from_slice(&results).unwrap();
        for (id, wanted) in [("300000001_Right", [5, 5, 5]), ("300000002_Untouched", [0, 0, 0])] {
            assert_eq!(points(&results, id), wanted, "{}: {id}", exercise.name);
        }
    }
}

fn solution(exercise: &Exercise) -> String {
    let solutions = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../solutions/src");
    fs::read_to_string(solutions.join(exercise.file)).unwrap()
}

/// The points of each part.
fn points(results: &Value, id: &str) -> Vec<u64> {
    let record = results["records"].as_array().unwrap().iter().find(|record| record["id"] == id).unwrap();
    let parts = record["verdict"]["parts"].as_array().unwrap();
    parts.iter().map(|part| part["points"].as_u64().unwrap()).collect()
}
