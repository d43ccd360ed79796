//! A constant that holds one large array after the other.
//!
//! expect: too-expensive-to-compile memory | too-expensive-to-compile time | does-not-compile

#[allow(long_running_const_eval)]
const HOG: usize = {
    const fn keep(depth: usize) -> usize {
        let held = [depth as u8; 1 << 26];
        if depth == 0 { held[3] as usize } else { keep(depth - 1) + held[5] as usize }
    }
    keep(100)
};
