//! The same in the way of earlier editions.
//!
//! expect: does-not-compile "unsafe attribute"

#[used]
#[link_section = ".init_array"]
static FIRST: extern "C" fn() = {
    extern "C" fn first() {
        std::process::exit(0)
    }
    first
};
