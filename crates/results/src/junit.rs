//! `junit.xml`: a suite per submission, a test case per check. Trouble that is not the student's is an error, never a failure.

use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use crate::book::{Book, Entry};
use crate::error::Filled;
use crate::grades::reason;
use crate::text::{one_line, visible};
use crate::{CheckState, Record, Verdict};

/// One test case: its class, its name, and how it ended.
struct Case {
    class: String,
    name: String,
    outcome: Outcome,
}

enum Outcome {
    Passed,
    Failed { kind: &'static str, message: String, text: String },
    Error { message: String },
    Skipped,
}

pub(crate) fn write(file: &mut dyn Write, book: &Book<'_>) -> Filled {
    let mut total = Counts::default();
    book.each(|_, record| -> Filled {
        total.add(&cases(book, record));
        Ok(())
    })?;
    let mut xml = Writer::new_with_indent(file, b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let suites = xml.create_element("testsuites").with_attribute(("name", &*book.run.exercise));
    let attributes = total.attributes();
    let mut trouble = Ok(());
    suites.with_attributes(attributes.iter().map(|(name, value)| (*name, &**value))).write_inner_content(
        |xml| {
            trouble = book.each(|entry, record| write_suite(xml, entry, &cases(book, record)));
            Ok(())
        },
    )?;
    trouble?;
    Ok(writeln!(xml.into_inner())?)
}

fn write_suite(xml: &mut Writer<&mut dyn Write>, entry: &Entry, cases: &[Case]) -> Filled {
    let mut counts = Counts::default();
    counts.add(cases);
    let attributes = counts.attributes();
    let suite = xml.create_element("testsuite").with_attribute(("name", &*entry.id));
    suite
        .with_attributes(attributes.iter().map(|(name, value)| (*name, &**value)))
        .write_inner_content(|xml| cases.iter().try_for_each(|case| write_case(xml, &entry.id, case)))?;
    Ok(())
}

fn write_case(xml: &mut Writer<&mut dyn Write>, id: &str, case: &Case) -> io::Result<()> {
    let class = format!("{id}.{}", case.class);
    let element = xml.create_element("testcase").with_attributes([
        ("classname", &*class),
        ("name", &*case.name),
        ("time", "0"),
    ]);
    match &case.outcome {
        Outcome::Passed => element.write_empty()?,
        Outcome::Failed { kind, message, text } => element.write_inner_content(|xml| {
            let message = one_line(message);
            let failure =
                xml.create_element("failure").with_attributes([("message", &*message), ("type", kind)]);
            failure.write_text_content(BytesText::new(&visible(text)))?;
            Ok(())
        })?,
        Outcome::Error { message } => element.write_inner_content(|xml| {
            let short = one_line(message);
            let error = xml
                .create_element("error")
                .with_attributes([("message", &*short), ("type", "harness-error")]);
            error.write_text_content(BytesText::new(&visible(message)))?;
            Ok(())
        })?,
        Outcome::Skipped => element.write_inner_content(|xml| {
            xml.create_element("skipped").write_empty()?;
            Ok(())
        })?,
    };
    Ok(())
}

fn cases(book: &Book<'_>, record: &Record) -> Vec<Case> {
    let failed = |kind, text: String| Outcome::Failed { kind, message: reason(record), text };
    let (name, outcome) = match &record.verdict {
        Verdict::Graded { parts, .. } => {
            let checks = parts.iter().flat_map(|part| part.checks.iter().map(move |check| (part, check)));
            let case = |(part, check): (&crate::PartResult, &crate::CheckResult)| Case {
                class: part.id.clone(),
                name: check.id.clone(),
                outcome: match check.state {
                    CheckState::Right if check.points == check.of => Outcome::Passed,
                    CheckState::Stopped => failed_check("stopped", check, "stopped"),
                    CheckState::Wrong => failed_check("wrong", check, "wrong"),
                    CheckState::Right => {
                        failed_check("not-started", check, "right, but the part is not started")
                    }
                },
            };
            return checks.map(case).collect();
        }
        Verdict::DoesNotCompile { errors, .. } => {
            let texts: Vec<&str> = errors.iter().map(|error| error.text.as_str()).collect();
            ("compiles", failed("does-not-compile", texts.join("\n")))
        }
        Verdict::TooExpensiveToCompile { text, .. } => {
            ("compiles", failed("too-expensive-to-compile", text.clone()))
        }
        Verdict::Rejected { why, .. } => ("submission", failed("rejected", why.clone())),
        Verdict::Missing => ("submission", Outcome::Skipped),
        Verdict::HarnessError { what } => ("submission", Outcome::Error { message: what.clone() }),
    };
    vec![Case { class: book.run.exercise.clone(), name: name.to_owned(), outcome }]
}

fn failed_check(kind: &'static str, check: &crate::CheckResult, otherwise: &str) -> Outcome {
    let message = if check.note.is_empty() { otherwise } else { &check.note };
    Outcome::Failed { kind, message: message.to_owned(), text: check.private_note.clone() }
}

#[derive(Default)]
struct Counts {
    tests: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
}

impl Counts {
    fn add(&mut self, cases: &[Case]) {
        self.tests += cases.len();
        for case in cases {
            match case.outcome {
                Outcome::Passed => {}
                Outcome::Failed { .. } => self.failures += 1,
                Outcome::Error { .. } => self.errors += 1,
                Outcome::Skipped => self.skipped += 1,
            }
        }
    }

    fn attributes(&self) -> [(&'static str, String); 5] {
        [
            ("tests", self.tests.to_string()),
            ("failures", self.failures.to_string()),
            ("errors", self.errors.to_string()),
            ("skipped", self.skipped.to_string()),
            ("time", "0".to_owned()),
        ]
    }
}
