//! The tokens of Rust, as far as they matter for comparing texts. Any text has some: what is not Rust becomes single characters,
//! and what is not closed ends with the text.

/// A piece of a source text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind,
    pub(super) text: &'a str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Comment,
    /// A name or a keyword.
    Word,
    Lifetime,
    /// A number, a string, a character.
    Literal,
    /// A single character.
    Sign,
}

/// All tokens of `text`, comments included.
pub(super) fn tokens(mut text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    loop {
        text = text.trim_start();
        if text.is_empty() {
            return tokens;
        }
        let (kind, len) = first(text);
        let (token, rest) = text.split_at_checked(len).unwrap_or((text, ""));
        tokens.push(Token { kind, text: token });
        text = rest;
    }
}

/// The tokens without comments. Instead of each name that is the student's to choose stands `_`.
pub(super) fn without_names<'a>(tokens: &[Token<'a>]) -> impl Iterator<Item = &'a str> {
    let code: Vec<Token<'a>> = tokens.iter().filter(|token| token.kind != Kind::Comment).copied().collect();
    let is = |at: Option<usize>, sign| at.and_then(|at| code.get(at)).is_some_and(|token| token.text == sign);
    let is_given = |at: usize| {
        let before = at.checked_sub(1);
        is(before, ".")
            || is(before, ":") && is(at.checked_sub(2), ":")
            || is(Some(at + 1), ":") && is(Some(at + 2), ":")
    };
    let text = |(at, token): (usize, &Token<'a>)| match token.kind {
        Kind::Lifetime => "'_",
        Kind::Word if !is_keyword(token.text) && !is_given(at) => "_",
        _ => token.text,
    };
    code.iter().enumerate().map(text).collect::<Vec<_>>().into_iter()
}

/// The kind and the length of the first token. `text` does not begin with a space.
fn first(text: &str) -> (Kind, usize) {
    if text.starts_with("//") {
        return (Kind::Comment, text.find('\n').unwrap_or(text.len()));
    }
    if text.starts_with("/*") {
        return (Kind::Comment, block_comment(text));
    }
    let word = text.find(|c: char| !is_word(c)).unwrap_or(text.len());
    let (prefix, rest) = text.split_at_checked(word).unwrap_or((text, ""));
    if matches!(prefix, "r" | "br" | "cr")
        && let Some(len) = raw_string(rest)
    {
        return (Kind::Literal, word + len);
    }
    if matches!(prefix, "" | "b" | "c") && rest.starts_with('"') {
        return (Kind::Literal, word + quoted(rest, '"'));
    }
    if matches!(prefix, "" | "b") && rest.starts_with('\'') {
        let (kind, len) = after_tick(rest);
        return (kind, word + len);
    }
    if text.starts_with(|c: char| c.is_ascii_digit()) {
        return (Kind::Literal, number(text));
    }
    if word > 0 {
        return (Kind::Word, word);
    }
    (Kind::Sign, text.chars().next().map_or(1, char::len_utf8))
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Block comments lie in each other.
fn block_comment(text: &str) -> usize {
    let mut depth = 0_usize;
    let mut at = 0;
    let bytes = text.as_bytes();
    while at < bytes.len() {
        match bytes.get(at..at + 2) {
            Some(b"/*") => depth += 1,
            Some(b"*/") => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

/// The length of `#"…"#` with any number of `#`.
fn raw_string(text: &str) -> Option<usize> {
    let hashes = text.len() - text.trim_start_matches('#').len();
    let inside = text.get(hashes..)?.strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    Some(inside.find(&end).map_or(text.len(), |at| hashes + 1 + at + end.len()))
}

/// The length of what is between two quotation marks, with them.
fn quoted(text: &str, mark: char) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            c if c == mark => return at + c.len_utf8(),
            _ => {}
        }
    }
    text.len()
}

/// `'a'` is a character, `'a` a lifetime.
fn after_tick(text: &str) -> (Kind, usize) {
    let mut chars = text.chars().skip(1);
    match (chars.next(), chars.next()) {
        (Some('\\'), _) => (Kind::Literal, quoted(text, '\'')),
        (Some(c), Some('\'')) => (Kind::Literal, 2 + c.len_utf8()),
        _ => {
            let name = text.char_indices().skip(1).find(|(_, c)| !is_word(*c));
            (Kind::Lifetime, name.map_or(text.len(), |(at, _)| at))
        }
    }
}

/// Digits, letters, and a point if a digit follows it. `1e-3` is three tokens, each time.
fn number(text: &str) -> usize {
    let mut chars = text.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let is_point = c == '.' && chars.peek().is_some_and(|(_, next)| next.is_ascii_digit());
        if !is_word(c) && !is_point {
            return at;
        }
    }
    text.len()
}

/// The keywords of Rust (The Rust Reference, "Keywords"), and the names of its simple types: nobody chooses these.
fn is_keyword(word: &str) -> bool {
    #[rustfmt::skip]
    let is_keyword = matches!(word,
        "as" | "async" | "await" | "break" | "const" | "continue" | "crate" | "dyn" | "else" | "enum"
        | "extern" | "false" | "fn" | "for" | "if" | "impl" | "in" | "let" | "loop" | "match" | "mod"
        | "move" | "mut" | "pub" | "ref" | "return" | "self" | "Self" | "static" | "struct" | "super"
        | "trait" | "true" | "type" | "unsafe" | "use" | "where" | "while" | "bool" | "char" | "f32"
        | "f64" | "i8" | "i16" | "i32" | "i64" | "i128" | "isize" | "str" | "u8" | "u16" | "u32" | "u64"
        | "u128" | "usize" | "Some" | "None" | "Ok" | "Err"
    );
    is_keyword
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{Kind, tokens, without_names};

    fn texts(text: &str) -> Vec<&str> {
        tokens(text).into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn what_looks_like_something_else_inside_is_not_it() {
        for literal in [
            r#""a // b \" /* c""#,
            r###"r#"a " // b"#"###,
            r###"br##"a "# b"##"###,
            "b\"x\"",
            "'\"'",
            "'\\''",
            "b'/'",
            "1.5e3",
            "0xff_u8",
        ] {
            assert_eq!(texts(&format!("a {literal} b")), ["a", literal, "b"]);
        }
        for comment in ["/* a /* \" */ b */", "// it's\n", "/**/"] {
            assert_eq!(texts(&format!("a {comment} b")), ["a", comment.trim_end(), "b"]);
        }
        assert_eq!(
            texts("0..3 1.x &'a T 'b' r#fn"),
            "0 . . 3 1 . x & 'a T 'b' r # fn".split(' ').collect::<Vec<_>>()
        );
    }

    #[test]
    fn names_of_the_students_choice_are_one() {
        let given = "let _ = Quat::from_axis_angle(_.unit(), _[0] * 2.0); // x";
        let text = "let turn = Quat::from_axis_angle(axis.unit(), angles[0] * 2.0); // y";
        let shape = |text: &str| without_names(&tokens(text)).collect::<Vec<_>>().join(" ");
        assert_eq!(shape(text), shape(given));
        assert_ne!(shape(text), shape(&text.replace("2.0", "3.0")));
        assert_ne!(shape(text), shape(&text.replace("unit", "other")));
    }

    proptest! {
        #[test]
        fn nothing_is_lost_but_spaces(text in "(\\PC|[ \n\"'/*#rbc\\\\_0.]){0,60}") {
            let tokens = tokens(&text);
            let without_spaces = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
            let joined: String = tokens.iter().map(|token| token.text).collect();
            prop_assert_eq!(without_spaces(&joined), without_spaces(&text));
            prop_assert!(tokens.iter().all(|token| !token.text.is_empty()));
            prop_assert!(tokens.iter().all(|token| token.kind != Kind::Sign || token.text.chars().count() == 1));
        }
    }
}
