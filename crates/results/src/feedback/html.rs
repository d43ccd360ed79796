//! The letter as a page without a script.

use maud::{Markup, html};

use super::letter::{Block, Letter, Line, Section, Span};
use crate::page::{self, Page, prose, state_mark, theirs};
use crate::text::visible;

const STYLE: &str = include_str!("feedback.css");

pub(super) fn page(letter: &Letter) -> String {
    let body = html! {
        main {
            header {
                h1 { (letter.title) }
                @if !letter.whose.is_empty() {
                    p.whose {
                        @for (index, text) in letter.whose.iter().enumerate() {
                            @if index > 0 { " · " }
                            (theirs(text))
                        }
                    }
                }
            }
            @for one in &letter.sections { (section(one)) }
        }
    };
    Page { title: &letter.title, style: &[page::STYLE, STYLE], script: None }.around(&body).into_string()
}

fn section(section: &Section) -> Markup {
    html! {
        section {
            @if !section.heading.is_empty() { h2 { (prose(&section.heading)) } }
            @for run in section.blocks.chunk_by(|one, other| is_item(one) && is_item(other)) {
                @if is_item(&run[0]) {
                    ul { @for item in run { (block(item)) } }
                } @else {
                    @for one in run { (block(one)) }
                }
            }
        }
    }
}

fn is_item(block: &Block) -> bool {
    matches!(block, Block::Item(_))
}

fn block(block: &Block) -> Markup {
    match block {
        Block::Text(text) => html! { p { (spans(text)) } },
        Block::Item(text) => html! { li { (spans(text)) } },
        Block::Checks(lines) => checks(lines),
        Block::Code(code) => html! { pre dir="ltr" tabindex="0" { (visible(code)) } },
        Block::Named(named) => html! {
            div.named {
                h3 { (prose(&named.title)) }
                p { (prose(&named.explanation)) }
                p { strong { "Hint: " } (prose(&named.hint)) }
            }
        },
    }
}

fn checks(lines: &[Line]) -> Markup {
    html! {
        table {
            thead { tr { th scope="col" { "Result" } th scope="col" { "Points" } th scope="col" { "What was checked" } } }
            tbody {
                @for line in lines {
                    tr {
                        td { (state_mark(line.state.name())) }
                        td.points { (line.points) }
                        td {
                            (prose(&line.title))
                            @if !line.note.is_empty() { p.note { (theirs(&line.note)) } }
                        }
                    }
                }
            }
        }
    }
}

fn spans(spans: &[Span]) -> Markup {
    html! {
        @for span in spans {
            @match span {
                Span::Ours(words) => { (prose(words)) }
                Span::Theirs(words) => { (theirs(words)) }
            }
        }
    }
}
