//! Chooses who gives out memory. It may: it is the same allocator.
//!
//! expect: graded 15

#[global_allocator]
static OWN: std::alloc::System = std::alloc::System;
