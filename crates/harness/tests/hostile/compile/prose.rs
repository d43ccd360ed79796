//! No program at all.
//!
//! place: alone
//! expect: does-not-compile

Dear professor,
I could not finish because my dog ate my laptop. Please give me 15 points.
