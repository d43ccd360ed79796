//! Putting the questions, and judging the answers.

use std::time::Duration;

use exam::{Answer, Failure, Functions, Subject};

use crate::{
    Case, CheckPaper, CheckReport, CheckState, FirstCase, Misconception, Named, PartPaper, PartReport,
    PartState, WholeMotion, WholeReport,
};

/// Asks `subject` everything about one part. Each check has `limit` for all its cases together; when a case fails or
/// the time is over, the check is lost and the next one is asked. Once the time was over, the checks that follow have
/// less of it: what loops once mostly loops again.
pub fn grade_part(subject: &mut dyn Subject, part: &PartPaper, limit: Duration) -> PartReport {
    let full_limit = limit;
    let mut limit = limit;
    let mut answers: Vec<CheckAnswers> = Vec::new();
    for check in &part.checks {
        let given = ask(subject, check, limit);
        if matches!(given.failure, Some(Failure::TimedOut { .. })) {
            limit = after_time_out(full_limit);
        }
        answers.push(given);
    }
    let exact = judge(part, &answers, &|case| case.expected.clone());
    let (checks, remark) = best_of(part, &answers, exact);
    let state = state(part, &answers, &checks);
    // Some misconceptions answer like the template. Who has not started has none.
    let is_started = state != PartState::NotStarted;
    let named = if is_started { recognise(part, &answers, &checks) } else { Vec::new() };
    PartReport { rubric: part.rubric, state, named, checks, remark }
}

/// Asks `subject` what all parts together make of a motion.
pub fn grade_whole_motion(subject: &mut dyn Subject, whole: &WholeMotion, limit: Duration) -> WholeReport {
    match subject.ask(&whole.question, limit) {
        Ok(answer) => whole.judge.judge(&answer),
        Err(failure) => WholeReport::failed(failure),
    }
}

/// How long a check may take when another one had `limit` and was not ready.
pub fn after_time_out(limit: Duration) -> Duration {
    // A worker has to be started in this time, too, on a machine that may be busy.
    (limit / 10).max(Duration::from_millis(500)).min(limit)
}

/// The answers to a check's cases, up to the first that failed.
struct CheckAnswers {
    answers: Vec<Answer>,
    failure: Option<Failure>,
}

fn ask(subject: &mut dyn Subject, check: &CheckPaper, limit: Duration) -> CheckAnswers {
    let questions: Vec<_> = check.cases.iter().map(|case| &case.question).collect();
    let (answers, failure) = subject.ask_all(&questions, limit);
    // What counts is the check's time, of which the last case had the rest.
    let failure = failure.map(|failure| match failure {
        Failure::TimedOut { .. } => Failure::TimedOut { limit },
        other => other,
    });
    CheckAnswers { answers, failure }
}

/// Compares all answers with what `expected` gives for each case.
fn judge(part: &PartPaper, answers: &[CheckAnswers], expected: &dyn Fn(&Case) -> Answer) -> Vec<CheckReport> {
    let pairs = part.checks.iter().zip(answers);
    pairs
        .map(|(check, given)| CheckReport {
            rubric: check.rubric,
            state: judge_check(check, given, expected),
        })
        .collect()
}

fn judge_check(check: &CheckPaper, given: &CheckAnswers, expected: &dyn Fn(&Case) -> Answer) -> CheckState {
    if let Some(failure) = &given.failure {
        let inputs = check.cases.get(given.answers.len()).map(|case| case.inputs.clone());
        return CheckState::Failed { failure: failure.clone(), inputs: inputs.unwrap_or_default() };
    }
    let mut first = None;
    let mut wrong: Vec<&Case> = Vec::new();
    let mut right: Vec<&Case> = Vec::new();
    for (case, answer) in check.cases.iter().zip(&given.answers) {
        match (case.difference)(case, &expected(case), answer) {
            None => right.push(case),
            Some(difference) => {
                first.get_or_insert((case, difference));
                wrong.push(case);
            }
        }
    }
    let Some((case, difference)) = first else { return CheckState::Right };
    CheckState::Wrong(FirstCase {
        inputs: case.inputs.clone(),
        difference,
        groups: wrong_groups(&wrong, &right),
        wrong: wrong.len(),
        cases: check.cases.len(),
    })
}

/// The groups that have wrong cases, if there are others that have none.
fn wrong_groups(wrong: &[&Case], right: &[&Case]) -> Vec<String> {
    let mut groups: Vec<String> = wrong.iter().filter_map(|case| case.group.clone()).collect();
    groups.dedup();
    let is_all_right = |case: &&Case| case.group.as_ref().is_some_and(|group| !groups.contains(group));
    if right.iter().any(is_all_right) { groups } else { Vec::new() }
}

/// The judgement by the exact reference, or by an accepted way where that gives more points.
fn best_of(
    part: &PartPaper,
    answers: &[CheckAnswers],
    exact: Vec<CheckReport>,
) -> (Vec<CheckReport>, Option<&'static str>) {
    let right = |checks: &[CheckReport]| -> u32 {
        checks.iter().filter(|check| is_right(check)).map(|check| check.rubric.points).sum()
    };
    let mut best = (exact, None);
    for accepted in &part.accepted {
        let checks = judge(part, answers, &|case| case.question.ask(&accepted.functions));
        if right(&checks) > right(&best.0) {
            best = (checks, Some(accepted.remark));
        }
    }
    best
}

fn is_right(check: &CheckReport) -> bool {
    matches!(check.state, CheckState::Right)
}

fn state(part: &PartPaper, answers: &[CheckAnswers], checks: &[CheckReport]) -> PartState {
    if answered_like(part, answers, &part.template) {
        return PartState::NotStarted;
    }
    let right = checks.iter().filter(|check| is_right(check)).count();
    if right == checks.len() {
        return PartState::Right;
    }
    if right > 0 {
        return PartState::PartlyRight;
    }
    let failure = checks.iter().find_map(|check| match &check.state {
        CheckState::Failed { failure, .. } => Some(failure),
        CheckState::Right | CheckState::Wrong(_) => None,
    });
    match failure {
        None => PartState::Wrong,
        Some(Failure::Panicked { .. }) => PartState::Panicked,
        Some(Failure::TimedOut { .. }) => PartState::TimedOut,
        Some(Failure::Crashed { .. } | Failure::Unreadable { .. }) => PartState::Crashed,
        Some(Failure::NoAnswer { .. }) => PartState::NotAsked,
    }
}

/// Whether the part answers as `functions` do, whatever the other parts do.
fn answered_like(part: &PartPaper, answers: &[CheckAnswers], functions: &Functions) -> bool {
    part.checks.iter().zip(answers).all(|(check, given)| {
        given.failure.is_none()
            && check
                .cases
                .iter()
                .zip(&given.answers)
                .all(|(case, answer)| answer.of_its_part() == case.question.ask(functions).of_its_part())
    })
}

/// The misconceptions whose answers are the student's, in all checks where they can be seen.
fn recognise(part: &PartPaper, answers: &[CheckAnswers], checks: &[CheckReport]) -> Vec<Named> {
    let is_seen = |misconception: &&Misconception| {
        let seen = |id| misconception.seen_in.contains(id);
        let indices: Vec<usize> = (0..checks.len()).filter(|&index| seen(&checks[index].rubric.id)).collect();
        let all_answered = indices.iter().all(|&index| answers[index].failure.is_none());
        let any_wrong = indices.iter().any(|&index| !is_right(&checks[index]));
        all_answered
            && any_wrong
            && misconception.variants.iter().any(|variant| {
                indices.iter().all(|&index| answers_are(&part.checks[index], &answers[index], variant))
            })
    };
    let named = |misconception: &Misconception| {
        let Misconception { id, title, explanation, hint, costs, .. } = *misconception;
        // It explains all that it costs, also where its answers could not be compared.
        Named { id, title, explanation, hint, seen_in: costs }
    };
    part.misconceptions.iter().filter(is_seen).map(named).collect()
}

fn answers_are(check: &CheckPaper, given: &CheckAnswers, variant: &Functions) -> bool {
    check.cases.iter().zip(&given.answers).all(|(case, answer)| {
        let variants = case.question.ask(variant);
        (case.difference)(case, &variants, answer).is_none()
    })
}
