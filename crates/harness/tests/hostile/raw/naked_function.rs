//! A function that is nothing but instructions: the compiler's ban of unsafe code does not know of these. Here a harmless
//! one, which shows that it works.
//!
//! expect: graded 10; part1 panicked "I am"

#[unsafe(naked)]
extern "C" fn own_process() -> i32 {
    core::arch::naked_asm!("mov eax, 39", "syscall", "ret")
}

fn attack() {
    panic!("I am {}", own_process());
}
