//! A hundred thousand warnings.
//!
//! expect: graded 15

pub fn warn() {
    @REPEAT 100000 ;@
}
