//! Uses what the libraries that it may use are made of.
//!
//! expect: does-not-compile "can't find crate"

extern crate postcard;
extern crate serde;
