// Any system call, any address, without the word that is forbidden. The compiler's known hole (rust-lang/rust issue 25860)
// makes a reference live longer than what it refers to; with it a value of one type is read as another. The instructions
// are the bytes of a number: the compiler writes them into the code of `gate`, two bytes after its beginning.

static UNIT: &&() = &&();

fn lengthen<'a, 'b, T: ?Sized>(_: &'a &'b (), it: &'b mut T) -> &'a mut T {
    it
}

fn forever<'a, 'b, T: ?Sized>(it: &'a mut T) -> &'b mut T {
    let lengthen: for<'x> fn(_, &'x mut T) -> &'b mut T = lengthen;
    lengthen(UNIT, it)
}

enum Either<A, B> {
    First(Option<Box<A>>),
    Second(Option<Box<B>>),
}

fn transmute<A, B>(value: A) -> B {
    let mut either: Either<B, A> = Either::Second(None);
    let slot = forever(match &mut either {
        Either::Second(slot) => slot,
        Either::First(_) => unreachable!(),
    });
    either = Either::First(None);
    *slot = Some(Box::new(value));
    match std::hint::black_box(&mut either) {
        Either::First(slot) => *slot.take().unwrap(),
        Either::Second(_) => unreachable!(),
    }
}

#[inline(never)]
fn gate() -> u64 {
    // mov rax, rcx; syscall; ret
    0x9090_c305_0fc8_8948
}

fn system_call(number: usize, [a, b, c]: [usize; 3]) -> isize {
    let call: extern "C" fn(usize, usize, usize, usize) -> isize = transmute(gate as *const () as usize + 2);
    call(a, b, c, number)
}

#[allow(dead_code)]
fn address<T: ?Sized>(it: &T) -> usize {
    it as *const T as *const u8 as usize
}
