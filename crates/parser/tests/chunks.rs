//! A text is the same whatever pieces it arrives in.

mod common;

use std::io::Read;

use common::pieces::Pieces;
use common::{GOOD, with};
use parser::bvh;
use proptest::prelude::*;

/// All that can be seen of a reading: the motion to the last bit, the warnings, or the whole message.
fn outcome(source: impl Read) -> String {
    match bvh::read(source) {
        Ok(reading) => format!("{reading:?}"),
        Err(error) => format!("{error}"),
    }
}

/// Texts that end in all kinds of ways.
fn texts() -> impl Strategy<Value = Vec<u8>> {
    let long_line = with("1 2 3\n4 5 6", &"1.5 ".repeat(100)).replace("Frames: 2", "Frames: 33");
    let fixed = [
        GOOD.to_owned(),
        GOOD.replace('\n', "\r\n"),
        GOOD.replace('\n', "\r"),
        GOOD.replace('\n', "\r\r\n"),
        with("Hips", "Hüfte 腰 🦴"),
        with("Hips", &"ü".repeat(3000)),
        with("5", &"5".repeat(5000)),
        with("4 5 6", "4 5 six"),
        with("4 5 6", "4 5 6\n7 8 9\nend"),
        long_line.replace("Frames: 33", "Frames: 34"),
        long_line.replacen("1.5 ", "ü ", 90),
        format!("\u{feff}{GOOD}"),
    ];
    let utf16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let mut texts: Vec<Vec<u8>> = fixed.iter().map(|text| text.as_bytes().to_vec()).collect();
    texts.push(utf16(&fixed[4]));
    texts.push(utf16(&fixed[7]));
    (proptest::sample::select(texts), any::<proptest::sample::Index>(), any::<bool>()).prop_map(
        |(mut text, end, cut)| {
            if cut {
                text.truncate(end.index(text.len() + 1));
            }
            text
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn pieces_do_not_matter(text in texts(), sizes in prop::collection::vec(0usize..40, 1..20)) {
        prop_assume!(sizes.iter().any(|&size| size > 0));
        let pieces = Pieces::new(&text, &sizes);
        prop_assert_eq!(outcome(pieces), outcome(&text[..]));
    }
}
