//! A type that doubles with every line: the last would hold more values than there are atoms.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time | does-not-compile

type A<T> = (T, T, T, T, T, T, T, T);
type B<T> = A<A<A<A<T>>>>;
type C<T> = B<B<B<B<T>>>>;
type D<T> = C<C<C<C<T>>>>;
pub fn explode(all: &D<u8>) -> usize {
    std::mem::size_of_val(all)
}
