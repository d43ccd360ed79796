//! Sleeps for an hour: no processor time is used, but the clock goes on.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    std::thread::sleep(std::time::Duration::from_secs(3600));
}
