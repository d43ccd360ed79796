//! Asks the kernel for what only its friends get.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    // bpf, perf_event_open, userfaultfd, init_module, kexec_load, reboot, settimeofday, open_by_handle_at, fanotify_init,
    // swapon, syslog, acct, quotactl.
    for (number, arguments) in [(321, [0, 0, 0]), (298, [0, 0, 0]), (323, [0, 0, 0]), (175, [0, 0, 0]), (246, [0, 0, 0]), (169, [0, 0, 0]), (164, [0, 0, 0]), (304, [0, 0, 0]), (300, [0, 0, 0]), (167, [0, 0, 0]), (103, [2, 0, 0]), (163, [0, 0, 0]), (179, [0, 0, 0])] {
        if system_call(number, arguments) >= 0 {
            panic!("{number}");
        }
    }
}
