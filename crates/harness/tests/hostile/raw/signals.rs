//! Asks whether it may send signals: to the program that asks, to the first process, to all.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let parent = system_call(110, [0; 3]) as usize;
    // Signal 0 asks, and does nothing. In a name space of its own it is itself the first process, and has no parent.
    let own = system_call(39, [0; 3]) as usize;
    for process in [parent, 1] {
        if process > 0 && process != own && system_call(62, [process, 0, 0]) == 0 {
            panic!("{process}");
        }
    }
}
