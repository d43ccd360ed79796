//! Words that must come next.

use crate::error::{Error, Kind, Problem};
use crate::number;
use crate::snippet::printable_start;
use crate::source::{Place, Source};

/// Takes `word`, in upper or lower case.
pub(crate) fn take<K: Kind>(source: &mut Source, word: &str, expected: &'static str) -> Result<(), Error<K>> {
    if source.take_word(word) { Ok(()) } else { Err(Error::unexpected(source, expected)) }
}

/// Takes a number.
pub(crate) fn number<F: number::Float, K: Kind>(source: &mut Source) -> Result<F, Error<K>> {
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
pub(crate) fn count<K: Kind>(source: &mut Source, expected: &'static str) -> Result<(u64, Place), Error<K>> {
    let word = source.peek();
    let length = word.len();
    let digits = std::str::from_utf8(word).ok().filter(|word| word.bytes().all(|byte| byte.is_ascii_digit()));
    let Some(digits) = digits.filter(|digits| !digits.is_empty()) else {
        return Err(Error::unexpected(source, expected));
    };
    // Digits alone are a count, unless they are too many.
    let Ok(count) = digits.parse() else {
        let found = printable_start(word);
        return Err(Error::here(source, Problem::LargeCount { found, expected }.into()));
    };
    let place = source.place();
    source.take(length);
    Ok((count, place))
}
