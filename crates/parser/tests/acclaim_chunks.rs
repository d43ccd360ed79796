//! An Acclaim text is the same whatever pieces it arrives in.

mod common;

use std::io::Read;

use common::acclaim::{AMC, ASF, amc, asf, figure};
use common::pieces::Pieces;
use parser::acclaim;
use proptest::prelude::*;

/// All that can be seen of a reading: the skeleton to the last bit, the warnings, or the whole message.
fn skeleton(source: impl Read) -> String {
    match acclaim::read_skeleton(source) {
        Ok(reading) => format!("{reading:?}"),
        Err(error) => format!("{error}"),
    }
}

/// The same of a motion.
fn motion(source: impl Read) -> String {
    match acclaim::read_motion(source, &figure()) {
        Ok(reading) => format!("{reading:?}"),
        Err(error) => format!("{error}"),
    }
}

/// Texts that end in all kinds of ways.
fn texts(fixed: Vec<String>) -> impl Strategy<Value = Vec<u8>> {
    let utf16 = |text: &String| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let texts: Vec<Vec<u8>> =
        fixed.iter().map(|text| text.as_bytes().to_vec()).chain(fixed.iter().map(utf16)).collect();
    (proptest::sample::select(texts), any::<proptest::sample::Index>(), any::<bool>()).prop_map(
        |(mut text, end, cut)| {
            if cut {
                text.truncate(end.index(text.len() + 1));
            }
            text
        },
    )
}

fn skeletons() -> impl Strategy<Value = Vec<u8>> {
    texts(vec![
        ASF.to_owned(),
        ASF.replace('\n', "\r\n"),
        ASF.replace('\n', "\r"),
        ASF.replace('\n', " # end ( 1\r\n"),
        ASF.replace("hip", "Hüfte_腰_🦴"),
        asf("hip", &"ü".repeat(3000)),
        asf("One leg.", &"# ( :".repeat(3000)),
        asf("(-160.0 20.0)", &format!("({} 20)", "1".repeat(5000))),
        asf("length 2", "length two"),
        format!("\u{feff}{ASF}"),
    ])
}

fn motions() -> impl Strategy<Value = Vec<u8>> {
    texts(vec![
        AMC.to_owned(),
        AMC.replace('\n', "\r\n"),
        AMC.replace('\n', "\r"),
        AMC.replace('\n', " # 1 2 3\n"),
        amc("#!OML", &format!("#{}", "x ".repeat(3000))),
        amc("\n2\n", &format!("\n{}2\n", " ".repeat(5000))),
        amc("shin 10", "shin 10 11"),
        amc("shin 10", &"shin".repeat(2000)),
        format!("\u{feff}{AMC}"),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn pieces_do_not_matter(
        one in skeletons(),
        other in motions(),
        sizes in prop::collection::vec(0usize..40, 1..20),
    ) {
        prop_assume!(sizes.iter().any(|&size| size > 0));
        prop_assert_eq!(skeleton(Pieces::new(&one, &sizes)), skeleton(&one[..]));
        prop_assert_eq!(motion(Pieces::new(&other, &sizes)), motion(&other[..]));
    }
}
