//! Opens sockets of every kind.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    // unix, inet, inet6, netlink, packet, alg, vsock; as stream, datagram and raw.
    for family in [1, 2, 10, 16, 17, 38, 40] {
        for kind in [1, 2, 3] {
            if system_call(41, [family, kind, 0]) >= 0 {
                panic!("family {family}, kind {kind}");
            }
        }
    }
}
