//! Brings a main function and a table of functions of its own. They are in its own module, where nobody calls them.
//!
//! expect: graded 15

pub fn main() {
    std::process::exit(0)
}
pub const FUNCTIONS: u8 = 0;
