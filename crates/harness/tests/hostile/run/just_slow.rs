//! Takes a tenth of a second for each joint. Each answer comes, but all together take too long.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    std::thread::sleep(std::time::Duration::from_millis(300));
}
