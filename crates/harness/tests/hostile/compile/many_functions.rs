//! Four thousand functions from a few lines.
//!
//! expect: graded 15 | too-expensive-to-compile time | too-expensive-to-compile memory

macro_rules! sixteen {
    ($next:ident $($rest:ident)*) => {
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
        const _: () = { $next!($($rest)*); };
    };
}
macro_rules! one {
    () => {
        #[used]
        static KEPT: fn(u64) -> u64 = {
            fn function(a: u64) -> u64 { a.wrapping_mul(3).rotate_left(7) }
            function
        };
    };
}
sixteen!(sixteen sixteen one);
