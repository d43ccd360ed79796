//! From what grading found to what is written down.
//!
//! What a student reads tells no inputs and no right answers: the questions are secret. A panic's own words can hold
//! inputs too, so that students read them only where they are the standard library's.

use exam::Failure;
use grading::{CheckReport, CheckState, FirstCase, PartReport, PartState, Trouble, WholeReport};
use results::{CheckResult, Named, PartResult, Verdict, Whole};

use crate::diagnostics::clean;
use crate::mark::Marked;

/// Characters that are kept of what only the teaching assistant reads.
const MOST_CHARACTERS: usize = 2000;

/// The verdict on a submission that was asked. Trouble in asking is never a zero.
pub fn of(marked: &Marked) -> Verdict {
    let checks = marked.parts.iter().flat_map(|part| &part.checks);
    let failures = checks.filter_map(|check| match &check.state {
        CheckState::Failed { failure, .. } => Some(failure),
        CheckState::Right | CheckState::Wrong(_) => None,
    });
    let whole = match &marked.whole.trouble {
        Some(Trouble::Failed(failure)) => Some(failure),
        _ => None,
    };
    let trouble = failures.chain(whole).find(|failure| matches!(failure, Failure::NoAnswer { .. }));
    if let Some(trouble) = trouble {
        return Verdict::HarnessError { what: trouble.to_string() };
    }
    Verdict::Graded {
        parts: marked.parts.iter().map(part).collect(),
        whole: Some(whole_result(&marked.whole)),
        picture: marked.picture.clone(),
    }
}

fn part(report: &PartReport) -> PartResult {
    let named = report.named.iter().map(|named| Named {
        id: named.id.to_owned(),
        title: named.title.to_owned(),
        explanation: named.explanation.to_owned(),
        hint: named.hint.to_owned(),
    });
    PartResult {
        id: report.rubric.id.to_owned(),
        points: report.points(),
        of: report.rubric.points(),
        state: state(report.state),
        checks: report.checks.iter().map(|check| check_result(check, report.state)).collect(),
        named: named.collect(),
        remark: report.remark.map(str::to_owned),
    }
}

fn state(state: PartState) -> results::PartState {
    match state {
        PartState::NotStarted => results::PartState::NotStarted,
        PartState::Wrong => results::PartState::Wrong,
        PartState::PartlyRight => results::PartState::PartlyRight,
        PartState::Right => results::PartState::Right,
        PartState::Panicked => results::PartState::Panicked,
        PartState::TimedOut => results::PartState::TimedOut,
        // What could not be asked has become a verdict of its own before.
        PartState::Crashed | PartState::NotAsked => results::PartState::Crashed,
    }
}

fn check_result(check: &CheckReport, part: PartState) -> CheckResult {
    let of = check.rubric.points;
    let (state, note, private_note) = match &check.state {
        CheckState::Right => (results::CheckState::Right, String::new(), String::new()),
        CheckState::Wrong(first) => (results::CheckState::Wrong, wrong(first), first_case(first)),
        CheckState::Failed { failure, inputs } => {
            (results::CheckState::Stopped, stopped(failure), format!("{failure} ({})", list(inputs)))
        }
    };
    let is_right = state == results::CheckState::Right && part != PartState::NotStarted;
    CheckResult {
        id: check.rubric.id.to_owned(),
        points: if is_right { of } else { 0 },
        of,
        state,
        note,
        private_note: clean(&private_note, MOST_CHARACTERS),
    }
}

fn wrong(first: &FirstCase) -> String {
    let FirstCase { wrong, cases, groups, .. } = first;
    let are = if *wrong == 1 { "is" } else { "are" };
    if groups.is_empty() {
        format!("{wrong} of {cases} cases {are} wrong")
    } else {
        format!("{wrong} of {cases} cases {are} wrong; only these are wrong: {}", groups.join(", "))
    }
}

fn first_case(first: &FirstCase) -> String {
    let difference = &first.difference;
    let (got, expected, between) = (&difference.got, &difference.expected, &difference.between);
    format!("{}; got {got}, expected {expected}, difference {between}", list(&first.inputs))
}

fn list(inputs: &[(String, String)]) -> String {
    let inputs: Vec<String> = inputs.iter().map(|(name, value)| format!("{name} {value}")).collect();
    inputs.join("; ")
}

/// A failure in words for the student.
fn stopped(failure: &Failure) -> String {
    let Failure::Panicked { message, location } = failure else { return failure.to_string() };
    let place = match location.as_deref().filter(|location| location.starts_with("exercises/")) {
        Some(location) => format!("your code panicked at {}", clean(location, 200)),
        None => "your code panicked inside a library's function".to_owned(),
    };
    match library_panic(message) {
        Some(words) => format!("{place}: {words}"),
        None => place,
    }
}

/// The words of a panic that the language or its library raises, without what was computed.
fn library_panic(message: &str) -> Option<&'static str> {
    const WHOLE: [&str; 12] = [
        "attempt to add with overflow",
        "attempt to subtract with overflow",
        "attempt to multiply with overflow",
        "attempt to negate with overflow",
        "attempt to divide by zero",
        "attempt to calculate the remainder with a divisor of zero",
        "called `Option::unwrap()` on a `None` value",
        "not implemented",
        "not yet implemented",
        "explicit panic",
        "internal error: entered unreachable code",
        "index out of bounds",
    ];
    let message = if message.starts_with("index out of bounds: the len is ") { WHOLE[11] } else { message };
    WHOLE.into_iter().find(|known| *known == message)
}

fn whole_result(report: &WholeReport) -> Whole {
    let note = match &report.trouble {
        None => String::new(),
        Some(Trouble::Failed(failure)) => stopped(failure),
        Some(Trouble::Different { summary, .. }) => summary.clone(),
        Some(Trouble::Off { worst, first, frame, .. }) => {
            format!("{worst}; in frame {frame} the first wrong joint is {first}")
        }
    };
    Whole { frames: report.frames, right: report.trouble.is_none(), note }
}
