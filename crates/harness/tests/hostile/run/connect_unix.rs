//! Talks to a service by a socket in the file system.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "connected"

fn attack() {
    if std::os::unix::net::UnixStream::connect("@UNIX@").is_ok() {
        panic!("connected");
    }
}
