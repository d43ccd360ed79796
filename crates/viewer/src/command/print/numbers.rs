//! Numbers as people read them.

/// A length in the table. What is next to nothing in a skeleton of this `extent` is a zero: many programs write one so.
pub fn length(value: f64, extent: f64) -> String {
    let negligible = value.abs() < (1e-4 * extent).min(5e-4);
    number(if negligible { 0.0 } else { value }, 3)
}

/// `value` with `decimals` digits behind the point, more where a small number needs them to be told from another.
pub fn number(value: f64, decimals: usize) -> String {
    if !is_plain(value) {
        return scientific(value);
    }
    if value == 0.0 || value.abs() >= 0.01 {
        // Adding zero makes a plain zero of a negative one.
        return format!("{:.decimals$}", value + 0.0);
    }
    let (least, most) = (decimals, decimals + 3);
    let mut text = format!("{value:.most$}");
    let zeros = text.bytes().rev().take_while(|digit| *digit == b'0').count();
    text.truncate(text.len() - zeros.min(most - least));
    text
}

/// A text of [`number`] without zeros at its end that say nothing.
pub fn shortened(number: String) -> String {
    match number.contains('.') && !number.contains('e') {
        true => number.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => number,
    }
}

/// Whether a number is read most easily as digits around a point.
pub fn is_plain(value: f64) -> bool {
    value == 0.0 || (1e-3..1e7).contains(&value.abs())
}

/// At most five digits and a power of ten, for example `-1.5e12`.
pub fn scientific(value: f64) -> String {
    let text = format!("{value:.4e}");
    match text.split_once('e') {
        Some((digits, power)) => {
            format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
        }
        // Infinity, or no number.
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_neither_false_nor_long() {
        let offsets = [
            (0.0, "0.000"),
            (-0.0, "0.000"),
            (f32::from_bits(1), "1.4013e-45"),
            (1e-5, "1e-5"),
            (-0.00123, "-0.00123"),
            (0.005, "0.005"),
            (0.25, "0.250"),
            (-42.9, "-42.900"),
            (1234.5678, "1234.568"),
            (9_999_999.0, "9999999.000"),
            (1e7, "1e7"),
            (-1.5e12, "-1.5e12"),
            (3e38, "3e38"),
        ];
        for (offset, text) in offsets {
            assert_eq!(number(offset.into(), 3), text);
        }
        let lengths =
            [(-1e-4, 2.0, "0.000"), (-1e-4, 0.1, "-1e-4"), (2e-3, 1e9, "0.002"), (1e-40, 1e-40, "1e-40")];
        for (value, extent, text) in lengths {
            assert_eq!(length(value, extent), text);
        }
        assert_eq!((number(f64::INFINITY, 2), number(1e-300, 2)), ("inf".into(), "1e-300".into()));
    }
}
