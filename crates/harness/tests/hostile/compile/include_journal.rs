//! Reads the verdicts on others from the run's own journal.
//!
//! expect: does-not-compile "couldn't read"

const STOLEN: &str = include_str!("@JOURNAL@");
const _: () = panic!("{}", STOLEN);
