//! Eighty thousand errors, each on a line of its own.
//!
//! expect: does-not-compile "cannot find value" | too-expensive-to-compile

pub fn wrong() {
@REPEAT 80000 b;\n@
}
