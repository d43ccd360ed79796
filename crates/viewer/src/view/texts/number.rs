//! Numbers as people read them.

use std::fmt;

/// A number with three digits that matter, and none behind the point that does not.
#[derive(Clone, Copy, Debug)]
pub struct Rounded(pub f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.0;
        if !(1e-3..1e7).contains(&number.abs()) {
            if number == 0.0 || !number.is_finite() {
                return write!(f, "{}", number + 0.0);
            }
            let mut digits = 2;
            let mut whole = (number.abs() / 10f64.powf(number.abs().log10().floor() - 2.0)).round();
            while digits > 0 && whole % 10.0 == 0.0 {
                whole /= 10.0;
                digits -= 1;
            }
            return write!(f, "{number:.digits$e}");
        }
        let mut digits = (2 - number.abs().log10().floor() as i32).clamp(0, 6) as usize;
        let mut whole = (number.abs() * 10f64.powi(digits as i32)).round();
        while digits > 0 && whole % 10.0 == 0.0 {
            whole /= 10.0;
            digits -= 1;
        }
        write!(f, "{number:.digits$}")
    }
}

/// How many there are of something: `1 frame`, `2 frames`.
pub fn count<'a>(number: usize, one: &'a str, many: &'a str) -> Count<'a> {
    Count { number, one, many }
}

/// What [`count`] gives, to be written.
#[derive(Clone, Copy, Debug)]
pub struct Count<'a> {
    number: usize,
    one: &'a str,
    many: &'a str,
}

impl fmt::Display for Count<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.number, if self.number == 1 { self.one } else { self.many })
    }
}

/// Numbers in a row, each with so many digits behind the point.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a>(pub &'a [f32], pub usize);

impl fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row(numbers, digits) = *self;
        for (index, number) in numbers.iter().enumerate() {
            if index > 0 {
                f.write_str(", ")?;
            }
            match number.abs() < 1e7 || !number.is_finite() {
                // No −0.
                true => write!(f, "{:.digits$}", number + 0.0)?,
                false => write!(f, "{number:.2e}")?,
            }
        }
        Ok(())
    }
}

/// How many digits behind the point tell lengths apart in a figure of this size.
pub fn digits_for(size: f32) -> usize {
    (3 - size.log10().floor() as i32).clamp(1, 9) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (number, text) in [
            (0.5, "0.5"),
            (20.0, "20"),
            (119.97, "120"),
            (29.97, "30"),
            (0.002, "0.002"),
            (2e11, "2e11"),
            (9_536_159_843.6, "9.54e9"),
            (1.5e10, "1.5e10"),
            (0.999_9e9, "1e9"),
            (0.000_012_34, "1.23e-5"),
            (f64::INFINITY, "inf"),
            (0.0, "0"),
            (-0.25, "-0.25"),
            (59.94, "59.9"),
            (1.0 / 0.0083333, "120"),
            (1234.0, "1234"),
        ] {
            assert_eq!(Rounded(number).to_string(), text);
        }
        assert_eq!(Rounded(f64::NAN).to_string(), "NaN");
    }

    #[test]
    fn rows_have_the_digits_that_matter() {
        assert_eq!(Row(&[1.0, -0.0, 2.345], 2).to_string(), "1.00, 0.00, 2.35");
        assert_eq!(Row(&[f32::NAN, 1e30], 1).to_string(), "NaN, 1.00e30");
        assert_eq!((digits_for(180.0), digits_for(1.8), digits_for(1e-30), digits_for(1e9)), (1, 3, 9, 1));
    }
}
