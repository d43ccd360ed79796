//! The letter as Markdown. What students wrote stands in it as text, never as markup.

use std::fmt::Write;

use super::letter::{Block, Letter, Line, Section, Span};
use crate::text::{markdown, markdown_code};

pub(super) fn page(letter: &Letter) -> String {
    let mut out = format!("# {}\n\n", letter.title);
    if !letter.whose.is_empty() {
        let whose: Vec<String> = letter.whose.iter().map(|text| markdown(text)).collect();
        out.push_str(&format!("{}\n\n", whose.join(" · ")));
    }
    for section in &letter.sections {
        section_into(&mut out, section);
    }
    format!("{}\n", out.trim_end())
}

fn section_into(out: &mut String, section: &Section) {
    if !section.heading.is_empty() {
        out.push_str(&format!("## {}\n\n", section.heading));
    }
    let mut blocks = section.blocks.iter().peekable();
    while let Some(block) = blocks.next() {
        block_into(out, block);
        let list_goes_on = matches!((block, blocks.peek()), (Block::Item(_), Some(Block::Item(_))));
        out.push_str(if list_goes_on { "" } else { "\n" });
    }
}

fn block_into(out: &mut String, block: &Block) {
    // Writing to a String does not fail.
    let _ = match block {
        Block::Text(spans) => writeln!(out, "{}", spans_as_text(spans)),
        Block::Item(spans) => writeln!(out, "- {}", spans_as_text(spans)),
        Block::Checks(lines) => checks_into(out, lines),
        Block::Code(code) => write!(out, "{}", markdown_code(code)),
        Block::Named(named) => {
            writeln!(out, "**{}**\n\n{}\n\n*Hint:* {}", named.title, named.explanation, named.hint)
        }
    };
}

fn checks_into(out: &mut String, lines: &[Line]) -> std::fmt::Result {
    writeln!(out, "| result | points | what was checked |\n|---|---|---|")?;
    for line in lines {
        let note = match line.note.is_empty() {
            true => String::new(),
            false => format!("<br>{}", markdown(&line.note)),
        };
        writeln!(out, "| {} | {} | {}{note} |", line.state.name(), line.points, markdown(&line.title))?;
    }
    Ok(())
}

fn spans_as_text(spans: &[Span]) -> String {
    let as_text = |span: &Span| match span {
        Span::Ours(words) => words.clone(),
        Span::Theirs(words) => markdown(words),
    };
    spans.iter().map(as_text).collect()
}

/// A section without the table of its checks.
pub(super) fn without_checks(section: &Section) -> String {
    let mut out = String::new();
    if !section.heading.is_empty() {
        out.push_str(&format!("## {}\n\n", section.heading));
    }
    for block in section.blocks.iter().filter(|block| !matches!(block, Block::Checks(_))) {
        block_into(&mut out, block);
        out.push('\n');
    }
    out.trim_end().to_owned()
}
