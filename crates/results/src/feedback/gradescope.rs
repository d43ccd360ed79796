//! A result for Gradescope.

use serde_json::{Value, json};

use super::letter::letter;
use super::markdown;
use crate::{CheckState, Mark, PartResult, Record, RunInfo, Verdict};

/// What Gradescope's `results.json` holds for one submission: a test per check, with the words that the student reads.
///
/// Everything in it is for the student; nothing is hidden, because hidden tests would hide the total too. Where there are no points
/// (trouble that is not the student's) there is no score either, which Gradescope reports as an autograder that failed.
pub fn gradescope(run: &RunInfo, record: &Record) -> Value {
    let points = record.points();
    let mark = Mark { points: points.map(crate::Points::whole), ..Mark::default() };
    let letter = letter(run, record, &mark);
    let mut tests = Vec::new();
    if let Verdict::Graded { parts, .. } = &record.verdict {
        for part in parts {
            tests.extend(part.checks.iter().map(|check| {
                json!({
                    "name": name(run, part, &check.id),
                    "score": check.points,
                    "max_score": check.of,
                    "status": if check.points == check.of { "passed" } else { "failed" },
                    "output": output(part.state == crate::PartState::NotStarted, check),
                    "output_format": "md",
                })
            }));
        }
    }
    let mut result = json!({
        // The checks are tests of their own.
        "output": letter.sections.iter().map(markdown::without_checks).collect::<Vec<_>>().join("\n\n"),
        "output_format": "md",
        "test_name_format": "text",
        "stdout_visibility": "hidden",
        "tests": tests,
    });
    if let Some(points) = points {
        result["score"] = points.into();
    }
    result
}

fn name(run: &RunInfo, part: &PartResult, check: &str) -> String {
    let info = run.parts.iter().find(|info| info.id == part.id);
    let title = info.and_then(|info| info.checks.iter().find(|known| known.id == check));
    let function = info.map_or("", |info| &info.function);
    format!("{} {function}: {}", part.id, title.map_or(check, |known| &known.title))
}

fn output(not_started: bool, check: &crate::CheckResult) -> String {
    match (not_started, check.state, check.note.is_empty()) {
        (true, ..) => "not started".to_owned(),
        (false, CheckState::Right, true) => "right".to_owned(),
        (false, state, true) => state.name().to_owned(),
        (false, _, false) => crate::text::markdown(&check.note),
    }
}
