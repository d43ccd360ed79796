//! The compiler's messages, for a student.

use std::path::Path;

use results::CompileError;
use serde_json::Value;

/// The errors of one compilation.
#[derive(Debug, Default)]
pub struct Diagnostics {
    /// The errors in the compiler's order.
    pub errors: Vec<CompileError>,
    /// How many there are beyond the first [`MOST_ERRORS`].
    pub left_out: usize,
}

/// How many errors are kept. Nobody reads more.
pub const MOST_ERRORS: usize = 200;

/// Characters that are kept of one error.
const MOST_CHARACTERS: usize = 4000;

/// Reads what `rustc --error-format=json` prints. `file` is the student's, as the compiler names it; each path in
/// `hide` is replaced by the word beside it.
pub fn read(stderr: &[u8], file: &str, hide: &[(&Path, &str)]) -> Diagnostics {
    let mut diagnostics = Diagnostics::default();
    for line in stderr.split(|&byte| byte == b'\n') {
        let Ok(message) = serde_json::from_slice::<Value>(line) else { continue };
        let text = message["message"].as_str().unwrap_or_default();
        let is_summary = message["spans"].as_array().is_none_or(Vec::is_empty)
            && (text.starts_with("aborting due to") || text.starts_with("could not compile"));
        if message["level"] != "error" && message["level"] != "error: internal compiler error" || is_summary {
            continue;
        }
        if diagnostics.errors.len() == MOST_ERRORS {
            diagnostics.left_out += 1;
            continue;
        }
        diagnostics.errors.push(error(&message, file, hide));
    }
    diagnostics
}

fn error(message: &Value, file: &str, hide: &[(&Path, &str)]) -> CompileError {
    let spans = message["spans"].as_array().map(Vec::as_slice).unwrap_or_default();
    let is_primary = |span: &&Value| span["is_primary"] == true && span["file_name"] == file;
    let place = spans.iter().find(is_primary);
    let number = |name: &str| u32::try_from(place?[name].as_u64()?).ok();
    let say = |text: &Value, most| {
        let mut text = text.as_str().unwrap_or_default().to_owned();
        for (path, word) in hide {
            text = text.replace(&*path.to_string_lossy(), word);
        }
        clean(&text, most)
    };
    CompileError {
        message: say(&message["message"], 500),
        line: number("line_start"),
        column: number("column_start"),
        text: say(&message["rendered"], MOST_CHARACTERS),
    }
}

/// At most `most` characters of `text`, with those that would do something to a terminal or turn the text around
/// written out as `\u{…}`.
pub fn clean(text: &str, most: usize) -> String {
    let mut clean = String::new();
    for (count, character) in text.chars().enumerate() {
        if count == most {
            clean.push_str("\n(the rest is left out)");
            break;
        }
        let turns_text = matches!(character,
            '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
        if turns_text || character.is_control() && !matches!(character, '\n' | '\t') {
            clean.extend(character.escape_unicode());
        } else {
            clean.push(character);
        }
    }
    clean
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_have_the_line_of_the_students_own_file() {
        let json = br#"{"message":"mismatched types","level":"error","spans":[{"file_name":"lib.rs","is_primary":true,"line_start":1,"column_start":1},{"file_name":"fk.rs","is_primary":true,"line_start":12,"column_start":5}],"rendered":"error: mismatched types\n --> fk.rs:12:5 /home/ta/x\n"}
{"message":"unused","level":"warning","spans":[],"rendered":"warning"}
not json
{"message":"aborting due to 1 previous error","level":"error","spans":[],"rendered":"x"}"#;
        let found = read(json, "fk.rs", &[(Path::new("/home/ta"), "here")]);
        assert_eq!(found.errors.len(), 1);
        assert_eq!((found.errors[0].line, found.errors[0].column), (Some(12), Some(5)));
        assert_eq!(found.errors[0].text, "error: mismatched types\n --> fk.rs:12:5 here/x\n");
    }

    #[test]
    fn errors_beyond_the_last_are_counted() {
        let line = "{\"message\":\"no\",\"level\":\"error\",\"spans\":[{}],\"rendered\":\"no\"}\n";
        let found = read(line.repeat(MOST_ERRORS + 7).as_bytes(), "fk.rs", &[]);
        assert_eq!((found.errors.len(), found.left_out), (MOST_ERRORS, 7));
    }

    #[test]
    fn what_would_command_a_terminal_is_written_out() {
        assert_eq!(clean("a\u{1b}[31mb\u{202e}c\n\td", 100), "a\\u{1b}[31mb\\u{202e}c\n\td");
        assert_eq!(clean("abcdef", 3), "abc\n(the rest is left out)");
    }
}
