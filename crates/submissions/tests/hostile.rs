//! Whatever the bytes, there is a verdict, and it costs little memory.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::sync::Mutex;

use peak_alloc::PeakAlloc;
use proptest::prelude::*;
use submissions::{Batch, Loaded, MAX_ARCHIVE, MAX_SOURCE, read_one, write_zip};
use support::{CODE, Member, code, hand_in, source, wanted, write, zip};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The tests of this file take turns: they share the allocator.
static TURN: Mutex<()> = Mutex::new(());

/// What `run` returns, and how much more memory it took than there was before, in bytes.
fn peak<T>(run: impl FnOnce() -> T) -> (T, usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = run();
    (result, MEMORY.peak_usage().saturating_sub(before))
}

const MIB: usize = 1024 * 1024;

#[test]
fn bombs_take_little_memory() {
    let _turn = TURN.lock();
    let folder = tempfile::tempdir().unwrap();
    let bomb = Member::deflated("fk.rs", vec![b' '; 50 * MIB]);
    let mut many = vec![Member::stored("x".repeat(1000), ""); 100_000];
    many[0] = bomb.clone();
    let cases = [
        ("bomb", zip(std::slice::from_ref(&bomb)), "too_large"),
        ("liar", zip(&[Member { size: 5, ..bomb.clone() }]), "archive_damaged"),
        ("boaster", zip(&[Member { size: u32::MAX - 1, ..Member::deflated("fk.rs", CODE) }]), "too_large"),
        ("many", zip(&many), "archive_too_large"),
        ("crowd", zip(&vec![Member::stored("a/fk.rs", ""); 60_000]), "archive_too_many_files"),
    ];
    for (name, bytes, expected) in cases {
        let path = folder.path().join(format!("{name}.zip"));
        write(&path, bytes);
        let ((_, loaded), peak) = peak(|| read_one(&path, &wanted()));
        assert_eq!(code(loaded), expected, "{name}");
        assert!(peak < 2 * MIB, "{name} took {peak} bytes");
    }
}

#[test]
fn an_archive_of_bombs_takes_little_memory() {
    let _turn = TURN.lock();
    let folder = tempfile::tempdir().unwrap();
    let bomb = Member::deflated("300000001_A.zip", vec![0; 50 * MIB]);
    let liar = |size, path: &[u8]| Member { size, path: path.to_vec(), ..bomb.clone() };
    let path = folder.path().join("all.zip");
    write(
        &path,
        zip(&[bomb.clone(), liar(9, b"300000002_B.zip"), liar(MAX_ARCHIVE as u32, b"300000003_C.zip")]),
    );
    let (batch, peak_open) = peak(|| Batch::open(&path, &wanted()).unwrap());
    assert!(peak_open < MIB, "opening took {peak_open} bytes");
    for entry in batch.entries() {
        let (loaded, peak) = peak(|| batch.load(entry));
        assert_eq!(
            code(loaded),
            if entry.id.contains('A') { "archive_too_large" } else { "archive_damaged" }
        );
        assert!(peak < MAX_ARCHIVE as usize + 2 * MIB, "{} took {peak} bytes", entry.id);
    }
}

#[test]
fn ten_thousand_submissions_take_memory_for_their_names_only() {
    let _turn = TURN.lock();
    let submission = zip(&[Member::deflated("fk.rs", CODE.repeat(100))]);
    let members: Vec<Member> = (0..10_000)
        .map(|i| Member::stored(format!("{}_Student.zip", 300_000_000 + i), &submission))
        .collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("all.zip");
    write(&path, zip(&members));
    drop(members);
    let (batch, peak_open) = peak(|| Batch::open(&path, &wanted()).unwrap());
    assert!(peak_open < 20 * MIB, "opening took {peak_open} bytes");
    let (_, peak_load) = peak(|| {
        for entry in batch.entries().iter().step_by(100) {
            assert_eq!(source(batch.load(entry)).text.len(), 100 * CODE.len());
        }
    });
    assert!(peak_load < MIB, "loading took {peak_load} bytes");
}

fn check(name: &str, bytes: &[u8]) {
    let _turn = TURN.lock();
    let (loaded, peak) = peak(|| hand_in(name, bytes));
    assert!(peak < 4 * MIB, "took {peak} bytes");
    match loaded {
        Loaded::Source(source) => {
            assert!(source.text.len() as u64 <= 2 * MAX_SOURCE && !source.text.contains(['\0', '\r']));
        }
        Loaded::Rejected(rejection) => assert!(!rejection.why.is_empty()),
    }
}

/// An archive with a few bytes changed, taken away or put in.
fn damaged_zip() -> impl Strategy<Value = Vec<u8>> {
    let members = prop::collection::vec(
        (prop::sample::select(vec!["fk.rs", "a/fk.rs", "FK.rs", "x.txt", "../fk.rs", "d/"]), any::<bool>()),
        0..4,
    );
    let changes = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 0..12);
    (members, changes).prop_map(|(members, changes)| {
        let make = |(name, deflate): &(&str, bool)| {
            if *deflate { Member::deflated(name, CODE) } else { Member::stored(name, CODE) }
        };
        let mut bytes = zip(&members.iter().map(make).collect::<Vec<_>>());
        for (at, byte, how) in changes {
            let at = at.index(bytes.len());
            match how {
                0 => bytes[at] = byte,
                1 => bytes.truncate(at.max(1)),
                _ => bytes.insert(at, byte),
            }
        }
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn any_bytes_as_a_rust_file(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        check("fk.rs", &bytes);
    }

    #[test]
    fn any_bytes_as_an_archive(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        check("a.zip", &bytes);
    }

    #[test]
    fn any_bytes_between_the_marks_of_an_archive(parts in prop::collection::vec(
        (prop::sample::select(vec![&b"PK\x01\x02"[..], b"PK\x03\x04", b"PK\x05\x06", b"PK\x06\x06", b"PK\x06\x07"]),
         prop::collection::vec(prop_oneof![Just(0_u8), Just(0xff), any::<u8>()], 0..60)), 1..8)) {
        let bytes: Vec<u8> = parts.into_iter().flat_map(|(mark, rest)| [mark.to_vec(), rest].concat()).collect();
        check("a.zip", &bytes);
    }

    #[test]
    fn damaged_archives(bytes in damaged_zip()) {
        check("a.zip", &bytes);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("all.zip");
        write(&path, &bytes);
        if let Ok(batch) = Batch::open(&path, &wanted()) {
            for entry in batch.entries() {
                let _ = batch.load(entry);
            }
        }
    }

    #[test]
    fn what_is_packed_is_read_again(text in "[ -~\n]{0,300}[!-~]", number in "[0-9]{5,12}", name in "[A-Z][a-z]{1,9}") {
        let packed = write_zip(&number, &name, text.as_bytes(), &wanted()).unwrap();
        let again = write_zip(&number, &name, text.as_bytes(), &wanted()).unwrap();
        prop_assert_eq!(&packed, &again);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(&packed.file_name);
        write(&path, &packed.bytes);
        let (entry, loaded) = read_one(&path, &wanted());
        prop_assert_eq!(source(loaded).text, text);
        prop_assert_eq!(entry.student.number, Some(number));
        prop_assert_eq!(entry.student.name, name);
    }
}
