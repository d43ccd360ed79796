//! Known ways to be wrong, or right all the same.

use exam::Functions;

/// A known way to be wrong. It is recognised by its answers: those of one of its variants.
#[derive(Debug)]
pub struct Misconception {
    /// A short name for tables, for example `order_reversed`.
    pub id: &'static str,
    /// What was misunderstood, in one sentence to the student.
    pub title: &'static str,
    /// Why that is not so.
    pub explanation: &'static str,
    /// What to look at next. Not the answer.
    pub hint: &'static str,
    /// The checks whose answers it shows in: all of these are compared with its variants'.
    pub seen_in: &'static [&'static str],
    /// The checks that it fails. There may be others than those it is recognised by.
    pub costs: &'static [&'static str],
    /// Functions with this misconception and no other. Their answers are what is recognised.
    pub variants: Vec<Functions>,
}

/// A way that is not quite right and accepted all the same, with a remark.
#[derive(Debug)]
pub struct Accepted {
    /// What is said to the student.
    pub remark: &'static str,
    /// Functions that answer this way.
    pub functions: Functions,
}
