//! Waits for others to call.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "listening"

fn attack() {
    if std::net::TcpListener::bind("127.0.0.1:0").is_ok() {
        panic!("listening");
    }
}
