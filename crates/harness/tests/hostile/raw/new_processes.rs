//! Starts processes in all the ways there are.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    const WAYS: [(&str, usize, [usize; 3]); 5] = [
        ("fork", 57, [0; 3]),
        ("vfork by clone", 56, [0x4000 | 17, 0, 0]),
        ("clone", 56, [17, 0, 0]),
        ("clone with CLONE_PARENT", 56, [0x8000 | 17, 0, 0]),
        ("clone into namespaces", 56, [0x1000_0000 | 17, 0, 0]),
    ];
    for (name, number, arguments) in WAYS {
        match system_call(number, arguments) {
            0 => std::process::exit(0),
            child if child > 0 => panic!("{name}"),
            _ => {}
        }
    }
}
