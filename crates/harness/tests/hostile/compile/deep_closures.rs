//! Closures in closures, fifty thousand deep.
//!
//! expect: does-not-compile

pub fn deep() {
    let _ = @REPEAT 50000 ||@1;
}
