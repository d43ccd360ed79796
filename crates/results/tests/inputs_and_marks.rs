//! What the teaching assistant hands in beside the submissions, and what it does to the marks.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use std::fs;
use std::path::PathBuf;

use common::{figure, graded, record, run, write};
use results::{
    Error, LateList, LatePolicy, Lms, Options, Overrides, PartState, Record, Roster, Shard, Student, Verdict,
};
use serde_json::Value;
use tempfile::TempDir;

struct Desk(TempDir);

impl Desk {
    fn new() -> Desk {
        Desk(tempfile::tempdir().unwrap())
    }

    fn file(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    fn roster(&self, text: &str) -> Result<Roster, Error> {
        Roster::read(&self.file("roster.csv", text))
    }

    fn late(&self, text: &str, per_day: &str, cap: &str) -> Result<LateList, Error> {
        let policy = LatePolicy { percent_per_day: per_day.parse().unwrap(), cap: cap.parse().unwrap() };
        LateList::read(&self.file("late.csv", text), policy)
    }

    fn overrides(&self, text: &str) -> Result<Overrides, Error> {
        Overrides::read(&self.file("overrides.csv", text), &run())
    }

    /// The records of `results.json`.
    fn marks(&self, records: &[Record], options: &Options) -> Result<Vec<Value>, Error> {
        let out = self.0.path().join("out");
        write(&out, &run(), records, options)?;
        let json: Value =
            serde_json::from_str(&fs::read_to_string(out.join("results.json")).unwrap()).unwrap();
        Ok(json["records"].as_array().unwrap().clone())
    }
}

fn right(id: &str, number: &str) -> Record {
    record(id, Some(number), "Terry Fox", graded([5, 5, 5], PartState::Right, figure(|p| p)))
}

fn half(id: &str, number: &str) -> Record {
    record(id, Some(number), "Terry Fox", graded([5, 0, 0], PartState::Wrong, figure(|p| p)))
}

fn points(marks: &[Value]) -> Vec<Value> {
    marks.iter().map(|record| record["mark"]["points"].clone()).collect()
}

#[test]
fn rosters_are_read_as_people_write_them() {
    let desk = Desk::new();
    let student = |number: &str, name: &str| Student { number: Some(number.into()), name: name.into() };
    let expected = [student("300", "Terry Fox"), student("301", "Müller, Jürgen")];
    for text in [
        "number,name\n300,Terry Fox\n301,\"Müller, Jürgen\"\n",
        "300,Terry Fox,terry@example.org\n301,\"Müller, Jürgen\",j@example.org\n",
        "\u{feff}Name;E-Mail;Matrikelnummer\r\nTerry Fox;x;300\r\nMüller, Jürgen;y; 301 \r\n;;\r\n",
        "Student ID\tStudent name\n300\tTerry Fox\n301\tMüller, Jürgen",
    ] {
        assert_eq!(desk.roster(text).unwrap().students(), expected, "{text}");
    }
    let two = desk.roster("First name,Last name,ID number\nTerry,Fox,300\n").unwrap();
    assert_eq!(two.students(), [student("300", "Terry Fox")]);
}

#[test]
fn a_bad_table_is_an_error_with_its_line() {
    let desk = Desk::new();
    let line = |error: Error| match error {
        Error::Input { line, what, .. } => (line, what),
        other => panic!("{other}"),
    };
    let roster = |text| line(desk.roster(text).unwrap_err());
    assert_eq!(roster("").0, None);
    assert_eq!(roster("number,name\n1,A\n2,B\n1,C\n").0, Some(4));
    assert_eq!(roster("Terry Fox,300\n").0, Some(1));
    assert_eq!(roster("number,email\n1,x@example.org\n").0, Some(1));
    let latin = desk.0.path().join("latin.csv");
    fs::write(&latin, b"number,name\n1,Zo\xeb\n").unwrap();
    assert_eq!(line(Roster::read(&latin).unwrap_err()).0, Some(2));

    let late = |text| line(desk.late(text, "10", "50").unwrap_err());
    assert_eq!(late("number,days\n1,two\n").0, Some(2));
    assert_eq!(late("number,days\n1,2\n\n1,3\n").0, Some(4));
    assert_eq!(late("number,days\n1,-1\n").0, Some(2));

    let overrides =
        |text: &str| line(desk.overrides(&format!("student,what,points,reason\n{text}\n")).unwrap_err());
    for (row, said) in [
        ("1,part9,1,r", "no `part9`"),
        ("1,total,16,r", "more than the 15"),
        ("1,part1,5.01,r", "more than the 5"),
        ("1,part1/cursor,2,r", "more than the 1"),
        ("1,root,1,r", "several parts"),
        ("1,total,many,r", "expected a number"),
        ("1,total,-3,r", "expected a number"),
        ("1,total,3,", "expected a reason"),
        (",total,3,r", "expected a student"),
        ("1,counts,3,r", "takes no points"),
        ("1,total,3,r\n1,total,4,r", "line 2"),
    ] {
        let (found, what) = overrides(row);
        assert!(what.contains(said), "{row}: {what}");
        assert_eq!(found, Some(1 + row.lines().count() as u64), "{row}");
    }
}

#[test]
fn what_is_changed_by_hand_is_changed_before_days_late_and_the_total_after() {
    let desk = Desk::new();
    let list = "student,what,points,reason\n1,rotation_orders,0,copied\n1,part3,2.5,half\n2,total,14,oral\n";
    let options = Options {
        overrides: Some(desk.overrides(list).unwrap()),
        late: Some(desk.late("number,days\n1,2\n2,2\n3,9\n", "10", "50").unwrap()),
        ..Options::default()
    };
    let marks = desk.marks(&[right("a", "1"), right("b", "2"), right("c", "3")], &options).unwrap();
    // (15 - 2 - 2.5) less 20 %; as decided; 15 less the cap.
    assert_eq!(points(&marks), [Value::from(8.4), 14.into(), 7.5.into()]);
    assert_eq!(marks[0]["mark"]["checked"], 15);
    assert_eq!(marks[0]["mark"]["parts"], serde_json::json!([3, 5, 2.5]));
    assert_eq!(marks[0]["mark"]["late"], serde_json::json!({"days": 2, "percent": 20, "from": 10.5}));
    assert_eq!(marks[1]["mark"]["late"], Value::Null);
    let text = fs::read_to_string(desk.0.path().join("out/feedback/a.md")).unwrap();
    for words in ["8.40 of 15", "from 2 to 0: copied", "from 5 to 2.50: half", "2 days late: 20 % of 10.50"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let text = fs::read_to_string(desk.0.path().join("out/feedback/b.md")).unwrap();
    assert!(text.contains("from 15 to 14: oral") && !text.contains("days late"), "{text}");
}

#[test]
fn nobody_gets_points_by_an_override_of_a_stranger() {
    let desk = Desk::new();
    let list = desk.overrides("student,what,points,reason\n1,part1,1,r\n\n77,total,3,who?\n").unwrap();
    let options = Options { overrides: Some(list), ..Options::default() };
    let error = desk.marks(&[right("a", "1")], &options).unwrap_err().to_string();
    assert!(error.contains("overrides.csv, line 4: `77`"), "{error}");
    // One share of the submissions does not know the others' students.
    let share = results::RunInfo { shard: Some(Shard { index: 0, count: 2 }), ..run() };
    write(&desk.0.path().join("share"), &share, &[right("a", "1")], &options).unwrap();
}

#[test]
fn trouble_of_the_harness_is_no_points_until_somebody_decides() {
    let desk = Desk::new();
    let broken =
        |id: &str, number: &str| record(id, Some(number), "", Verdict::HarnessError { what: "full".into() });
    let records = [broken("a", "1"), broken("b", "2")];
    let list = desk.overrides("student,what,points,reason\n2,total,9,marked by hand\n").unwrap();
    let options = Options { overrides: Some(list), ..Options::default() };
    let marks = desk.marks(&records, &options).unwrap();
    assert_eq!(points(&marks), [Value::Null, 9.into()]);
    assert_eq!((&marks[0]["mark"]["counts"], &marks[1]["mark"]["counts"]), (&false.into(), &true.into()));
    let list = desk.overrides("student,what,points,reason\n1,cursor,1,r\n").unwrap();
    let options = Options { overrides: Some(list), ..Options::default() };
    let error = desk.marks(&records, &options).unwrap_err().to_string();
    assert!(error.contains("line 2") && error.contains("override the part or the total"), "{error}");
    let text = fs::read_to_string(desk.0.path().join("out/feedback/a.md")).unwrap();
    assert!(
        text.contains("no points yet") && text.contains("not your fault") && !text.contains("full"),
        "{text}"
    );
}

#[test]
fn of_two_submissions_none_counts_until_somebody_decides() {
    let desk = Desk::new();
    let counts = |options: &Options, records: &[Record]| -> Vec<bool> {
        let marks = desk.marks(records, options).unwrap();
        marks.iter().map(|record| record["mark"]["counts"].as_bool().unwrap()).collect()
    };
    let decide = |text: &str| {
        let text = format!("student,what,points,reason\n{text}\n");
        Options { overrides: Some(desk.overrides(&text).unwrap()), ..Options::default() }
    };
    let differ = [right("a", "1"), half("b", "1"), right("c", "2")];
    assert_eq!(counts(&Options::default(), &differ), [false, false, true]);
    assert_eq!(counts(&Options::default(), &[right("a", "1"), right("b", "1")]), [true, false]);
    assert_eq!(counts(&decide("b,counts,,the later one"), &differ), [false, true, true]);
    // A total for the student makes them agree.
    assert_eq!(counts(&decide("1,total,7,spoke with her"), &differ), [true, false, true]);
    let both = decide("1,counts,,r");
    assert!(desk.marks(&differ, &both).unwrap_err().to_string().contains("line 2"));
    // Without numbers the platform's id or the name tells.
    let nameless = |id: &str, user: &str| Record {
        student: Student { number: None, name: "fox, TERRY".into() },
        lms: Lms::Canvas { user_id: user.into() },
        ..half(id, "")
    };
    assert_eq!(counts(&Options::default(), &[nameless("a", "1"), nameless("b", "2")]), [true, true]);
}

#[test]
fn a_roster_gives_numbers_and_finds_who_is_missing() {
    let desk = Desk::new();
    let roster = desk.roster("number,name\n1,Terry Fox\n2,Ada Twin\n3,Ada Twin\n4,Never Came\n").unwrap();
    let unnumbered = |id: &str, name: &str| Record {
        student: Student { number: None, name: name.into() },
        ..right(id, "")
    };
    let options = Options { roster: Some(roster), ..Options::default() };
    let records = [unnumbered("a", "FOX, terry"), unnumbered("b", "Ada Twin"), right("c", "99")];
    let marks = desk.marks(&records, &options).unwrap();
    assert_eq!(marks[0]["student"], serde_json::json!({"number": "1", "name": "Terry Fox"}));
    assert_eq!(marks[0]["mark"]["flags"], serde_json::json!([]));
    // Two have the name, and one nobody knows.
    for index in [1, 2] {
        assert_eq!(marks[index]["mark"]["flags"][0]["flag"], "not-on-roster", "{}", marks[index]);
    }
    let missing: Vec<_> =
        marks[3..].iter().map(|record| (&record["student"]["number"], &record["mark"]["points"])).collect();
    assert_eq!(
        missing,
        [(&"2".into(), &Value::Null), (&"3".into(), &Value::Null), (&"4".into(), &Value::Null)]
    );
    // Who handed in nothing gets no feedback, and one share of the submissions does not tell who that is.
    assert_eq!(fs::read_dir(desk.0.path().join("out/feedback")).unwrap().count(), 6);
    let share = results::RunInfo { shard: Some(Shard { index: 0, count: 2 }), ..run() };
    let summary = write(&desk.0.path().join("share"), &share, &records, &options).unwrap();
    assert_eq!((summary.submissions, summary.missing), (3, 0));
}

#[test]
fn names_and_pseudonyms_do_not_share_a_folder() {
    let desk = Desk::new();
    let anonymous = Options { anonymous: true, ..Options::default() };
    desk.marks(&[right("a", "1")], &Options::default()).unwrap();
    let error = desk.marks(&[right("a", "1")], &anonymous).unwrap_err().to_string();
    assert!(error.contains("results with names"), "{error}");
    let other = Desk::new();
    other.marks(&[right("a", "1")], &anonymous).unwrap();
    other.marks(&[right("a", "1")], &anonymous).unwrap();
    assert!(other.marks(&[right("a", "1")], &Options::default()).is_err());
}

#[test]
fn records_that_cannot_be_told_apart_or_named_are_refused() {
    let desk = Desk::new();
    for ids in [["a", "a"], ["a", "A"], ["a", "../b"], ["a", ".b"], ["a", ""], ["a", "b/c"], ["a", "ü"]] {
        let records = ids.map(|id| right(id, id));
        let error = desk.marks(&records, &Options::default()).unwrap_err();
        assert!(matches!(error, Error::BadRecords(_)), "{ids:?}: {error}");
    }
    assert!(!desk.0.path().join("out").exists());
}

#[test]
fn what_cannot_be_written_is_named() {
    let desk = Desk::new();
    desk.file("out", "a file where the folder should be");
    let error = desk.marks(&[right("a", "1")], &Options::default()).unwrap_err().to_string();
    assert!(error.starts_with("cannot write ") && error.contains("out"), "{error}");
}

#[test]
fn a_name_in_another_students_text_is_a_pseudonym_too() {
    let desk = Desk::new();
    let copied = Verdict::Rejected { code: "copy".into(), why: "// by TERRY FOX (terryfox), not me".into() };
    let records = [right("one", "300000001"), record("two", Some("300000002"), "Ada Okafor", copied)];
    desk.marks(&records, &Options { anonymous: true, ..Options::default() }).unwrap();
    let grades = fs::read_to_string(desk.0.path().join("out/grades.csv")).unwrap();
    assert!(!grades.to_lowercase().contains("fox") && grades.contains("copy: // by Student 00"), "{grades}");
}
