//! Motions reduced to keyframes.
#![deny(missing_docs)]
