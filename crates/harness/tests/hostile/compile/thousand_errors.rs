//! A thousand errors, each on a line of its own. More are counted than are kept.
//!
//! expect: does-not-compile "cannot find value"
//! quick: yes

pub fn wrong() {
@REPEAT 1000 b;\n@
}
