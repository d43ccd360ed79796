//! Words that must come next.

use super::Error;
use crate::number;
use crate::source::{Place, Source};

/// Takes `word`, in upper or lower case.
pub(super) fn take(source: &mut Source, word: &str, expected: &'static str) -> Result<(), Error> {
    if source.take_word(word) { Ok(()) } else { Err(Error::unexpected(source, expected)) }
}

/// Takes a number.
pub(super) fn number<F: number::Float>(source: &mut Source) -> Result<F, Error> {
    let word = source.peek();
    let length = word.len();
    match number::parse(word) {
        Ok(number) => {
            source.take(length);
            Ok(number)
        }
        Err(problem) => {
            let word = word.to_vec();
            Err(Error::bad_number(source, &word, problem))
        }
    }
}

/// Takes a whole number without a sign. Gives where it stands, too.
pub(super) fn count(source: &mut Source, expected: &'static str) -> Result<(u64, Place), Error> {
    let word = source.peek();
    let length = word.len();
    let digits = Some(word).filter(|word| word.iter().all(u8::is_ascii_digit));
    match digits.and_then(|digits| std::str::from_utf8(digits).ok()).and_then(|digits| digits.parse().ok()) {
        Some(count) => {
            let place = source.place();
            source.take(length);
            Ok((count, place))
        }
        None => Err(Error::unexpected(source, expected)),
    }
}
