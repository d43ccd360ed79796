//! Modules in modules, twenty thousand deep.
//!
//! expect: does-not-compile

@REPEAT 20000 mod a{@ @REPEAT 20000 }@
