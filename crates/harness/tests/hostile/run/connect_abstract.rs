//! Talks to a service by a socket that lies in no file system.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "connected"

use std::os::linux::net::SocketAddrExt;
use std::os::unix::net::{SocketAddr, UnixStream};

fn attack() {
    let Ok(address) = SocketAddr::from_abstract_name("@ABSTRACT@") else { return };
    if UnixStream::connect_addr(&address).is_ok() {
        panic!("connected");
    }
}
