//! The table of all students: a body of two rows for each, what is seen at once and what can be opened.

use std::collections::HashMap;

use maud::{Markup, PreEscaped, html};

use super::details::details;
use super::figure::View;
use super::statistics::Statistics;
use crate::book::{Book, Entry};
use crate::grades::misconceptions;
use crate::page::{prose, state_mark, theirs};
use crate::{Flag, Points, Record, Standing, Verdict};

pub(super) const START: &str = r#"<main id="students"><h2>Students</h2>"#;
pub(super) const END: &str = concat!(
    "</table>",
    r#"<p class="more-rows"><button type="button" id="more" hidden>Show more</button></p></main>"#
);

/// The statuses in the order in which they are offered.
const STATUSES: [(&str, &str); 6] = [
    ("graded", "graded"),
    ("does-not-compile", "does not compile"),
    ("too-expensive-to-compile", "stopped the compiler"),
    ("rejected", "rejected"),
    ("harness-error", "harness error"),
    ("missing", "missing"),
];

/// What else can be filtered for.
const KINDS: [(&str, &str); 4] =
    [("eye", "needs your eye"), ("changed", "changed by hand"), ("late", "late"), ("alike", "like others")];

/// The search, the filter and the table's head.
pub(super) fn head(book: &Book<'_>, statistics: &Statistics) -> Markup {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for kind in book.entries.iter().flat_map(|entry| kinds(entry, statistics)) {
        *counts.entry(kind).or_default() += 1;
    }
    let of = book.run.points();
    html! {
        form.tools role="search" {
            label {
                span { "Search" }
                input #search type="search" autocomplete="off" spellcheck="false" placeholder="name, number, misconception …";
            }
            label {
                span { "Show" }
                select #filter {
                    option value="" { "everybody (" (book.entries.len()) ")" }
                    @for (kind, name) in STATUSES.into_iter().chain(KINDS) {
                        @if let Some(count) = counts.get(kind) {
                            option value=(kind) { (name) " (" (count) ")" }
                        }
                    }
                }
            }
            p #shown role="status" {}
        }
        noscript {
            p.note { "Without its script this page does not sort, search or open details; the folder `feedback` has most of them." }
        }
        (PreEscaped(r#"<table id="all">"#))
        caption.unseen { "All students with their points. The buttons in the head sort." }
        thead {
            tr {
                (column("Student", "text", ""))
                (column(&format!("Points of {of}"), "number", "number"))
                @for part in &book.run.parts {
                    (column(&format!("{} of {}", part.id, part.points), "number", "number part"))
                }
                (column("Status", "text", ""))
                (column("Remarks", "text", "remarks"))
                @if book.run.reference_picture.is_some() { th.drawing scope="col" { "Pose" } }
            }
        }
    }
}

fn column(name: &str, kind: &str, class: &str) -> Markup {
    html! { th scope="col" class=[Some(class).filter(|class| !class.is_empty())] aria-sort="none" { button type="button" data-kind=(kind) { (name) } } }
}

/// How many columns there are.
fn width(book: &Book<'_>) -> usize {
    4 + book.run.parts.len() + usize::from(book.run.reference_picture.is_some())
}

/// One student.
pub(super) fn row(
    book: &Book<'_>,
    statistics: &Statistics,
    entry: &Entry,
    record: &Record,
    view: &View,
) -> Markup {
    let id = &entry.id;
    let mark = &entry.mark;
    let groups = statistics.groups.get(id).map_or(&[][..], Vec::as_slice);
    let status = status(record);
    html! {
        tbody.one #{ "r-" (id) } data-kinds=(kinds(entry, statistics).join(" ")) {
            tr {
                th scope="row" {
                    button.open type="button" aria-expanded="false" aria-controls={ "d-" (id) } { (theirs(&entry.shown_name())) }
                    @if let Some(number) = &record.student.number {
                        @if *number != entry.shown_name() { span.sub { (theirs(number)) } }
                    }
                }
                td.number data-value=(sortable(mark.points)) {
                    (shown(mark.points))
                    @if let Some(late) = &mark.late { span.sub { "−" (late.percent) " %" } }
                    @if mark.changes.iter().any(|change| change.to.is_some()) { span.sub { "changed" } }
                    @if mark.points.is_some() && !mark.counts { span.sub.trouble { "does not count" } }
                }
                @for part in &mark.parts {
                    td.number.part data-value=(sortable(*part)) { (shown(*part)) }
                }
                td { (state_mark(status)) }
                td.remarks {
                    @for one in misconceptions(&record.verdict) { code.chip { (one) } " " }
                    @for words in remarks(entry) { span.chip.trouble { (words) } " " }
                    @for group in groups { a.chip href={ "#g-" (group) } { "like others" } " " }
                }
                @if book.run.reference_picture.is_some() {
                    td.drawing {
                        @if let Verdict::Graded { picture: Some(picture), .. } = &record.verdict { (view.small(picture)) }
                    }
                }
            }
            tr.details #{ "d-" (id) } hidden {
                td colspan=(width(book)) {
                    script type="text/plain" { (details(book, entry, record, view)) }
                }
            }
        }
    }
}

/// What the filter knows of an entry.
fn kinds(entry: &Entry, statistics: &Statistics) -> Vec<&'static str> {
    let mark = &entry.mark;
    let mut kinds = vec![entry.code];
    let undecided = |flag: &Flag| match flag {
        Flag::OtherSubmissions { standing, .. } => *standing == Standing::Undecided,
        Flag::NotOnRoster | Flag::NameDiffers { .. } | Flag::LateButNotListed => true,
    };
    let troubled = matches!(entry.code, "harness-error" | "rejected" | "too-expensive-to-compile");
    if mark.flags.iter().any(undecided) || (troubled && mark.changes.is_empty()) {
        kinds.push("eye");
    }
    if !mark.changes.is_empty() {
        kinds.push("changed");
    }
    if mark.late.is_some() {
        kinds.push("late");
    }
    if statistics.groups.contains_key(&entry.id) {
        kinds.push("alike");
    }
    kinds
}

/// A graded submission stands as its best part does not say: all, some or nothing of it is right.
fn status(record: &Record) -> &'static str {
    match &record.verdict {
        Verdict::Graded { parts, .. } => {
            use crate::PartState::{NotStarted, Right};
            let all = |state| parts.iter().all(|part| part.state == state);
            match (all(Right), all(NotStarted), parts.iter().any(|part| part.points > 0)) {
                (true, ..) => "right",
                (_, true, _) => "not started",
                (.., true) => "partly right",
                (.., false) => "wrong",
            }
        }
        Verdict::DoesNotCompile { .. } => "does not compile",
        Verdict::TooExpensiveToCompile { .. } => "stopped the compiler",
        Verdict::Rejected { .. } => "rejected",
        Verdict::Missing => "missing",
        Verdict::HarnessError { .. } => "harness error",
    }
}

fn remarks(entry: &Entry) -> Vec<&'static str> {
    let words = |flag: &Flag| match flag {
        Flag::NotOnRoster => "not on the roster",
        Flag::NameDiffers { .. } => "other name",
        Flag::LateButNotListed => "late?",
        Flag::OtherSubmissions { standing: Standing::Undecided, .. } => "several, undecided",
        Flag::OtherSubmissions { .. } => "several",
    };
    entry.mark.flags.iter().map(words).collect()
}

fn shown(points: Option<Points>) -> Markup {
    html! {
        @match points {
            Some(points) => { (points) }
            None => { span.none title="no points" { "–" } }
        }
    }
}

fn sortable(points: Option<Points>) -> String {
    points.map_or("-1".to_owned(), |points| points.to_string())
}

/// Text that has backticks in it, for the details.
pub(super) fn sentence(text: &str) -> Markup {
    html! { p { (prose(text)) } }
}
