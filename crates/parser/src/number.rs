//! Numbers: the same values that [`str::parse`] gives, sooner.

use crate::source::{LONGEST_WORD, is_blank};

/// Powers of ten that an `f64` holds exactly, up to the most decimals that [`plain_decimal`] divides by.
const POWERS_OF_TEN: [f64; 13] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];

/// Why a word is not a number that can be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BadNumber {
    NotANumber,
    /// NaN, an infinity, or too far from zero to be held.
    NotFinite,
    /// A comma, where a point may be meant.
    Comma,
    TooLong,
}

/// Reads the number at the front of `text`, up to the next blank or the end of the text. Gives the number and the
/// length of its word.
pub(crate) fn leading(text: &[u8]) -> Result<(f32, usize), BadNumber> {
    match plain_decimal(text) {
        Some(number) => Ok(number),
        None => {
            let length = text.iter().position(|&byte| is_blank(byte)).unwrap_or(text.len());
            Ok((parse(&text[..length])?, length))
        }
    }
}

/// Reads a whole word, as an `f32` or as an `f64`.
pub(crate) fn parse<F: fast_float2::FastFloat + Into<f64>>(word: &[u8]) -> Result<F, BadNumber> {
    if word.len() > LONGEST_WORD {
        return Err(BadNumber::TooLong);
    }
    match fast_float2::parse::<F, _>(word) {
        Ok(number) if number.into().is_finite() => Ok(number),
        Ok(_) => Err(BadNumber::NotFinite),
        Err(_) if word.contains(&b',') && word.iter().any(u8::is_ascii_digit) => Err(BadNumber::Comma),
        Err(_) => Err(BadNumber::NotANumber),
    }
}

/// Reads a number such as `-12.345` at the front of `text`: a sign or none, up to 15 digits, a point among them or
/// none. `None` for anything else: there are other ways to read it.
///
/// The digits without the point are an integer D below 2^53, and an `f64` holds both it and 10^k, where k is the
/// number of decimals. So the division D / 10^k rounds once, and making an `f32` of it rounds a second time. Rounding
/// twice goes wrong only if the first rounding lands on the middle between two neighbouring `f32`s, M 2^e with M below 2^25,
/// though D / 10^k is not that middle. It cannot come that close: with k up to 12 the two differ by more than 2^(e-29), the
/// half of an `f64`'s last place there. (Their difference is a multiple of 2^e / 5^k, and 5^12 < 2^29; or, if
/// 2^e is coarser than 2^-k, of 1 / 10^k, and then D < 2^53 says that 2^e 10^k < 2^29.)
fn plain_decimal(text: &[u8]) -> Option<(f32, usize)> {
    let negative = *text.first()? == b'-';
    let mut at = usize::from(negative);
    let mut digits = 0u64;
    let (whole, behind) = take_digits(text, at, &mut digits);
    at = behind;
    let mut decimals = 0;
    if text.get(at) == Some(&b'.') {
        (decimals, at) = take_digits(text, at + 1, &mut digits);
    }
    let usable = (1..=15).contains(&(whole + decimals)) && text.get(at).is_none_or(|&byte| is_blank(byte));
    let magnitude = (digits as f64 / POWERS_OF_TEN.get(decimals)?) as f32;
    usable.then_some((if negative { -magnitude } else { magnitude }, at))
}

/// Appends the decimal digits from `text[at]` on to `number`. Gives how many there are, and the index behind them.
#[inline(always)]
fn take_digits(text: &[u8], mut at: usize, number: &mut u64) -> (usize, usize) {
    let start = at;
    while let Some(&byte) = text.get(at)
        && byte.is_ascii_digit()
    {
        *number = number.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
        at += 1;
    }
    (at - start, at)
}
