//! A hundred thousand errors in one line, each of which quotes the line.
//!
//! expect: does-not-compile "cannot find value" | too-expensive-to-compile

pub fn wrong() {
    @REPEAT 100000 b;@
}
