//! The same behind `cfg_attr`.
//!
//! expect: does-not-compile "unsafe"

#[used]
#[cfg_attr(all(), unsafe(link_section = ".init_array"))]
static FIRST: extern "C" fn() = {
    extern "C" fn first() {
        std::process::exit(0)
    }
    first
};
