//! Lets the loader call it before the program begins.
//!
//! expect: does-not-compile "unsafe"

#[used]
#[unsafe(link_section = ".init_array")]
static FIRST: extern "C" fn() = {
    extern "C" fn first() {
        std::process::exit(0)
    }
    first
};
