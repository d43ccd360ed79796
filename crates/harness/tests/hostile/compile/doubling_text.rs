//! Macros that double a text, from one letter to a thousand million.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time

macro_rules! eight {
    ($text:expr) => { concat!($text, $text, $text, $text, $text, $text, $text, $text) };
}
const HUGE: &str = eight!(eight!(eight!(eight!(eight!(eight!(eight!(eight!(eight!(eight!(eight!("x")))))))))));
