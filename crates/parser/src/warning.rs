//! What is read although it is not as it should be.

use std::fmt;

use crate::source::Place;

/// Something odd in a text that could be read all the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning<K> {
    /// Where: the line, from 1.
    pub line: u64,
    /// Where in the line: the character, from 1.
    pub column: u64,
    /// What.
    pub kind: K,
}

impl<K: fmt::Display> fmt::Display for Warning<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line, self.column, self.kind)
    }
}

/// Adds a warning, unless there is one of its kind already: a bad file must not fill the memory with complaints.
pub(crate) fn warn<K>(warnings: &mut Vec<Warning<K>>, place: Place, kind: K) {
    let same = |other: &Warning<K>| std::mem::discriminant(&other.kind) == std::mem::discriminant(&kind);
    if !warnings.iter().any(same) {
        warnings.push(Warning { line: place.line, column: place.column, kind });
    }
}
