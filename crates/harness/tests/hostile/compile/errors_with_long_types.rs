//! Errors whose types are pages long.
//!
//! expect: does-not-compile | too-expensive-to-compile

type A<T> = (T, T, T, T, T, T, T, T);
pub fn wrong(a: A<A<A<A<u8>>>>) {
    @REPEAT 200 let _: u8 = a;\n@
}
