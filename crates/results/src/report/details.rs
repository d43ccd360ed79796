//! What opens under a student: every verdict with its reason, also what only the teaching assistant may read.

use maud::{Markup, html};

use super::figure::View;
use super::rows::sentence;
use crate::book::{Book, Entry};
use crate::grades::{flags, reason};
use crate::page::{prose, state_mark, their_block, theirs};
use crate::{CheckResult, Mark, PartInfo, PartResult, Points, Record, Verdict};

pub(super) fn details(book: &Book<'_>, entry: &Entry, record: &Record, view: &View) -> Markup {
    let picture = match &record.verdict {
        Verdict::Graded { picture, .. } => picture.as_ref(),
        _ => None,
    };
    html! {
        div.beside {
            div { (words(book, entry, record)) (file(entry, record)) }
            @if let Some(picture) = picture { (view.side_by_side(picture)) }
        }
    }
}

fn words(book: &Book<'_>, entry: &Entry, record: &Record) -> Markup {
    html! {
        (how_points_came_about(&entry.mark))
        @match &record.verdict {
            Verdict::Graded { parts, whole, .. } => {
                @for part in parts {
                    @if let Some(info) = book.run.parts.iter().find(|info| info.id == part.id) { (part_details(info, part)) }
                }
                @if let Some(whole) = whole {
                    h3 { "All parts together" }
                    @if whole.right { (sentence("Right over a whole motion.")) }
                    @else { p { (theirs(&whole.note)) } }
                }
            }
            Verdict::DoesNotCompile { errors, left_out } => {
                @for error in errors {
                    h3 {
                        @if let Some(line) = error.line { "Line " (line) ": " }
                        (theirs(&error.message))
                    }
                    (their_block(&error.text))
                }
                @if *left_out > 0 { p { (left_out) " more errors are left out." } }
            }
            Verdict::TooExpensiveToCompile { text, .. } => {
                p { (theirs(&reason(record))) }
                @if !text.is_empty() { (their_block(text)) }
            }
            Verdict::Rejected { .. } | Verdict::Missing => { p { (theirs(&reason(record))) } }
            Verdict::HarnessError { what } => {
                (sentence("Not the student's fault: there are no points until this submission is marked again."))
                (their_block(what))
            }
        }
    }
}

fn part_details(info: &PartInfo, part: &PartResult) -> Markup {
    html! {
        h3 { (info.id) ": " code { (info.function) } ", " (part.points) " of " (part.of) ", " (state_mark(part.state.name())) }
        table.checks {
            caption.unseen { "Checks of " (info.id) }
            thead { tr { th scope="col" { "Result" } th scope="col" { "Points" } th scope="col" { "Check" } } }
            tbody { @for check in &part.checks { (check_details(info, check)) } }
        }
        @for named in &part.named {
            div.named {
                p { strong { (prose(&named.title)) } " " code { (named.id) } }
                p { (prose(&named.explanation)) " " strong { "Hint: " } (prose(&named.hint)) }
            }
        }
        @if let Some(remark) = &part.remark { (sentence(remark)) }
    }
}

fn check_details(info: &PartInfo, check: &CheckResult) -> Markup {
    let title = info.checks.iter().find(|known| known.id == check.id).map_or(&check.id, |known| &known.title);
    html! {
        tr {
            td { (state_mark(check.state.name())) }
            td.number { (check.points) " of " (check.of) }
            td {
                (prose(title))
                @if !check.note.is_empty() { p.note { (theirs(&check.note)) } }
                @if !check.private_note.is_empty() { (their_block(&check.private_note)) }
            }
        }
    }
}

fn how_points_came_about(mark: &Mark) -> Markup {
    let shown = |points: Option<Points>| points.map_or("no points".to_owned(), |points| points.to_string());
    html! {
        @if !mark.changes.is_empty() || mark.late.is_some() {
            h3 { "How the points came about" }
            ul {
                li { "The checks gave " (shown(mark.checked)) "." }
                @for change in mark.changes.iter().filter(|change| change.what != "total") { (one_change(change, &shown)) }
                @if let Some(late) = &mark.late {
                    li { (late.days) " days late: " (late.percent) " % off " (late.from) " leaves " (late.from.less(late.percent)) "." }
                }
                @for change in mark.changes.iter().filter(|change| change.what == "total") { (one_change(change, &shown)) }
            }
        }
    }
}

fn one_change(change: &crate::Change, shown: &dyn Fn(Option<Points>) -> String) -> Markup {
    html! {
        li {
            code { (change.what) }
            @if change.to.is_some() { " changed from " (shown(change.from)) " to " (shown(change.to)) }
            ": " (theirs(&change.reason))
        }
    }
}

/// What was marked, and how it was confined.
fn file(entry: &Entry, record: &Record) -> Markup {
    html! {
        dl.facts {
            @for words in flags(entry) { dt { "Mind" } dd { (theirs(&words)) } }
            @for remark in &record.remarks { dt { "Remark" } dd { (theirs(remark)) } }
            dt { "Submission" } dd { code { (entry.id) } @if !record.file.is_empty() { ", " (theirs(&record.file)) } }
            @if let Some(sha256) = &record.sha256 { dt { "SHA-256" } dd { code { (sha256) } } }
            @if !record.sandbox.is_empty() { dt { "Confined by" } dd { (theirs(&record.sandbox)) } }
        }
    }
}
