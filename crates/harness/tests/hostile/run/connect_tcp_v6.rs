//! The same by the newer version of the protocol.
//!
//! expect: graded 15

fn attack() {
    if std::net::TcpStream::connect("[::1]:@TCP@").is_ok() || std::net::TcpStream::connect("[::ffff:127.0.0.1]:@TCP@").is_ok() {
        panic!("connected");
    }
}
