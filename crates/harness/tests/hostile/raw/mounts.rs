//! Puts other folders in the place of its own.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let (root, proc) = (c"/", c"proc");
    let calls = [(165, [address(proc), address(root), address(proc)]), (166, [address(root), 2, 0]), (155, [address(root), address(root), 0]), (428, [0, address(root), 0]), (430, [address(proc), 0, 0]), (161, [address(root), 0, 0])];
    for (number, arguments) in calls {
        if system_call(number, arguments) >= 0 {
            panic!("{number}");
        }
    }
}
