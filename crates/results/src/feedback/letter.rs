//! The words to a student, in whatever form they are written.

use crate::text::{count, one_line};
use crate::{
    CheckResult, CheckState, CompileError, Flag, Mark, Named, PartInfo, PartResult, PartState, Points,
    Record, RunInfo, Standing, Verdict,
};

/// What is said to one student.
pub(super) struct Letter {
    /// The exercise and the points.
    pub title: String,
    /// Whose it is, and which file.
    pub whose: Vec<String>,
    pub sections: Vec<Section>,
}

pub(super) struct Section {
    /// Empty for the first.
    pub heading: String,
    pub blocks: Vec<Block>,
}

pub(super) enum Block {
    Text(Vec<Span>),
    Item(Vec<Span>),
    Checks(Vec<Line>),
    Code(String),
    Named(Named),
}

/// A piece of text.
pub(super) enum Span {
    /// Our own words, in which backticks mark code.
    Ours(String),
    /// Words that anybody may have written.
    Theirs(String),
}

/// One check in a table.
pub(super) struct Line {
    pub state: CheckState,
    pub points: String,
    pub title: String,
    pub note: String,
}

pub(super) fn letter(run: &RunInfo, record: &Record, mark: &Mark) -> Letter {
    let of = run.points();
    let title = match mark.points {
        Some(points) => format!("{}: {points} of {of} points", run.title),
        None => format!("{}: no points yet", run.title),
    };
    let student = &record.student;
    let whose = [Some(student.name.as_str()), student.number.as_deref(), Some(record.file.as_str())];
    let whose = whose.into_iter().flatten().map(one_line).filter(|text| !text.is_empty()).collect();
    let mut first = opening(run, record);
    if !record.remarks.is_empty() {
        first.extend(record.remarks.iter().map(|remark| Block::Text(vec![theirs(remark)])));
    }
    let mut sections = vec![Section { heading: String::new(), blocks: first }];
    let changed = how_points_came_about(mark);
    if !changed.is_empty() {
        sections.push(Section { heading: "How your points came about".to_owned(), blocks: changed });
    }
    if let Verdict::Graded { parts, whole, .. } = &record.verdict {
        sections.extend(run.parts.iter().enumerate().filter_map(|(index, info)| {
            let part = parts.iter().find(|part| part.id == info.id)?;
            Some(part_section(info, part, mark.parts.get(index).copied().flatten()))
        }));
        if let Some(whole) = whole {
            let frames = count(whole.frames, "frame");
            let text = match whole.right {
                true => ours(format!("Together your functions are right over a whole motion of {frames}.")),
                false if whole.note.is_empty() => {
                    ours("Together your functions are not yet right over a whole motion.")
                }
                false => theirs(&whole.note),
            };
            let blocks = vec![Block::Text(vec![text]), Block::Text(vec![ours("This gives no points.")])];
            sections.push(Section { heading: "All parts together".to_owned(), blocks });
        }
    }
    Letter { title, whose, sections }
}

/// What became of the submission as a whole.
fn opening(run: &RunInfo, record: &Record) -> Vec<Block> {
    let text = |words: &str| Block::Text(vec![ours(words)]);
    match &record.verdict {
        Verdict::Graded { parts, .. } => {
            let all = parts.iter().all(|part| part.state == PartState::Right);
            let begun = parts.iter().any(|part| part.state != PartState::NotStarted);
            let words = match (all, begun) {
                (true, _) => "Every check is right. Well done!",
                (false, true) => {
                    "Each part was checked by itself, so that a mistake in one costs nothing in another. \
                     Here is what each check found."
                }
                (false, false) => {
                    "The file answers like the untouched template. If that surprises you, look whether you handed in \
                     the right file."
                }
            };
            vec![text(words)]
        }
        Verdict::DoesNotCompile { errors, left_out } => does_not_compile(run, errors, *left_out),
        Verdict::TooExpensiveToCompile { limit, .. } => vec![
            Block::Text(vec![
                ours("The compiler did not finish with your file and was stopped (the limit: "),
                theirs(limit),
                ours("). So nothing in it could be checked."),
            ]),
            text(
                "This happens with code that makes the compiler do the work: very large constants, macros that call \
                 themselves, types inside types. The exercise needs nothing of the kind.",
            ),
        ],
        Verdict::Rejected { why, .. } => vec![
            text("What you handed in could not be marked:"),
            Block::Text(vec![theirs(why)]),
            text("If you think that this is wrong, tell your teaching assistant."),
        ],
        Verdict::Missing => vec![text("You handed in nothing.")],
        Verdict::HarnessError { .. } => vec![text(
            "Your submission could not be marked because something went wrong on our side. That is not your fault, and it \
             costs you nothing: your teaching assistant will see to it.",
        )],
    }
}

fn does_not_compile(run: &RunInfo, errors: &[CompileError], left_out: usize) -> Vec<Block> {
    let exercise = &run.exercise;
    let mut blocks = vec![Block::Text(vec![ours(format!(
        "Your file does not compile, so nothing in it could be checked. Often it is a small thing: put your file into \
         the exercise again and run `cargo test -p {exercise}`, which shows the same messages."
    ))])];
    for error in errors {
        let place = match (error.line, error.column) {
            (Some(line), Some(column)) => format!("Line {line}, column {column}: "),
            (Some(line), None) => format!("Line {line}: "),
            _ => String::new(),
        };
        blocks.push(Block::Text(vec![ours(place), theirs(&error.message)]));
        if !error.text.trim().is_empty() {
            blocks.push(Block::Code(error.text.clone()));
        }
    }
    if left_out > 0 {
        let more = format!("There are {left_out} more. They often go away when the first ones do.");
        blocks.push(Block::Text(vec![ours(more)]));
    }
    blocks
}

fn how_points_came_about(mark: &Mark) -> Vec<Block> {
    let mut items = Vec::new();
    let shown = |points: Option<Points>| points.map_or("no points".to_owned(), |points| points.to_string());
    // The total is decided after everything else.
    let (totals, others): (Vec<_>, Vec<_>) = mark.changes.iter().partition(|change| change.what == "total");
    for change in others {
        let words = match change.to {
            Some(to) => {
                format!(
                    "Your teaching assistant changed `{}` from {} to {to}: ",
                    change.what,
                    shown(change.from)
                )
            }
            None => "Your teaching assistant decided that this submission counts: ".to_owned(),
        };
        items.push(Block::Item(vec![ours(words), theirs(&change.reason)]));
    }
    if let Some(late) = &mark.late {
        let (days, left) = (count(late.days as usize, "day"), shown(mark.points));
        let (percent, from) = (late.percent, late.from);
        let words =
            format!("It came {days} late: {percent} % of {from} points are taken off, which leaves {left}.");
        items.push(Block::Item(vec![ours(words)]));
    }
    for change in totals {
        let (from, to) = (shown(change.from), shown(change.to));
        let words = format!("Your teaching assistant changed the whole from {from} to {to}: ");
        items.push(Block::Item(vec![ours(words), theirs(&change.reason)]));
    }
    for flag in &mark.flags {
        let Flag::OtherSubmissions { standing, .. } = flag else { continue };
        items.push(Block::Item(vec![ours(match standing {
            Standing::Agree => "You handed in more than once. All have the same points, which count once.",
            Standing::Undecided => {
                "You handed in more than once, with different points. Your teaching assistant will say which one counts."
            }
            Standing::Chosen => "You handed in more than once. This one counts.",
            Standing::NotChosen => "You handed in more than once. Another one counts.",
        })]));
    }
    items
}

fn part_section(info: &PartInfo, part: &PartResult, points: Option<Points>) -> Section {
    let checked = Points::whole(part.points);
    let points = points.unwrap_or(checked);
    let state = if points == checked { part.state.name() } else { "changed by hand" };
    let heading = format!("{}: `{}`, {points} of {} points, {state}", info.id, info.function, part.of);
    let mut blocks = Vec::new();
    if part.state == PartState::NotStarted {
        blocks.push(Block::Text(vec![ours(
            "Your function answers like the untouched template, so it has no points yet. The comment above it says what it \
             should do.",
        )]));
    } else {
        blocks.push(Block::Checks(part.checks.iter().map(|check| line(info, check)).collect()));
    }
    blocks.extend(part.named.iter().cloned().map(Block::Named));
    let wrong = part.checks.iter().any(|check| check.state == CheckState::Wrong);
    if wrong && part.named.is_empty() && part.state != PartState::NotStarted {
        blocks.push(Block::Text(vec![ours(
            "What is wrong matches none of the mistakes that we know. `cargo test` shows the first wrong case of its own \
             questions beside your answer.",
        )]));
    }
    if let Some(remark) = &part.remark {
        blocks.push(Block::Text(vec![ours(remark.clone())]));
    }
    Section { heading, blocks }
}

fn line(info: &PartInfo, check: &CheckResult) -> Line {
    let title = info.checks.iter().find(|known| known.id == check.id).map_or(&check.id, |known| &known.title);
    Line {
        state: check.state,
        points: format!("{} of {}", check.points, check.of),
        title: title.clone(),
        note: check.note.clone(),
    }
}

fn ours(words: impl Into<String>) -> Span {
    Span::Ours(words.into())
}

fn theirs(words: &str) -> Span {
    Span::Theirs(one_line(words))
}
