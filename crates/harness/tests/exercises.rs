//! Every exercise can be marked: its solution gets all points, and its template none. What students read of it tells neither
//! questions nor right answers.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::fs;
use std::path::Path;

use exam::Answer;
use grading::{Case, Exam, Trouble};
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
        // A file in a folder or an archive is found by its name.
        fs::create_dir(given.join("300000004_Folder")).unwrap();
        fs::write(given.join("300000004_Folder").join(exercise.file()), solution(exercise)).unwrap();
        fs::write(given.join("300000004_Folder").join("trial.rs"), exercise.template).unwrap();

        let out = folder.path().join("out");
        let output = Harness::grade(&given, &out).args(["--exercise", exercise.name()]).output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{}: {errors}", exercise.name());
        let results = fs::read(out.join("results.json")).unwrap();
        let results: Value = serde_json::from_slice(&results).unwrap();
        for (id, wanted) in [
            ("300000001_Right", [5, 5, 5]),
            ("300000002_Untouched", [0, 0, 0]),
            ("300000004_Folder", [5, 5, 5]),
        ] {
            assert_eq!(points(&results, id), wanted, "{}: {id}", exercise.name());
        }
    }
}

#[test]
fn feedback_on_wrong_answers_tells_neither_questions_nor_right_answers() {
    for exercise in &EXERCISES {
        let folder = tempfile::tempdir().unwrap();
        let given = folder.path().join("given");
        fs::create_dir(&given).unwrap();
        fs::write(given.join("300000003_Wrong.rs"), wrong(exercise)).unwrap();

        let out = folder.path().join("out");
        let output = Harness::grade(&given, &out).args(["--exercise", exercise.name()]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let results: Value = serde_json::from_slice(&fs::read(out.join("results.json")).unwrap()).unwrap();
        assert!(points(&results, "300000003_Wrong").iter().all(|points| *points < 5), "{results}");
        let secrets = secrets(&exercise.exam(7));
        assert!(secrets.len() > 50, "{secrets:?}");
        let private = results.to_string();
        assert!(
            secrets.iter().any(|secret| private.contains(secret)),
            "the secrets are those of other questions"
        );
        for ending in ["md", "html"] {
            let feedback =
                fs::read_to_string(out.join(format!("feedback/300000003_Wrong.{ending}"))).unwrap();
            for secret in &secrets {
                assert!(!feedback.contains(secret), "{}: {secret}\n{feedback}", exercise.name());
            }
        }
    }
}

/// The template with something else in the place of everything that it returns.
fn wrong(exercise: &Exercise) -> String {
    let replaced: &[(&str, &str)] = match exercise.name() {
        "fk" => &[
            ("    Quat::IDENTITY\n}", "    Quat::from_rotation_x(1.0)\n}"),
            ("    local\n}", "    local.conjugate()\n}"),
            ("    local_position\n}", "    -local_position\n}"),
        ],
        "interpolation" => &[
            ("    from\n}", "    from.map(|angle| angle + 1.0)\n}"),
            ("    from\n}", "    from.conjugate()\n}"),
            ("vec![Quat::IDENTITY;", "vec![Quat::from_rotation_x(1.0);"),
        ],
        "keyframes" => &[
            ("    0.0\n}", "    1.0\n}"),
            ("    0.0\n}", "    1.0\n}"),
            ("(0..frame_count).collect()", "(1..frame_count).collect()"),
        ],
        "acclaim" => &[
            ("    Quat::IDENTITY\n}", "    Quat::from_rotation_x(1.0)\n}"),
            ("(parent_end, parent_end)\n}", "(parent_end, -parent_end)\n}"),
            ("visitor.visit(bone);\n}", "visitor.visit(bone);\n    visitor.visit(bone);\n}"),
        ],
        "time-warp" => &[
            ("after: new_frame, t: 0.0 }", "after: new_frame + 1, t: 0.125 }"),
            ("from.clone()\n}", "Posture { angles: Vec::new(), ..from.clone() }\n}"),
            ("postures.to_vec()\n}", "postures.iter().rev().cloned().collect()\n}"),
        ],
        name => panic!("say here how {name} is answered wrongly"),
    };
    replaced.iter().fold(exercise.template.to_owned(), |source, (old, new)| {
        assert!(source.contains(old), "{old}\n{source}");
        source.replacen(old, new, 1)
    })
}

/// What of an exam would help the next student: the numbers that go in, and those that should come out.
fn secrets(exam: &Exam) -> Vec<String> {
    let mut secrets = Vec::new();
    for part in &exam.parts {
        for case in part.checks.iter().flat_map(|check| &check.cases) {
            secrets.extend(case.inputs.iter().map(|(_, value)| value.clone()));
            secrets.extend(expected(case, &case.question.ask(&part.template)));
        }
    }
    let whole = exam.whole_motion.judge.judge(&exam.whole_motion.question.ask(&exam.parts[0].template));
    if let Some(Trouble::Different { details, .. }) = whole.trouble {
        let expected = details.iter().filter_map(|detail| detail.strip_prefix("Expected: "));
        secrets.extend(expected.map(ToOwned::to_owned));
    }
    // A small number or a name can stand anywhere. How many frames a motion has is no secret.
    let is_long = |secret: &String| secret.contains(|c: char| c.is_ascii_digit()) && secret.len() >= 8;
    let tells = |secret: &String| is_long(secret) && !secret.ends_with(" frames");
    secrets.into_iter().filter(tells).collect()
}

fn expected(case: &Case, wrong: &Answer) -> Option<String> {
    Some((case.difference)(case, &case.expected, wrong)?.expected)
}

fn solution(exercise: &Exercise) -> String {
    let solutions = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../solutions/src");
    fs::read_to_string(solutions.join(exercise.file())).unwrap()
}

/// The points of each part.
fn points(results: &Value, id: &str) -> Vec<u64> {
    let record = results["records"].as_array().unwrap().iter().find(|record| record["id"] == id).unwrap();
    let parts = record["verdict"]["parts"].as_array().unwrap();
    parts.iter().map(|part| part["points"].as_u64().unwrap()).collect()
}
