//! Closures whose types hold the type before them twice, forty times.
//!
//! place: before local_quaternion
//! expect: graded 10; part1 crashed | too-expensive-to-compile memory | too-expensive-to-compile time | does-not-compile

fn attack() {
    std::hint::black_box(tower(tower(tower(tower(tower(1_u8))))));
}

fn twice<T: Clone>(it: T) -> impl Clone {
    let copy = it.clone();
    move || (it.clone(), copy.clone())
}

fn tower<T: Clone>(it: T) -> impl Clone {
    twice(twice(twice(twice(twice(twice(twice(twice(it))))))))
}
