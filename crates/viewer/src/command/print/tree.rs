//! Trees of names.

use parser::printable;
use unicode_width::UnicodeWidthStr;

/// What is deeper than this is printed with its depth as a number instead of more indentation.
const DEEPEST: usize = 24;

/// Names are given at most this many columns before the numbers follow.
const WIDEST: usize = 48;

/// Each name behind the lines that connect it to its parent. Parents, given by their places in the list, stand in front of
/// their children, and all that hangs on one of these in front of the next.
pub fn branches<'a>(items: impl Iterator<Item = (&'a str, Option<usize>)>) -> Vec<String> {
    let items: Vec<(&str, Option<usize>)> = items.collect();
    // Whether there is a next one with the same parent, found from the back: the last child met first is the last one.
    let mut has_next = vec![false; items.len()];
    let mut seen = vec![false; items.len()];
    for (i, (_, parent)) in items.iter().enumerate().rev() {
        if let Some(parent) = *parent {
            has_next[i] = std::mem::replace(&mut seen[parent], true);
        }
    }
    let mut depths: Vec<usize> = Vec::with_capacity(items.len());
    let mut stems: Vec<String> = Vec::with_capacity(items.len());
    let mut branches = Vec::with_capacity(items.len());
    for (i, (item, parent)) in items.into_iter().enumerate() {
        let name = name(item);
        let depth = parent.map_or(0, |parent| depths[parent] + 1);
        let (branch, stem) = match parent {
            None => (name, String::new()),
            Some(_) if depth > DEEPEST => (format!("… depth {depth}: {name}"), String::new()),
            Some(parent) => {
                let stem = &stems[parent];
                let (fork, line) = if has_next[i] { ("├─ ", "│  ") } else { ("└─ ", "   ") };
                (format!("{stem}{fork}{name}"), format!("{stem}{line}"))
            }
        };
        branches.push(branch);
        stems.push(stem);
        depths.push(depth);
    }
    branches
}

/// How wide the column of branches is.
pub fn width(branches: &[String]) -> usize {
    branches.iter().map(|branch| branch.width()).max().unwrap_or(0).min(WIDEST)
}

/// `branch` with as many blanks behind it as make it `width` columns wide. Some letters take two columns, and some none.
pub fn padded(branch: &str, width: usize) -> String {
    let blanks = width.saturating_sub(branch.width());
    format!("{branch}{:blanks$}", "")
}

/// A name without characters that would do something to the terminal, and not longer than a line.
pub fn name(name: &str) -> String {
    if name.is_empty() {
        return "(no name)".into();
    }
    if name.chars().count() <= WIDEST {
        return printable(name);
    }
    let start: String = name.chars().take(WIDEST - 1).collect();
    printable(&start) + "…"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_cut_says_so() {
        assert_eq!(name(&"ä".repeat(48)), "ä".repeat(48));
        assert_eq!(name(&"ä".repeat(49)), "ä".repeat(47) + "…");
        assert_eq!(name(""), "(no name)");
    }

    #[test]
    fn wide_letters_take_two_columns() {
        let names = ["腰骨", "spine", "cafe\u{301}"].map(String::from);
        assert_eq!(width(&names), 5);
        assert_eq!(names.map(|name| padded(&name, 6) + "|"), ["腰骨  |", "spine |", "cafe\u{301}  |"]);
        assert_eq!(padded("spine", 2), "spine");
    }
}
