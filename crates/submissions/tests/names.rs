//! What names tell, and the ids that are made from them.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::collections::HashSet;

use proptest::prelude::*;
use submissions::{Batch, Entry, Lms, printable, read_one};
use support::{Member, wanted, write, zip};

/// What a file with this name tells. It need not exist.
fn told(name: &str) -> Entry {
    read_one(&std::path::Path::new("/nowhere").join(name), &wanted()).0
}

fn student(name: &str) -> (Option<String>, String) {
    let entry = told(name);
    (entry.student.number, entry.student.name)
}

fn entries(names: &[&str]) -> Vec<Entry> {
    let members: Vec<Member> = names.iter().map(|name| Member::stored(name, "x")).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("all.zip");
    write(&path, zip(&members));
    Batch::open(&path, &wanted()).unwrap().entries().to_vec()
}

#[test]
fn the_own_scheme() {
    let terry = (Some("300000001".to_owned()), "TerryFox".to_owned());
    for name in [
        "300000001_TerryFox.zip",
        "300000001_TerryFox.rs",
        "300000001-TerryFox.zip",
        "300000001 TerryFox.zip",
        "300000001_TerryFox-1.zip",
        "300000001_TerryFox (2).zip",
        "TerryFox_300000001.zip",
        "300000001_TerryFox",
    ] {
        assert_eq!(student(name), terry, "{name}");
        assert_eq!(told(name).lms, Lms::None);
    }
    assert_eq!(student("300000001_Terry_Stanley_Fox.zip").1, "Terry Stanley Fox");
    assert_eq!(student("300000001.zip"), (Some("300000001".into()), String::new()));
    assert_eq!(student("300000001_王小明.zip").1, "王小明");
    assert_eq!(student("300000001_O'Brien, José \"Pepe\".zip").1, "O'Brien, José \"Pepe\"");
}

#[test]
fn without_a_number_the_name_is_the_student() {
    for (name, expected) in [
        ("TerryFox.zip", "TerryFox"),
        ("fk.rs", "fk"),
        ("2024_fk.rs", "2024 fk"),
        ("v1.2", "v1"),
        ("submission_123456789", "submission 123456789"),
    ] {
        assert_eq!(student(name), (None, expected.to_owned()), "{name}");
    }
    assert_eq!(student("1234567890123_TooLong.zip").0, None);
}

#[test]
fn canvas() {
    let user = |name: &str| match told(name).lms {
        Lms::Canvas { user_id } => user_id,
        other => panic!("{name}: {other:?}"),
    };
    for name in
        ["foxterry_1234_56789_300000001_TerryFox.zip", "foxterry_LATE_1234_56789_300000001_TerryFox-1.zip"]
    {
        assert_eq!(user(name), "1234");
        assert_eq!(student(name), (Some("300000001".into()), "TerryFox".into()));
        assert_eq!(told(name).marked_late, name.contains("LATE"));
    }
    assert_eq!(student("foxterry_1234_56789_fk.rs"), (None, "foxterry".into()));
    assert_eq!(user("fox_terry_1234_56789_my_own_3_4_fk.rs"), "1234");
    let hidden = told("anon_Ab3dE_56789_300000001_TerryFox.zip");
    assert_eq!(hidden.lms, Lms::CanvasAnonymous { id: "Ab3dE".into() });
    assert_eq!(told("anon_LATE_Ab3dE_56789_fk.rs").student.name, "anonymous Ab3dE");
    assert!(told("anon_Ab3dE_LATE_56789_fk.rs").marked_late);
}

#[test]
fn moodle() {
    for name in [
        "Terry Fox_1234_assignsubmission_file",
        "Terry Fox_1234_assignsubmission_file_",
        "Terry Fox_1234_assignsubmission_file_fk.rs",
    ] {
        assert_eq!(told(name).lms, Lms::Moodle { participant: "1234".into() });
        assert_eq!(student(name), (None, "Terry Fox".into()));
    }
    assert_eq!(student("Terry Fox_1234_assignsubmission_file_300000001_T.zip").0.unwrap(), "300000001");
    assert_eq!(told("Participant_99_assignsubmission_file").student.name, "Participant");
}

#[test]
fn hostile_names_are_data() {
    for (name, shown) in [
        ("300000001_=cmd()|'x'!A1.zip", "=cmd()|'x'!A1"),
        ("300000001_<script>alert(1)<.zip", "<script>alert(1)<"),
        ("300000001_a,b;\"c\".zip", "a,b;\"c\""),
        ("300000001_\u{1b}[31mred.zip", "�[31mred"),
        ("300000001_a\nb\rc\td.zip", "a�b�c�d"),
        ("300000001_\u{202e}txt.zip", "�txt"),
    ] {
        let entry = told(name);
        assert_eq!(entry.student.name, shown);
        assert_eq!(entry.student.number.as_deref(), Some("300000001"));
    }
    let long = told(&format!("300000001_{}.zip", "é".repeat(30_000)));
    assert!(
        long.student.name.chars().count() <= 161 && long.file.chars().count() <= 161 && long.id.len() <= 80
    );
}

#[test]
fn ids_are_the_names_where_these_are_safe() {
    for (name, id) in [
        ("300000001_TerryFox.zip", "300000001_TerryFox"),
        ("Terry Fox_12_assignsubmission_file", "Terry_Fox_12_assignsubmission_file"),
        ("T.Fox-1.rs", "T.Fox-1"),
    ] {
        assert_eq!(told(name).id, id);
    }
}

#[test]
fn ids_of_other_names_end_in_a_hash_that_stays() {
    for (name, start) in [
        ("300000001_王小明.zip", "300000001-"),
        ("300000001_José.zip", "300000001_Jos-"),
        ("CON.zip", "CON-"),
        ("lpt1.a.zip", "lpt1_a-"),
        ("王.zip", "submission-"),
        ("...rs", "submission-"),
        ("-rf.rs", "rf-"),
    ] {
        let id = told(name).id;
        assert!(id.starts_with(start) && id.len() == start.len() + 8, "{name}: {id}");
        assert_eq!(told(name).id, id);
    }
    assert_eq!(told("300000001_José.zip").id, "300000001_Jos-0d5230a8");
}

#[test]
fn an_id_does_not_depend_on_who_else_hands_in() {
    let alone = told("300000002_José.zip").id;
    let among = entries(&["300000001_A.zip", "300000002_José.zip", "300000002_Josè.zip"]);
    assert!(among.iter().any(|entry| entry.id == alone), "{among:?}");
}

#[test]
fn names_that_give_one_id_get_a_hash_each() {
    for names in [["A.zip", "A.rs"], ["A.zip", "a.zip"]] {
        let ids: Vec<String> = entries(&names).into_iter().map(|entry| entry.id).collect();
        assert!(ids.iter().all(|id| id.len() == "A-12345678".len()), "{ids:?}");
        let other_way = entries(&[names[1], names[0]]).into_iter().map(|entry| entry.id);
        assert_eq!(ids, other_way.collect::<Vec<_>>());
    }
}

#[test]
fn the_order_is_that_of_the_ids() {
    let ids: Vec<String> =
        entries(&["b.rs", "a.rs", "C.rs", "10.rs", "9.rs"]).into_iter().map(|e| e.id).collect();
    assert_eq!(ids, ["10", "9", "C", "a", "b"]);
}

#[test]
fn very_many_equal_names_take_no_time() {
    let members = vec![Member::stored("a.rs", "x"); 30_000];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("all.zip");
    write(&path, zip(&members));
    assert_eq!(Batch::open(&path, &wanted()).unwrap().entries().len(), 30_000);
}

fn is_safe(id: &str) -> bool {
    let first = id.split('.').next().unwrap().to_ascii_uppercase();
    let reserved = ["CON", "PRN", "AUX", "NUL", "COM1", "COM9", "LPT1", "LPT9"];
    (1..=80).contains(&id.len())
        && id.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_-.".contains(&byte))
        && !id.starts_with(['.', '-'])
        && !id.ends_with('.')
        && !reserved.contains(&first.as_str())
}

proptest! {
    #[test]
    fn ids_are_safe_and_unlike_each_other(names in prop::collection::vec("(con|AUX|com[0-9]|[aA]|[é.\\-_ ]|\\PC){1,3}(\\.(rs|zip|x))?", 1..30)) {
        let names: Vec<&str> = names.iter().map(String::as_str).filter(|name| !name.contains(['/', '\\'])).collect();
        let entries = entries(&names);
        let ids: HashSet<String> = entries.iter().map(|entry| entry.id.to_ascii_lowercase()).collect();
        prop_assert_eq!(ids.len(), entries.len());
        for entry in &entries {
            prop_assert!(is_safe(&entry.id), "{:?}", entry.id);
        }
    }

    #[test]
    fn any_name_is_fit_to_be_shown(name in any::<String>()) {
        let name = name.replace(['/', '\0'], "");
        let entry = told(&name);
        prop_assert!(is_safe(&entry.id));
        for text in [&entry.file, &entry.student.name] {
            prop_assert_eq!(&printable(text).replace('…', ""), &text.replace('…', ""));
        }
    }
}
