//! Asks for a variable of the environment in which the marks are made.
//!
//! expect: does-not-compile "not defined at compile time"
//! quick: yes

const STOLEN: &str = env!("FK_LAB_PLANTED");
