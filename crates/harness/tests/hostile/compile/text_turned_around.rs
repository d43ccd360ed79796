//! Letters that turn the writing direction around, so that code looks other than it is.
//!
//! expect: does-not-compile "U+202E" | does-not-compile "202e" | does-not-compile "bidirectional"

// The compiler refuses these in comments and in text: @CHAR 202E@ @CHAR 2066@ }
pub const TURNED: &str = "@CHAR 202E@nigeb";
