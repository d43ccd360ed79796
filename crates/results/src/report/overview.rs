//! What stands above the table of students, and below it.

use std::collections::HashMap;

use maud::{Markup, html};

use super::charts::{bar, distribution};
use super::figure::View;
use super::statistics::{Misconception, Statistics};
use crate::book::Book;
use crate::page::{prose, theirs};
use crate::text::count;
use crate::write::Attention;

pub(super) fn top(book: &Book<'_>, statistics: &Statistics, attention: &[Attention], view: &View) -> Markup {
    let run = book.run;
    html! {
        (view.shared())
        header.top {
            p.kicker { "Results · " code { (run.exercise) } @if let Some(shard) = run.shard { " · share " (shard.index + 1) " of " (shard.count) } }
            h1 { (run.title) }
            @if !run.sandboxed {
                p.banner role="alert" {
                    strong { "Marked without a sandbox." }
                    " The submissions ran with all rights of the account that marked them. Whatever they did, they could also have "
                    "changed these results."
                }
            }
            (figures(book, statistics))
        }
        div.overview {
            @if !attention.is_empty() { (needs_your_eye(attention)) }
            div.two {
                div {
                    section { h2 { "Points" } (distribution(run.points(), statistics)) }
                    @if !statistics.misconceptions.is_empty() { (misconceptions(book, statistics)) }
                }
                section { h2 { "Checks" } (checks(book, statistics)) }
            }
            @if !book.groups.is_empty() { (similar(book)) }
        }
    }
}

/// The few numbers that come first.
fn figures(book: &Book<'_>, statistics: &Statistics) -> Markup {
    let submissions = book.entries.iter().filter(|entry| !entry.only_on_roster).count();
    let missing = statistics.statuses.get("missing").copied().unwrap_or(0);
    let full =
        statistics.points.iter().filter(|points| **points == crate::Points::whole(book.run.points())).count();
    let fact = |value: String, name: &str| html! { div { dt { (name) } dd { (value) } } };
    html! {
        dl.numbers {
            (fact(submissions.to_string(), "submissions"))
            @if missing > 0 { (fact(missing.to_string(), "missing")) }
            @if let Some(median) = statistics.median() { (fact(format!("{median} of {}", book.run.points()), "median")) }
            (fact(full.to_string(), "with all points"))
        }
    }
}

fn needs_your_eye(attention: &[Attention]) -> Markup {
    html! {
        section.eye {
            h2 { "Needs your eye" }
            ul {
                @for item in attention {
                    li {
                        (theirs(&item.why))
                        @if !item.who.is_empty() { ": " (who(item.who.iter().map(|(id, name)| (id.as_str(), name.as_str())))) }
                    }
                }
            }
        }
    }
}

/// Names that lead to their rows; beyond a few they fold.
fn who<'a>(people: impl Iterator<Item = (&'a str, &'a str)>) -> Markup {
    let people: Vec<_> = people.collect();
    let links = |people: &[(&str, &str)]| {
        html! {
            @for (index, (id, name)) in people.iter().enumerate() {
                @if index > 0 { ", " }
                a href={ "#r-" (id) } { (theirs(name)) }
            }
        }
    };
    html! {
        @if people.len() <= 6 { (links(&people)) }
        @else { details.who { summary { (count(people.len(), "student")) } (links(&people)) } }
    }
}

fn checks(book: &Book<'_>, statistics: &Statistics) -> Markup {
    html! {
        table.small {
            caption.unseen { "In how many graded submissions each check is right" }
            thead { tr { th scope="col" { "Check" } th.number scope="col" { "Right" } th.chart scope="col" { span.unseen { "Share" } } } }
            tbody {
                @for (part, right) in book.run.parts.iter().zip(&statistics.right) {
                    tr.group { th scope="rowgroup" colspan="3" { (part.id) ": " (prose(&part.title)) } }
                    @for (check, right) in part.checks.iter().zip(right) {
                        tr {
                            td { (prose(&check.title)) }
                            td.number { (right) }
                            td.chart { (bar(*right, statistics.graded)) }
                        }
                    }
                }
            }
        }
    }
}

fn misconceptions(book: &Book<'_>, statistics: &Statistics) -> Markup {
    let most = statistics.misconceptions.iter().map(|one| one.who.len()).max().unwrap_or(0);
    html! {
        section {
            h2 { "Misconceptions" }
            table.small {
                caption.unseen { "Which misconceptions were recognised, how often, and whose they are" }
                thead {
                    tr {
                        th scope="col" { "The student reads" } th.number scope="col" { "Students" }
                        th.chart scope="col" { span.unseen { "Share" } }
                    }
                }
                tbody { @for one in &statistics.misconceptions { (misconception(book, one, most)) } }
            }
        }
    }
}

fn misconception(book: &Book<'_>, one: &Misconception, most: usize) -> Markup {
    let people = one.who.iter().filter_map(|index| book.entries.get(*index));
    let people: Vec<(&str, String)> = people.map(|entry| (entry.id.as_str(), entry.shown_name())).collect();
    html! {
        tr {
            td {
                (prose(&one.title))
                div.sub {
                    (book.run.parts[one.part].id) " · "
                    button.find type="button" data-find=(one.id) { code { (one.id) } }
                    " · " (who(people.iter().map(|(id, name)| (*id, name.as_str()))))
                }
            }
            td.number { (one.who.len()) }
            td.chart { (bar(one.who.len(), most)) }
        }
    }
}

fn similar(book: &Book<'_>) -> Markup {
    let names: HashMap<&str, String> =
        book.entries.iter().map(|entry| (entry.id.as_str(), entry.shown_name())).collect();
    let name = |id: &String| names.get(id.as_str()).cloned();
    html! {
        section {
            h2 { "Submissions that are alike" }
            p.note { "That two files are alike says nothing of how it came about. Look at them before you judge." }
            ul.groups {
                @for (index, group) in book.groups.iter().enumerate() {
                    li #{ "g-" (index + 1) } {
                        @let people: Vec<(&str, String)> = group.ids.iter().map(|id| (id.as_str(), name(id).unwrap_or_default())).collect();
                        (who(people.iter().map(|(id, name)| (*id, name.as_str()))))
                        span.sub { (group.kind) ", " (percent(group.similarity)) " %" }
                    }
                }
            }
        }
    }
}

fn percent(share: f64) -> u32 {
    // Only what is the same is shown as all.
    if share >= 1.0 { 100 } else { (share * 100.0).clamp(0.0, 99.0) as u32 }
}

pub(super) fn bottom(book: &Book<'_>) -> Markup {
    let run = book.run;
    html! {
        section.run {
            h2 { "This run" }
            dl.facts {
                dt { "Sandbox" } dd { (run.sandbox) }
                dt { "Seed of the questions" } dd { code { (run.seed) } " (keep it to yourself)" }
                @for (name, value) in &run.versions { dt { (name) } dd { code { (value) } } }
                @for (name, value) in &run.limits { dt { "Limit: " (name) } dd { (value) } }
            }
        }
    }
}
