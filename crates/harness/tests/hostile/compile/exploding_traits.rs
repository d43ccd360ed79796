//! A question about types that the compiler can only answer by asking more and more of them.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time | does-not-compile

trait Endless {}
struct Nest<T>(T);
impl<T> Endless for Nest<T> where Nest<Nest<(T, T)>>: Endless {}
fn ask<T: Endless>() {}
pub fn explode() {
    ask::<Nest<u8>>();
}
