//! Opens devices.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for device in ["/dev/zero", "/dev/full", "/dev/kmsg", "/dev/mem", "/dev/sda", "/dev/vda", "/dev/fuse", "/dev/kvm", "/dev/net/tun"] {
        if std::fs::File::open(device).is_ok() {
            panic!("{device}");
        }
    }
}
