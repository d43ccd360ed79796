//! What the compiler says, as few lines for the window.

use serde_json::Value;

/// Columns of a source line that are shown.
const WIDTH: usize = 100;

/// One of the compiler's errors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Found {
    /// What is wrong, and what to do about it.
    pub(crate) words: Vec<String>,
    /// `file:line:column`
    pub(crate) place: Option<String>,
    /// The line of the source, and which piece of it is meant.
    pub(crate) source: Vec<String>,
}

impl Found {
    pub(crate) fn lines(self) -> Vec<String> {
        self.words.into_iter().chain(self.place).chain(self.source).collect()
    }
}

/// The error that a diagnostic of the compiler, in its JSON format, tells of. Warnings are none.
pub(crate) fn error(diagnostic: &Value) -> Option<Found> {
    if !diagnostic["level"].as_str()?.starts_with("error") {
        return None;
    }
    let message = diagnostic["message"].as_str().unwrap_or_default();
    let code = diagnostic["code"]["code"].as_str().map(|code| format!("[{code}]")).unwrap_or_default();
    let first = message.lines().next().unwrap_or_default();
    let mut words = vec![format!("error{code}: {first}")];
    if message.contains("linker") && message.contains("not found") {
        words.push(
            "Rust needs a linker. On Debian and Ubuntu: sudo apt install build-essential. On macOS: xcode-select --install. On Windows: the Visual Studio Build Tools"
                .into(),
        );
    }
    let spans = diagnostic["spans"].as_array().map(Vec::as_slice).unwrap_or_default();
    let Some(span) = spans.iter().find(|span| span["is_primary"] == true).map(outermost) else {
        return Some(Found { words, ..Found::default() });
    };
    let file = span["file_name"].as_str().unwrap_or_default();
    let place = format!("{file}:{}:{}", span["line_start"], span["column_start"]);
    Some(Found { words, place: Some(place), source: source(span) })
}

/// Where a macro is used, not where it is written.
fn outermost(span: &Value) -> &Value {
    let mut span = span;
    while span["expansion"]["span"].is_object() {
        span = &span["expansion"]["span"];
    }
    span
}

/// The source's line, and the piece of it that is meant with what is wrong with it. The window's letters differ in
/// width: marks below the line would stand in the wrong place.
fn source(span: &Value) -> Vec<String> {
    let Some(text) = span["text"][0]["text"].as_str() else { return Vec::new() };
    let number = |name: &str| span["text"][0][name].as_u64().map_or(1, |at| at.max(1) as usize);
    let (from, to) = (number("highlight_start") - 1, number("highlight_end") - 1);
    let short = |text: &str| parser::printable(&text.chars().take(WIDTH).collect::<String>());
    let piece: String = text.chars().skip(from).take(to.saturating_sub(from)).collect();
    let piece = short(piece.trim());
    let label = short(span["label"].as_str().unwrap_or_default());
    let mark = match (piece.is_empty(), label.is_empty()) {
        (false, false) => Some(format!("{piece}  <- {label}")),
        (false, true) => Some(format!("{piece}  <- here")),
        (true, false) => Some(label),
        (true, true) => None,
    };
    [short(text.trim())].into_iter().chain(mark).collect()
}

/// `line` without the escape sequences that set colours: ESC `[` … letter.
pub(crate) fn without_colors(line: &str) -> String {
    let mut parts = line.split("\u{1b}[");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| c.is_ascii_alphabetic()).map_or(part.len(), |letter| letter + 1);
        plain.push_str(&part[end..]);
    }
    plain
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn colours_are_taken_out() {
        assert_eq!(without_colors("\u{1b}[0m\u{1b}[1m\u{1b}[38;5;9merror\u{1b}[0m: x"), "error: x");
        assert_eq!(without_colors("plain [m]"), "plain [m]");
        assert_eq!(without_colors("\u{1b}["), "");
    }

    #[test]
    fn whatever_a_diagnostic_holds_it_is_read() {
        let span = |start: u64, end: u64, text: &str| {
            json!({"is_primary": true, "file_name": "fk.rs", "line_start": 1, "column_start": start,
                   "text": [{"text": text, "highlight_start": start, "highlight_end": end}]})
        };
        for (start, end) in [(0, 0), (1, 1), (5, 2), (3, 1 << 40), (u64::MAX, u64::MAX)] {
            let diagnostic =
                json!({"level": "error", "message": "no", "spans": [span(start, end, "let é = 1;")]});
            let found = error(&diagnostic).unwrap();
            assert!(found.source.iter().all(|line| line.chars().count() <= 3 * WIDTH), "{found:?}");
        }
        for odd in [json!({"level": "warning"}), json!(null), json!([1]), json!({"level": 3})] {
            assert_eq!(error(&odd), None);
        }
        assert!(error(&json!({"level": "error: internal compiler error"})).is_some());
    }

    #[test]
    fn an_error_inside_a_macro_is_told_where_the_macro_is_used() {
        let outer = json!({"file_name": "fk.rs", "line_start": 7, "column_start": 2, "text": []});
        let inner = json!({"is_primary": true, "file_name": "macros.rs", "expansion": {"span": outer}});
        let found = error(&json!({"level": "error", "message": "no", "spans": [inner]})).unwrap();
        assert_eq!(found.place.as_deref(), Some("fk.rs:7:2"));
    }
}
