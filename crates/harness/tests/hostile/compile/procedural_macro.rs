//! Is a procedural macro, which would run inside the compiler.
//!
//! expect: does-not-compile "proc-macro"

#[proc_macro]
pub fn run(_: proc_macro::TokenStream) -> proc_macro::TokenStream {
    loop {}
}
