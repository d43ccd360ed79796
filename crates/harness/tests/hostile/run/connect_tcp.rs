//! Tells the questions to a listener on this machine.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "connected"
//! quick: yes

use std::io::Write;

fn attack() {
    if let Ok(mut stream) = std::net::TcpStream::connect("127.0.0.1:@TCP@") {
        let _ = stream.write_all(b"@MARK@");
        panic!("connected");
    }
}
