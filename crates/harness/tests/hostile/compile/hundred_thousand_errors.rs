//! Eighty thousand errors, each on a line of its own.
//!
//! expect: does-not-compile "cannot find value"
//! quick: yes

pub fn wrong() {
@REPEAT 80000 b;\n@
}
