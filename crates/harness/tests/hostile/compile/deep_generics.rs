//! Boxes in boxes, forty thousand deep.
//!
//! expect: does-not-compile | too-expensive-to-compile time | too-expensive-to-compile memory

use Box as B;
pub fn deep(_: @REPEAT 60000 B<@u8@REPEAT 60000 >@) {}
