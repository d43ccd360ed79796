//! An error of its own that turns the writing direction around.
//!
//! expect: does-not-compile "u{202e}"

compile_error!("\u{202e}stniop 51\u{2066}");
