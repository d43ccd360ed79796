//! What holds whatever students are called and write.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use std::fs;
use std::path::Path;

use common::{FORMULA, NASTY, graded, record, run, write};
use proptest::prelude::*;
use results::{
    Change, CompileError, Gradebook, Lms, Options, PartState, Percent, Picture, Points, Record, Student,
    Verdict,
};

/// Files by name, with what is in them.
fn outputs(records: &[Record], options: &Options) -> Vec<(String, String)> {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &run(), records, options).unwrap();
    let mut all = Vec::new();
    collect(folder.path(), folder.path(), &mut all);
    all
}

fn collect(root: &Path, folder: &Path, all: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(root, &path, all);
        } else {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap().to_owned();
            all.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

fn file<'a>(outputs: &'a [(String, String)], name: &str) -> &'a str {
    &outputs.iter().find(|(found, _)| found == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// A record in which every text that anybody may have written is this one.
fn everywhere(text: &str, id: &str) -> Vec<Record> {
    let not_compiling = Verdict::DoesNotCompile {
        errors: vec![CompileError { message: text.into(), line: Some(1), column: None, text: text.into() }],
        left_out: 0,
    };
    let mut with_notes = graded([5, 0, 0], PartState::Wrong, Picture::default());
    if let Verdict::Graded { parts, whole, .. } = &mut with_notes {
        for check in parts.iter_mut().flat_map(|part| &mut part.checks) {
            check.note = text.into();
            check.private_note = text.into();
        }
        whole.as_mut().unwrap().note = text.into();
    }
    let verdicts = [
        not_compiling,
        with_notes,
        Verdict::Rejected { code: "no-file".into(), why: text.into() },
        Verdict::HarnessError { what: text.into() },
        Verdict::TooExpensiveToCompile { limit: text.into(), text: text.into() },
    ];
    let one = |(index, verdict): (usize, Verdict)| Record {
        file: text.into(),
        remarks: vec![text.into()],
        sandbox: text.into(),
        ..record(&format!("{id}-{index}"), Some(&format!("{text}{index}")), text, verdict)
    };
    verdicts.into_iter().enumerate().map(one).collect()
}

/// Texts with much that means something to somebody.
fn hostile() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        Just(NASTY.to_owned()),
        Just(FORMULA.to_owned()),
        prop::sample::select(vec![
            "=",
            "+",
            "-",
            "@",
            "\t",
            "\r",
            "\n",
            "'",
            "\"",
            "<",
            ">",
            "&",
            "]]>",
            "<!--",
            "-->",
            "</td>",
            "</title>",
            "`",
            "```",
            "|",
            "\\",
            "*",
            "_",
            "\u{0}",
            "\u{1b}[31m",
            "\u{202e}",
            "\u{2028}",
            "\u{fffe}",
            "＝",
            ",",
            ";",
            " ",
            "javascript:",
            "&lt;script&gt;",
            "</style>",
            "</pre>",
        ])
        .prop_map(str::to_owned),
        any::<String>(),
    ];
    prop::collection::vec(piece, 1..6).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn no_cell_is_a_formula(text in hostile()) {
        let outputs = outputs(&everywhere(&text, "some"), &Options::default());
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(file(&outputs, "grades.csv").as_bytes());
        let mut rows = 0;
        for row in reader.records() {
            let row = row.unwrap();
            for cell in &row {
                prop_assert!(!cell.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']), "{cell:?}");
                prop_assert!(!cell.trim_start().starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']), "{cell:?}");
                prop_assert!(!cell.contains(|c: char| c.is_control()), "{cell:?}");
            }
            rows += 1;
        }
        prop_assert_eq!(rows, 6);
    }

    #[test]
    fn no_text_is_markup(text in hostile()) {
        // What is blank is left out, and its elements with it.
        let hostile = outputs(&everywhere(&format!("x{text}"), "some"), &Options::default());
        let harmless = outputs(&everywhere("x", "some"), &Options::default());
        for (name, page) in hostile.iter().filter(|(name, _)| name.ends_with(".html")) {
            // Text adds no element, so that there are as many as with a text of one letter.
            prop_assert_eq!(elements(page), elements(file(&harmless, name)), "{}", name);
            let foreign = page.contains(['\u{0}', '\u{1b}', '\u{202e}', '\u{2028}']);
            prop_assert!(!foreign, "{name}: a character acts");
        }
        let mut xml = quick_xml::Reader::from_str(file(&hostile, "junit.xml"));
        let mut depth = 0;
        loop {
            match xml.read_event() {
                Ok(quick_xml::events::Event::Start(_)) => depth += 1,
                Ok(quick_xml::events::Event::End(_)) => depth -= 1,
                Ok(quick_xml::events::Event::Eof) => break,
                Ok(_) => {}
                Err(error) => return Err(TestCaseError::fail(error.to_string())),
            }
        }
        prop_assert_eq!(depth, 0);
        let allowed = |c: char| matches!(c, '\t' | '\n' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
        prop_assert!(file(&hostile, "junit.xml").chars().all(allowed));
    }

    #[test]
    fn markdown_shows_text_as_text(text in hostile()) {
        let outputs = outputs(&everywhere(&text, "some"), &Options::default());
        for (name, page) in outputs.iter().filter(|(name, _)| name.ends_with(".md")) {
            let html = |event: &pulldown_cmark::Event<'_>| match event {
                pulldown_cmark::Event::Html(html) | pulldown_cmark::Event::InlineHtml(html) => &**html != "<br>",
                pulldown_cmark::Event::Start(tag) => {
                    matches!(tag, pulldown_cmark::Tag::Link { .. } | pulldown_cmark::Tag::Image { .. })
                }
                _ => false,
            };
            let options = pulldown_cmark::Options::ENABLE_TABLES | pulldown_cmark::Options::ENABLE_STRIKETHROUGH;
            let found = pulldown_cmark::Parser::new_ext(page, options).find(html);
            prop_assert!(found.is_none(), "{name}: {found:?} in {page}");
        }
    }

    #[test]
    fn an_anonymous_run_names_nobody(
        names in prop::collection::vec(("[A-Z][a-z]{5,9}", "[A-ZÀ-Þ][a-z]{5,9}", 100_000_000..999_999_999_u32), 1..6),
        notes in prop::collection::vec(hostile(), 6),
    ) {
        let mut records = Vec::new();
        for (index, (first, last, number)) in names.iter().enumerate() {
            let (next_first, next_last, next_number) = &names[(index + 1) % names.len()];
            let text = format!(
                "{} panicked at {first}.rs by {} {last}, {number}; like {next_first} {next_last} ({next_number}), \
                 {number}_{first}{last}.zip, {number}_{}-x{index}",
                notes[index % notes.len()], first.to_uppercase(), first.to_uppercase(),
            );
            for (suffix, record) in everywhere(&text, &format!("{number}_{first}-x{index}")).into_iter().enumerate() {
                records.push(Record {
                    file: format!("{number}_{first}{last}.zip"),
                    sandbox: format!("slot of {number}_{first}{last}.zip"),
                    student: Student { number: Some(number.to_string()), name: format!("{first} {last}") },
                    lms: Lms::Canvas { user_id: format!("{}", 4_000_000_000_u64 + u64::from(*number) + suffix as u64) },
                    ..record
                });
            }
        }
        let outputs = outputs(&records, &Options { anonymous: true, ..Options::default() });
        let secrets = records.iter().flat_map(|record| {
            let Lms::Canvas { user_id } = &record.lms else { unreachable!() };
            let (first, last) = record.student.name.split_once(' ').unwrap();
            [&record.id, &record.file, record.student.number.as_ref().unwrap(), &record.student.name, user_id]
                .map(|text| text.to_lowercase())
                .into_iter()
                .chain([format!("{first}.rs").to_lowercase(), format!("{first}{last}").to_lowercase()])
        });
        let secrets: Vec<String> = secrets.collect();
        let mut key = 0;
        for (name, text) in &outputs {
            let (name, text) = (name.to_lowercase(), text.to_lowercase());
            for secret in &secrets {
                prop_assert!(!name.contains(secret), "{name} has {secret} in its name");
                prop_assert!(name == "key.csv" || !text.contains(secret), "{name} holds {secret}");
                key += usize::from(name == "key.csv" && text.contains(secret));
            }
        }
        // The key tells everything else.
        prop_assert!(key > 0);
    }

    #[test]
    fn points_off_are_exact(points in 0..100_000_u32, per_day in 0..=10_000_u64, cap in 0..=10_000_u64, days in 0..400_u32) {
        let decimal = |hundredths: u64| format!("{}.{:02}", hundredths / 100, hundredths % 100);
        let policy = results::LatePolicy {
            percent_per_day: decimal(per_day).parse().unwrap(),
            cap: decimal(cap).parse().unwrap(),
        };
        // In whole numbers: hundredths of points times hundredths of percents.
        let off = (per_day * u64::from(days)).min(cap);
        let exact = u128::from(points) * 100 * u128::from(10_000 - off);
        let rounded = (exact + 5_000) / 10_000;
        let left = Points::whole(points).less(policy.deduction(days));
        let expected: Points = decimal(u64::try_from(rounded).unwrap()).parse().unwrap();
        prop_assert_eq!(left, expected);
        prop_assert!(left <= Points::whole(points));
        let more = Points::whole(points).less(policy.deduction(days + 1));
        prop_assert!(more <= left, "a later day gives more");
    }

    #[test]
    fn points_are_shown_as_they_are_read(hundredths in 0..1_000_000_000_u64) {
        let text = format!("{}.{:02}", hundredths / 100, hundredths % 100);
        let points: Points = text.parse().unwrap();
        let shown = points.to_string();
        prop_assert_eq!(shown.parse::<Points>().unwrap(), points);
        prop_assert!(shown.len() <= text.len());
        let json = serde_json::to_string(&points).unwrap();
        prop_assert_eq!(json.parse::<Points>().unwrap(), points, "{}", json);
    }

    #[test]
    fn a_pose_of_any_numbers_is_drawn_within_the_picture(
        points in prop::collection::vec(prop::array::uniform3(prop::num::f32::ANY), 18),
    ) {
        let picture = Picture { points, ..common::figure(|point| point) };
        let mut verdict = graded([5, 5, 5], PartState::Right, picture.clone());
        if let Verdict::Graded { picture: found, .. } = &mut verdict {
            *found = Some(picture.clone());
        }
        let outputs = outputs(&[record("one", None, "One", verdict)], &Options::default());
        let page = file(&outputs, "report.html");
        for path in page.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            for number in path.split(['M', 'L', ' ']).filter(|text| !text.is_empty()) {
                let number: f64 = number.parse().unwrap();
                prop_assert!(number.abs() < 10_000.0, "{path}");
            }
        }
        // And it comes back from the file as it was, but for what is no number.
        let json: serde_json::Value = serde_json::from_str(file(&outputs, "results.json")).unwrap();
        let back: Record = serde_json::from_value(json["records"][0].clone()).unwrap();
        let Verdict::Graded { picture: Some(back), .. } = back.verdict else { panic!() };
        for (one, other) in back.points.iter().flatten().zip(picture.points.iter().flatten()) {
            prop_assert!(one.to_bits() == other.to_bits() || (one.is_nan() && !other.is_finite()), "{one} {other}");
        }
    }
}

/// How many tags there are, outside scripts and styles. The details of a student are markup inside a script of text.
fn elements(page: &str) -> usize {
    page.matches('<').count()
}

#[test]
fn percents_beyond_all_are_refused() {
    for bad in ["101", "100.01", "-1", "1.234", "", "x", "1e2", "∞"] {
        assert!(bad.parse::<Percent>().is_err(), "{bad}");
    }
    assert_eq!("12.5 %".parse::<Percent>().unwrap().to_string(), "12.50");
}

#[test]
fn changes_are_plain_data() {
    let change = Change { what: "total".into(), from: None, to: Some(Points::whole(3)), reason: "r".into() };
    assert_eq!(
        serde_json::to_string(&change).unwrap(),
        r#"{"what":"total","from":null,"to":3,"reason":"r"}"#
    );
    let anonymous = Gradebook { path: "x.csv".into(), column: None };
    let options = Options { anonymous: true, canvas: Some(anonymous), ..Options::default() };
    let folder = tempfile::tempdir().unwrap();
    assert!(write(folder.path(), &run(), &[], &options).unwrap_err().to_string().contains("anonymously"));
}
