//! Becomes another user.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let own = system_call(102, [0; 3]) as usize;
    for user in [0, 1, 1000] {
        if user != own && (system_call(105, [user, 0, 0]) == 0 || system_call(117, [user, user, user]) == 0) {
            panic!("{user}");
        }
    }
}
