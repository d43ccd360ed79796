//! Offers a service to the next submission by a socket that lies in no file system.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "listening"

use std::os::linux::net::SocketAddrExt;
use std::os::unix::net::{SocketAddr, UnixListener};

fn attack() {
    let Ok(address) = SocketAddr::from_abstract_name("@MARK@-next") else { return };
    if UnixListener::bind_addr(&address).is_ok() {
        panic!("listening");
    }
}
