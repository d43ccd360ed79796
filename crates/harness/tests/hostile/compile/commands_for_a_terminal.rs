//! An error of its own that holds commands for a terminal.
//!
//! expect: does-not-compile "u{1b}"

compile_error!("\u{1b}[2J\u{1b}[31mYou have 15 points\u{1b}]0;title\u{7}\u{9b}31m");
