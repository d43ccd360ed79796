//! A brace is missing, as it happens.
//!
//! expect: does-not-compile "unclosed delimiter"
//! quick: yes

pub fn unfinished() {
    if true {
}
