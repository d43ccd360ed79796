//! Numbers: the same values that [`str::parse`] gives, sooner.

use crate::source::{LONGEST_WORD, is_blank};

/// Why a word is not a number that can be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BadNumber {
    NotANumber,
    /// NaN, an infinity, or too far from zero to be held.
    NotFinite,
    /// A comma or a semicolon, where a point or a blank may be meant.
    Separator,
    TooLong,
}

/// Reads the number at the front of `text`, up to the next blank or the end of the text. Gives it, and the text
/// behind it.
#[inline(always)]
pub(crate) fn leading(text: &[u8]) -> Result<(f32, &[u8]), BadNumber> {
    match short_decimal(text) {
        Some(number) => Ok(number),
        None => any_number(text),
    }
}

#[cold]
fn any_number(text: &[u8]) -> Result<(f32, &[u8]), BadNumber> {
    let (word, behind) = text.split_at(word_length(text));
    Ok((parse(word)?, behind))
}

/// How long the word at the front of `text` is. It is not looked at farther than needed to see that it is too long.
pub(crate) fn word_length(text: &[u8]) -> usize {
    let text = &text[..text.len().min(LONGEST_WORD + 1)];
    text.iter().position(|&byte| is_blank(byte)).unwrap_or(text.len())
}

/// `f32` and `f64`.
pub(crate) trait Float: fast_float2::FastFloat + Into<f64> {}

impl Float for f32 {}
impl Float for f64 {}

/// Reads a whole word.
pub(crate) fn parse<F: Float>(word: &[u8]) -> Result<F, BadNumber> {
    if word.len() > LONGEST_WORD {
        return Err(BadNumber::TooLong);
    }
    match fast_float2::parse::<F, _>(word) {
        Ok(number) if number.into().is_finite() => Ok(number),
        Ok(_) => Err(BadNumber::NotFinite),
        Err(_) => {
            let separated = word.iter().any(|byte| matches!(byte, b',' | b';'));
            let is_number = separated && word.iter().any(u8::is_ascii_digit);
            Err(if is_number { BadNumber::Separator } else { BadNumber::NotANumber })
        }
    }
}

/// Reads a number such as `-12.345`, `7` or `1.2e-006`, with at most seven digits on each side of the point.
/// `None` for anything else, also near the end of the text: there are other ways to read it.
///
/// The value of a decimal is its digits, read as one integer, divided by a power of ten. An exponent makes it
/// another power.
#[inline(always)]
fn short_decimal(text: &[u8]) -> Option<(f32, &[u8])> {
    let negative = text.first() == Some(&b'-');
    let text = &text[usize::from(negative)..];
    let (whole, whole_digits) = few_digits(text, 0)?;
    let (mut number, mut decimals, mut rest) = (whole, 0, &text[whole_digits..]);
    if let [b'.', behind @ ..] = rest {
        (number, decimals) = few_digits(behind, whole)?;
        rest = &behind[decimals..];
    }
    if whole_digits + decimals == 0 {
        return None;
    }
    if rest.first().is_some_and(|&byte| !is_blank(byte)) {
        (decimals, rest) = take_exponent(rest, decimals)?;
    }
    let magnitude = quotient(number, decimals)?;
    // The sign is put in as a bit: a branch would go now this way and now that, which is slow.
    Some((f32::from_bits(magnitude.to_bits() | u32::from(negative) << 31), rest))
}

/// Appends the digits at the front of `text` to `number`. Gives the result, and how many digits there are; `None`
/// if they are more than seven, or the text is so short that they could be more.
#[inline(always)]
fn few_digits(text: &[u8], mut number: u64) -> Option<(u64, usize)> {
    // A loop over so many bytes is unrolled, and there is no end of the text to look out for.
    for (count, byte) in text.first_chunk::<8>()?.iter().enumerate() {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return Some((number, count));
        }
        number = 10 * number + u64::from(digit);
    }
    None
}

/// Takes the exponent at the front of `text`, and what must be the end of the word behind it, out of the number
/// of decimals. Gives what is left of them, unless that is less than none, and the text behind the exponent.
#[inline]
fn take_exponent(text: &[u8], decimals: usize) -> Option<(usize, &[u8])> {
    let [b'e' | b'E', text @ ..] = text else { return None };
    let (negative, text) = match text {
        [b'-', behind @ ..] => (true, behind),
        [b'+', behind @ ..] => (false, behind),
        _ => (false, text),
    };
    let (exponent, digits) = few_digits(text, 0)?;
    let behind = &text[digits..];
    if digits == 0 || !behind.first().is_none_or(|&byte| is_blank(byte)) {
        return None;
    }
    let exponent = exponent as usize;
    let left = if negative { decimals.checked_add(exponent) } else { decimals.checked_sub(exponent) };
    Some((left?, behind))
}

/// `number` / 10^`decimals`, rounded to the nearest `f32`, for a number below 2^53 and up to 12 decimals.
///
/// An `f64` holds both sides of the division, so the quotient is rounded once, and making an `f32` of it rounds a
/// second time. Rounding twice goes wrong only if the first rounding lands on the middle between two neighbouring
/// `f32`s while the true quotient is next to it. Such a middle is M 2^e with M from 2^24 to 2^25, and the first
/// rounding moves by 2^(e-29) at most. But the two are farther apart than that. With k decimals their distance is
/// a multiple of 2^e / 5^k, and 5^12 < 2^29; or, where 2^e has no finer fraction than 2^-k, a multiple of 1 /
/// 10^k, and then number < 2^53 means 2^e 10^k < 2^29.
#[inline]
fn quotient(number: u64, decimals: usize) -> Option<f32> {
    const POWERS_OF_TEN: [f64; 13] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];
    // By way of `i64`, because processors have an instruction for that.
    Some((number as i64 as f64 / POWERS_OF_TEN.get(decimals)?) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// As the standard library reads the word, if it is finite.
    fn reference(word: &str) -> Option<u32> {
        word.parse().ok().filter(|number: &f32| number.is_finite()).map(f32::to_bits)
    }

    /// Reads `word` with nothing, little and much behind it.
    fn check(word: &str) {
        for behind in ["", " ", "\n1", " 1.5 2.5 3.5 4.5 5.5 6.5 7.5"] {
            let text = format!("{word}{behind}");
            let number = leading(text.as_bytes());
            let expected = reference(word).map(|bits| (bits, behind.as_bytes()));
            assert_eq!(number.ok().map(|(number, behind)| (number.to_bits(), behind)), expected, "{text:?}");
        }
    }

    #[test]
    fn numbers_are_those_of_the_standard_library() {
        let words = "0 1 -1 1.5 -0 -0.0 -0.000000 .5 5. -.5 +1.5 1e-006 1E5 1.25e+002 1.e3 .1e1 0.0083333 \
            0.1 123456789012345 1234567890123456 12345678.90123456 0.123456789012345678 99999.999999 \
            999999999999999.0 1.000000059604644775390625 3.4028235e38 1e-45 1e-46 0e999999999999 1.5e-12 1.5e-13";
        words.split_whitespace().for_each(check);
    }

    #[test]
    fn what_is_no_finite_number_is_told_apart() {
        let problems = [
            ("", BadNumber::NotANumber),
            ("-", BadNumber::NotANumber),
            (".", BadNumber::NotANumber),
            ("1.5e", BadNumber::NotANumber),
            ("1.5e-", BadNumber::NotANumber),
            ("1.2.3", BadNumber::NotANumber),
            ("--1.0", BadNumber::NotANumber),
            ("0x10", BadNumber::NotANumber),
            ("1.5f", BadNumber::NotANumber),
            ("1.#QNAN", BadNumber::NotANumber),
            ("1.5\0", BadNumber::NotANumber),
            ("١.٥", BadNumber::NotANumber),
            ("nan", BadNumber::NotFinite),
            ("-Infinity", BadNumber::NotFinite),
            ("1e39", BadNumber::NotFinite),
            ("1,5", BadNumber::Separator),
            ("1;2;3", BadNumber::Separator),
        ];
        for (word, problem) in problems {
            check(word);
            assert_eq!(leading(word.as_bytes()), Err(problem), "{word:?}");
        }
        assert_eq!(leading(&[b'1'; LONGEST_WORD + 1]), Err(BadNumber::TooLong));
    }

    #[test]
    fn middles_between_two_numbers_are_rounded_once() {
        // Decimals as close to the middle of two neighbouring f32s as they get.
        for bits in (0x3a00_0000u32..0x4e00_0000).step_by(9973) {
            let (low, high) = (f32::from_bits(bits), f32::from_bits(bits + 1));
            let middle = (f64::from(low) + f64::from(high)) / 2.0;
            for decimals in 0..=13 {
                let word = format!("{middle:.decimals$}");
                check(&word);
                check(&format!("{word}1"));
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn any_decimal_is_the_one_of_the_standard_library(word in "-?[0-9]{0,9}[.]?[0-9]{0,14}") {
            check(&word);
        }

        #[test]
        fn any_exponent_is_the_one_of_the_standard_library(word in "-?[0-9]{0,3}[.]?[0-9]{0,9}[eE][-+]?[0-9]{0,4}") {
            check(&word);
        }

        #[test]
        fn any_word_is_a_number_only_if_it_is_one_to_the_standard_library(word in "[-+.0-9einfxa,_]{1,12}") {
            check(&word);
        }
    }
}
