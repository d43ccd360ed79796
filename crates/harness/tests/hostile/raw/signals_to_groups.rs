//! Asks whether it may send signals to its group, which may be that of the program that asks.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let group = system_call(121, [0; 3]) as usize;
    let own = system_call(39, [0; 3]) as usize;
    // When it leads a group of its own, that group is none of anybody else.
    if group != own && system_call(62, [0, 0, 0]) == 0 {
        panic!("group {group}");
    }
}
