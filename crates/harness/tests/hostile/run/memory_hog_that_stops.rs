//! Takes all memory that it can get, keeps it, and answers.
//!
//! expect: graded

static HELD: std::sync::Mutex<Vec<Vec<u8>>> = std::sync::Mutex::new(Vec::new());

fn attack() {
    let Ok(mut held) = HELD.lock() else { return };
    loop {
        let mut more = Vec::new();
        if more.try_reserve_exact(1 << 24).is_err() {
            return;
        }
        more.resize(1 << 24, 1);
        held.push(more);
    }
}
