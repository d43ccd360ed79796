//! How numbers are shown and written.

use std::fmt;

/// A number in the fewest digits that read back as the same number; with an exponent if it is very small or large.
pub(crate) struct Shortest<F>(pub F);

impl<F: Copy + Into<f64> + fmt::Display + fmt::LowerExp> fmt::Display for Shortest<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let magnitude: f64 = self.0.into().abs();
        if magnitude == 0.0 || (1e-5..1e9).contains(&magnitude) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

/// `1 number`, `2 numbers`.
pub(crate) fn counted(count: u64, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}
