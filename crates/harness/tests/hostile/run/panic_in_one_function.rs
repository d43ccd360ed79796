//! Panics where it computes positions, and nowhere else.
//!
//! place: before global_position
//! expect: graded 10; part3 panicked

fn attack() {
    let nothing: Option<u8> = None;
    nothing.unwrap();
}
