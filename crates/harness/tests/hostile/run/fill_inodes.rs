//! Makes files and folders until there is no room for more. (It stops at a thousand.)
//!
//! expect: graded 15

static ONCE: std::sync::OnceLock<u64> = std::sync::OnceLock::new();

fn attack() {
    let made = *ONCE.get_or_init(|| {
        let mut made = 0;
        for folder in ["/tmp", "/var/tmp", "/dev/shm", "/run", "/", ".", "@OUTSIDE@"] {
            for number in 0..1000 {
                match std::fs::create_dir(format!("{folder}/@MARK@-inode-{number}")) {
                    Ok(()) => made += 1,
                    Err(_) => break,
                }
            }
        }
        made
    });
    if made > 0 {
        panic!("{made} folders");
    }
}
