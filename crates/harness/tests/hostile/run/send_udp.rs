//! Sends the questions as single packets, which Landlock alone would let through.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "sent"

fn attack() {
    let Ok(socket) = std::net::UdpSocket::bind("127.0.0.1:0") else { return };
    if socket.send_to(b"@MARK@", "127.0.0.1:@UDP@").is_ok() {
        panic!("sent");
    }
}
