//! Asks for the variables that tell where everything lies and who makes the marks.
//!
//! expect: graded 15

const KNOWN: [Option<&str>; 8] = [
    option_env!("HOME"),
    option_env!("USER"),
    option_env!("PATH"),
    option_env!("PWD"),
    option_env!("CARGO_HOME"),
    option_env!("RUSTUP_HOME"),
    option_env!("CARGO"),
    option_env!("CARGO_TARGET_DIR"),
];
const _: () = {
    let mut i = 0;
    while i < KNOWN.len() {
        if let Some(known) = KNOWN[i] {
            panic!("{}", known);
        }
        i += 1;
    }
};
