//! Tables of learning platforms: only the one column changes, and nobody is added.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use std::fs;

use common::{figure, graded, record, run, write};
use results::{Error, Gradebook, Lms, Options, PartState, Record, Summary, Verdict};

fn student(id: &str, number: Option<&str>, name: &str, points: u32, lms: Lms) -> Record {
    Record { lms, ..record(id, number, name, graded([points, 5, 5], PartState::Wrong, figure(|p| p))) }
}

enum Platform {
    Canvas,
    Moodle,
}

fn fill(
    platform: Platform,
    text: &str,
    column: Option<&str>,
    records: &[Record],
) -> Result<(String, Summary), Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("export.csv");
    fs::write(&path, text).unwrap();
    let gradebook = Some(Gradebook { path, column: column.map(str::to_owned) });
    let (options, name) = match platform {
        Platform::Canvas => (Options { canvas: gradebook, ..Options::default() }, "canvas.csv"),
        Platform::Moodle => (Options { moodle: gradebook, ..Options::default() }, "moodle.csv"),
    };
    let summary = write(folder.path(), &run(), records, &options)?;
    Ok((fs::read_to_string(folder.path().join(name)).unwrap(), summary))
}

fn canvas_id(id: &str) -> Lms {
    Lms::Canvas { user_id: id.into() }
}

fn moodle_id(id: &str) -> Lms {
    Lms::Moodle { participant_id: id.into() }
}

const HEADER: &str = "Student,ID,SIS User ID,SIS Login ID,Section,Warm-up (7),Forward kinematics (8)\n";

#[test]
fn canvas_is_matched_by_id_then_number_then_login_then_name() {
    let records = [
        student("a", Some("300"), "Wrong Name", 5, canvas_id("11")),
        student("b", Some("301"), "", 4, Lms::None),
        student("c", Some("login3"), "", 3, Lms::None),
        student("d", None, "terry fox", 2, Lms::None),
        student("e", None, "Two Alike", 1, Lms::None),
    ];
    let text = format!(
        "{HEADER}    Points Possible,,,,,3,15\n\"Z, Z\",11,301,,S,1,\n\"Y, Y\",12,301,,S,1,\n\"X, X\",13,,login3,S,1,\n\
         \"Fox, Terry\",14,,,S,1,\n\"Alike, Two\",15,,,S,1,\n\"Alike, Two\",16,,,S,1,9\n"
    );
    let (out, summary) = fill(Platform::Canvas, &text, None, &records).unwrap();
    let expected = format!(
        "{HEADER}    Points Possible,,,,,3,15\n\"Z, Z\",11,301,,S,1,15\n\"Y, Y\",12,301,,S,1,14\n\"X, X\",13,,login3,S,1,13\n\
         \"Fox, Terry\",14,,,S,1,12\n\"Alike, Two\",15,,,S,1,\n\"Alike, Two\",16,,,S,1,9\n"
    );
    assert_eq!(out, expected);
    assert!(summary.attention.contains(&"1 mark without a row in canvas.csv: e".to_owned()), "{summary:?}");
}

#[test]
fn canvas_keeps_what_is_no_mark_of_this_run() {
    let records = [
        student("a", Some("300"), "A", 5, Lms::None),
        record("b", Some("301"), "B", Verdict::HarnessError { what: "x".into() }),
        student("c", Some("302"), "C", 5, Lms::None),
        student("d", Some("302"), "C", 4, Lms::None),
    ];
    let text = format!(
        "{HEADER}    Punkte,,,,,3,20\n\"A\",1,300,,S,1,EX\nB,2,301,,S,1,3\nC,3,302,,S,1,\nT,4,,,S,1,2\n"
    );
    let error = fill(Platform::Canvas, &text, Some("No such"), &records).unwrap_err().to_string();
    assert!(error.contains("no column `No such`") && error.contains("`Warm-up (7)`"), "{error}");
    let (out, summary) = fill(Platform::Canvas, &text, Some("Forward kinematics"), &records).unwrap();
    assert_eq!(out, text.replace("\"A\"", "A"));
    let said = summary.attention.join("\n");
    assert!(said.contains("worth 20 there, and 15 here") && said.contains("excused"), "{said}");
    assert!(said.contains("2 submissions of students with several that differ"), "{said}");
}

#[test]
fn what_is_no_gradebook_of_canvas_is_refused() {
    let records = [student("a", Some("300"), "A", 5, Lms::None)];
    for text in ["name,points\nA,3\n", "{\"json\": true}\n", "Student,ID,Section,Other (1)\nA,1,S,2\n"] {
        assert!(fill(Platform::Canvas, text, None, &records).is_err(), "{text}");
    }
    let strangers = format!("{HEADER}Q,77,999,q,S,1,\n");
    let error = fill(Platform::Canvas, &strangers, None, &records).unwrap_err().to_string();
    assert!(error.contains("none of the students"), "{error}");
}

#[test]
fn moodle_is_read_in_any_language() {
    let records = [
        student("a", None, "Somebody", 5, moodle_id("12")),
        student("b", Some("301"), "", 4, Lms::None),
        student("c", None, "terry fox", 3, Lms::None),
    ];
    for (header, participant) in [
        ("Identifier,Full name,Email address,ID number,Status,Grade,Maximum grade", "Participant"),
        ("ID,Vollständiger Name,E-Mail-Adresse,ID-Nummer,Status,Bewertung,Bestwertung", "Teilnehmer/in"),
        ("Identifiant,Nom complet,Adresse de courriel,Numéro,Statut,Note,Note maximale", "Participant"),
    ] {
        let row = |number, name: &str, id, points| {
            format!("{participant} {number},{name},x@example.org,{id},,{points},15\r\n")
        };
        let table = |one, two, three| {
            format!(
                "\u{feff}{header}\r\n{}{}{}{}",
                row(12, "Unknown One", "", one),
                row(13, "Some Other", "301", two),
                row(14, "Terry Fox", "", three),
                row(15, "Not Here", "999", "7"),
            )
        };
        let (out, _) = fill(Platform::Moodle, &table("", "", ""), None, &records).unwrap();
        assert_eq!(out, table("15", "14", "13"));
    }
}

#[test]
fn moodles_gradebook_has_first_and_last_names_apart() {
    let records =
        [student("a", None, "Terry Fox", 5, Lms::None), student("b", None, "Ada Okafor", 0, Lms::None)];
    let text = "Vorname;Nachname;Aufgabe: Forward kinematics (Punkte)\nTerry;Fox;-\nNot;Here;-\n";
    let (out, summary) = fill(Platform::Moodle, text, None, &records).unwrap();
    assert_eq!(out, "Vorname;Nachname;Aufgabe: Forward kinematics (Punkte)\nTerry;Fox;15\nNot;Here;-\n");
    assert!(summary.attention.contains(&"1 mark without a row in moodle.csv: b".to_owned()), "{summary:?}");
    let error = fill(Platform::Moodle, "A;B;C\nTerry;Fox;-\n", None, &records).unwrap_err().to_string();
    assert!(error.contains("--moodle-column"), "{error}");
}
