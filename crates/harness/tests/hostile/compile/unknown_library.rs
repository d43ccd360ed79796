//! Uses a library that is not there.
//!
//! expect: does-not-compile "rand"

use rand::Rng;
pub fn lucky() -> bool {
    rand::rng().random()
}
