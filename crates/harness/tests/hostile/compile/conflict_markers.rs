//! A file as a version control system left it.
//!
//! expect: does-not-compile "diff marker"

<<<<<<< HEAD
pub fn mine() {}
=======
pub fn theirs() {}
>>>>>>> main
