//! Foreign text, made harmless for the place where it is shown.

use std::borrow::Cow;

/// The text with everything visible that would otherwise act: control characters, and those that change the direction of what
/// follows. Line breaks and tabs stay. What is left may stand in XML.
pub(crate) fn visible(text: &str) -> Cow<'_, str> {
    if !text.chars().any(acts) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '\r' if characters.peek() == Some(&'\n') => {}
            '\r' => out.push('\n'),
            '\0'..='\u{1f}' if acts(character) => {
                out.push(char::from_u32(0x2400 + u32::from(character)).unwrap_or('\u{fffd}'));
            }
            '\u{7f}' => out.push('\u{2421}'),
            '\u{80}'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            _ if acts(character) => out.push_str(&format!("⟨U+{:04X}⟩", u32::from(character))),
            _ => out.push(character),
        }
    }
    Cow::Owned(out)
}

fn acts(character: char) -> bool {
    match character {
        '\n' | '\t' => false,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        '\u{fffe}' | '\u{ffff}' => true,
        _ => character.is_control(),
    }
}

/// The text in one line, with everything visible.
pub(crate) fn one_line(text: &str) -> String {
    visible(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The text as a cell that no spreadsheet takes for a formula.
pub(crate) fn cell(text: &str) -> Cow<'_, str> {
    let begins = |characters: &[char]| text.starts_with(characters);
    // A spreadsheet may trim a cell first, and takes the wide forms for the narrow ones.
    let trimmed = text.trim_start();
    let formula = trimmed.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']);
    if formula || begins(&['\t', '\r', '\n']) { Cow::Owned(format!("'{text}")) } else { Cow::Borrowed(text) }
}

/// The text in one line of Markdown, with nothing that is markup.
pub(crate) fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in one_line(text).chars() {
        if "\\`*_[]<>#|~&!".contains(character) {
            out.push('\\');
        }
        out.push(character);
    }
    // A list or a heading underlined by the next line begins with one of these.
    match out.chars().next() {
        Some('-' | '+' | '=') => format!("\\{out}"),
        Some(digit) if digit.is_ascii_digit() => out.replacen(". ", "\\. ", 1).replacen(") ", "\\) ", 1),
        _ => out,
    }
}

/// The text as a block of code in Markdown: nothing in it can end the block.
pub(crate) fn markdown_code(text: &str) -> String {
    let text = visible(text);
    let longest = text.split(|character| character != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}text\n{}\n{fence}\n", text.trim_end_matches('\n'))
}

/// The same name whatever the order, the case, the commas and the blanks: `Fox, Terry` is `terry  FOX`.
pub(crate) fn name_key(name: &str) -> String {
    let lower = name.to_lowercase();
    let mut words: Vec<&str> =
        lower.split(|character: char| !character.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    words.sort_unstable();
    words.join(" ")
}

/// Whether two names have a word in common, however they are written: `TerryFox` has one with `Fox, T.`.
pub(crate) fn resembles(one: &str, other: &str) -> bool {
    let has_word_of = |name: &str, words: &str| {
        let run_together = name_key(name).replace(' ', "");
        let mut words = words.split(' ').filter(|word| word.chars().count() > 1);
        words.any(|word| run_together.contains(word))
    };
    let (one, other) = (name_key(one), name_key(other));
    one.is_empty() || other.is_empty() || has_word_of(&one, &other) || has_word_of(&other, &one)
}

/// `1 student`, `2 students`.
pub(crate) fn count(number: usize, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{plural}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_beginning_of_a_formula_is_made_harmless() {
        for begin in ["=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠", " =", "\u{a0}@"] {
            let text = format!("{begin}1+1");
            assert_eq!(cell(&text), format!("'{text}"), "{begin:?}");
        }
        for plain in ["", "1-1", "Terry", "'=1", "7.50"] {
            assert_eq!(cell(plain), plain);
        }
    }

    #[test]
    fn nothing_ends_a_block_of_code_but_its_end() {
        for text in ["", "``", "```", "a\n````\n# heading", "`````````"] {
            let block = markdown_code(text);
            let fence = block.split("text").next().unwrap();
            assert!(fence.len() > 2 && !text.contains(fence), "{block}");
            assert!(block.ends_with(&format!("\n{fence}\n")), "{block}");
        }
    }

    #[test]
    fn names_are_known_again_however_they_are_written() {
        assert_eq!(name_key("Fox, Terry"), name_key(" terry  FOX"));
        assert_ne!(name_key("Terry Fox"), name_key("Terry Foxe"));
        for (one, other) in
            [("TerryFox", "Fox, T."), ("foxterry", "Terry Fox"), ("Zoë Å", "zoë b"), ("", "anybody")]
        {
            assert!(resembles(one, other), "{one} {other}");
        }
        for (one, other) in [("Terry Fox", "Ada Okafor"), ("=cmd", "Li Wei")] {
            assert!(!resembles(one, other), "{one} {other}");
        }
    }
}
