//! A macro that doubles what it is given, so that the compiler's memory is full after thirty steps.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time
//! quick: yes

macro_rules! double {
    ($($all:tt)*) => { double!($($all)* $($all)*); };
}
double!(a b c d e f g h);
