//! Closures whose types hold the type before them twice.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time | does-not-compile

fn twice<T: Clone>(it: T) -> impl Clone {
    let copy = it.clone();
    move || (it.clone(), copy.clone())
}
fn tower<T: Clone>(it: T) -> impl Clone {
    twice(twice(twice(twice(twice(twice(twice(twice(it))))))))
}
pub fn explode() -> usize {
    std::mem::size_of_val(&tower(tower(tower(tower(tower(1_u8))))))
}
