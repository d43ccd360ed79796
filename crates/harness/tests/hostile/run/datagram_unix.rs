//! Sends single packets to a service of this machine.
//!
//! expect: graded 15

fn attack() {
    let Ok(socket) = std::os::unix::net::UnixDatagram::unbound() else { return };
    for path in ["/dev/log", "/run/systemd/journal/socket", "@UNIX@"] {
        if socket.send_to(b"@MARK@", path).is_ok() {
            panic!("{path}");
        }
    }
}
