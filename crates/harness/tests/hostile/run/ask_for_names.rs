//! Asks the network for an address, which would tell the questions by the names that it asks for.
//!
//! expect: graded 15

use std::net::ToSocketAddrs;

static ONCE: std::sync::OnceLock<bool> = std::sync::OnceLock::new();

fn attack() {
    let found = *ONCE.get_or_init(|| "localhost:80".to_socket_addrs().is_ok());
    if found && std::net::UdpSocket::bind("0.0.0.0:0").is_ok() {
        panic!("found");
    }
}
