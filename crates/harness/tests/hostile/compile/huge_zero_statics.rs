//! Many statics of 64 MiB of zeros: each is small enough for the compiler, and together they are more memory
//! than the program may have, so that it cannot even begin.
//!
//! place: before local_quaternion
//! expect: too-expensive-to-compile time | too-expensive-to-compile memory | graded 0

type Huge = [u8; 64 << 20];

macro_rules! statics {
    ($($name:ident)*) => {
        $(static $name: Huge = [0; 64 << 20];)*
        fn attack() {
            $(std::hint::black_box(&$name);)*
        }
    };
}
statics!(A B C D E F G H I J K L M N O P Q R S T);
