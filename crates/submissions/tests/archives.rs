//! Archives, whatever they try: one clear verdict each.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use submissions::{MAX_ARCHIVE, MAX_FILES, MAX_SOURCE};
use support::{CODE, Member, code, end, hand_in, hand_in_zip, rejected, source, zip};

#[track_caller]
fn reads(members: &[Member]) -> Vec<String> {
    let source = source(hand_in_zip(members));
    assert_eq!(source.text, CODE);
    source.remarks
}

#[track_caller]
fn refuses(members: &[Member]) -> &'static str {
    code(hand_in_zip(members))
}

fn good() -> Member {
    Member::deflated("fk.rs", CODE)
}

#[test]
fn the_one_file_is_read() {
    assert!(reads(&[good()]).is_empty());
    assert!(reads(&[Member::stored("fk.rs", CODE)]).is_empty());
    assert!(reads(&[Member { mode: 0, ..good() }]).is_empty(), "made on Windows");
    assert!(reads(&[Member { mode: 0, ..Member::stored("300000001_TerryFox/fk.rs", CODE) }]).is_empty());
}

#[test]
fn a_folder_around_it_does_no_harm() {
    let folder = Member { mode: 0o040_755, ..Member::stored("Terry/", "") };
    assert!(reads(&[folder, Member::deflated("Terry/deeper/fk.rs", CODE)]).is_empty());
}

#[test]
fn what_systems_leave_behind_is_ignored() {
    let litter = ["__MACOSX/._fk.rs", "._fk.rs", ".DS_Store", "__MACOSX/fk.rs", "Thumbs.db", ".git/fk.rs"];
    let mut members: Vec<Member> = litter.iter().map(|path| Member::stored(path, "litter")).collect();
    members.push(good());
    assert!(reads(&members).is_empty());
}

#[test]
fn names_that_lead_elsewhere_are_only_names() {
    let names = [
        "../fk.rs",
        "../../../../etc/fk.rs",
        "/etc/fk.rs",
        "C:\\fk.rs",
        "..\\..\\fk.rs",
        "a/../../fk.rs",
        "//host/fk.rs",
    ];
    for name in names {
        let remarks = reads(&[Member::deflated(name, CODE)]);
        assert_eq!(remarks.len(), 1, "{name}: {remarks:?}");
        assert!(remarks[0].contains("only its last part was looked at"), "{remarks:?}");
    }
    assert!(reads(&[Member::deflated("Terry\\fk.rs", CODE)]).is_empty(), "as old Windows programs write");
    assert_eq!(refuses(&[Member::deflated("fk.rs/../passwd", CODE)]), "no_source");
}

#[test]
fn a_file_of_another_name_is_read_if_it_is_the_only_one() {
    for name in ["FK.RS", "Fk.rs"] {
        assert!(reads(&[Member::deflated(name, CODE)])[0].contains("not fk.rs"));
    }
    for name in ["fk (1).rs", "fk-1.rs", "solution.rs", "main.RS"] {
        assert!(
            reads(&[Member::deflated(name, CODE), Member::stored("notes.txt", "")])[0]
                .contains("only Rust file")
        );
    }
    assert_eq!(refuses(&[Member::deflated("a.rs", CODE), Member::deflated("b.rs", CODE)]), "wrong_name");
}

#[test]
fn the_right_name_wins_over_others() {
    assert!(reads(&[Member::stored("a.rs", "no"), good(), Member::stored("FK.rs", "no")]).is_empty());
}

#[test]
fn two_files_of_the_right_name_are_one_too_many() {
    for (a, b) in [("fk.rs", "fk.rs"), ("a/fk.rs", "b/fk.rs"), ("FK.rs", "Fk.rs"), ("fk.rs", "../fk.rs")] {
        let rejection = rejected(hand_in_zip(&[Member::deflated(a, CODE), Member::deflated(b, "other")]));
        assert_eq!(rejection.code, "two_candidates");
        assert!(rejection.why.contains(a) && rejection.why.contains(b), "{rejection:?}");
    }
}

#[test]
fn the_whole_project_is_understood() {
    let mut members = vec![
        Member::deflated("fk-lab/solutions/templates/fk.rs", "template"),
        Member::deflated("fk-lab/exercises/fk/src/fk.rs", CODE),
        Member::deflated("fk-lab/solutions/src/fk.rs", "solution"),
    ];
    members.extend((0..500).map(|i| Member::stored(format!("fk-lab/target/debug/deps/fk-{i}.rs"), "x")));
    let remarks = reads(&members);
    assert!(remarks[0].contains("fk-lab/exercises/fk/src/fk.rs was read"), "{remarks:?}");
    members.push(Member::deflated("copy/exercises/fk/src/fk.rs", "other"));
    assert_eq!(refuses(&members), "two_candidates");
}

#[test]
fn links_and_devices_in_it_are_refused() {
    assert_eq!(refuses(&[Member { mode: 0o120_777, ..Member::stored("fk.rs", "/etc/passwd") }]), "link");
    for mode in [0o020_666, 0o060_666, 0o010_666, 0o140_666] {
        assert_eq!(refuses(&[Member { mode, ..good() }]), "special_file");
    }
}

#[test]
fn a_bomb_costs_nothing() {
    let bomb = Member::deflated("fk.rs", vec![b' '; 64 * 1024 * 1024]);
    assert!(bomb.data.len() < MAX_SOURCE as usize);
    assert_eq!(refuses(std::slice::from_ref(&bomb)), "too_large");
    assert_eq!(refuses(&[Member { size: 100, ..bomb.clone() }]), "archive_damaged", "it lies about its size");
    assert!(
        reads(&[Member { path: b"other.txt".to_vec(), ..bomb }, good()]).is_empty(),
        "it is not looked at"
    );
}

#[test]
fn a_file_may_be_as_large_as_the_limit_and_no_larger() {
    let longest = vec![b'/'; MAX_SOURCE as usize];
    assert_eq!(source(hand_in_zip(&[Member::stored("fk.rs", &longest)])).text.len(), longest.len());
    assert_eq!(refuses(&[Member::stored("fk.rs", [&longest[..], b"/"].concat())]), "too_large");
}

#[test]
fn what_an_archive_says_must_be_so() {
    for size in [0, 1, CODE.len() as u32 - 1, CODE.len() as u32 + 1, MAX_SOURCE as u32] {
        assert_eq!(refuses(&[Member { size, ..good() }]), "archive_damaged", "size {size}");
    }
    for size in [MAX_SOURCE as u32 + 1, u32::MAX - 1, u32::MAX] {
        assert_eq!(refuses(&[Member { size, ..good() }]), "too_large", "size {size}");
    }
    assert_eq!(refuses(&[Member { crc: 1, ..good() }]), "archive_damaged");
    assert_eq!(refuses(&[Member { offset: Some(7), ..good() }]), "archive_damaged");
    assert_eq!(refuses(&[Member { offset: Some(u32::MAX), ..good() }]), "archive_damaged");
    let mut count_is_wrong = zip(&[good(), Member::stored("a.txt", "")]);
    let at = count_is_wrong.len() - 22 + 8;
    count_is_wrong[at..at + 4].copy_from_slice(&[9, 0, 9, 0]);
    assert_eq!(code(hand_in("a.zip", &count_is_wrong)), "archive_damaged");
}

#[test]
fn damaged_data_is_refused() {
    let mut member = good();
    member.data[0] ^= 0xff;
    assert_eq!(refuses(&[member]), "archive_damaged");
    let mut member = good();
    member.data.truncate(10);
    assert_eq!(refuses(&[member]), "archive_damaged");
}

#[test]
fn a_file_that_reaches_into_the_list_is_refused() {
    let mut bytes = zip(&[good()]);
    let list_start = bytes.windows(4).position(|four| four == b"PK\x01\x02").unwrap();
    // What follows the end of the data would not matter to whoever unpacks it.
    for at in [18, list_start + 20] {
        bytes[at] += 10;
    }
    assert_eq!(code(hand_in("300000001_TerryFox.zip", &bytes)), "archive_damaged");
}

#[test]
fn data_that_goes_on_without_giving_anything_is_refused() {
    let mut member = good();
    // Blocks of no bytes (RFC 1951, section 3.2.4).
    let nothing = b"\0\0\0\xff\xff".repeat(100_000);
    member.data = [&nothing[..], &member.data[..]].concat();
    assert_eq!(refuses(&[member]), "too_large");
}

#[test]
fn an_archive_that_was_cut_off_is_refused_wherever_it_was_cut() {
    let whole = zip(&[good(), Member::stored("notes.txt", "notes")]);
    for len in 1..whole.len() {
        let code = code(hand_in("300000001_TerryFox.zip", &whole[..len]));
        assert!(matches!(code, "archive_damaged" | "not_a_zip"), "{len} bytes: {code}");
    }
    assert_eq!(code(hand_in("300000001_TerryFox.zip", b"")), "empty");
}

#[test]
fn files_that_share_bytes_are_refused() {
    let mut second = good();
    second.path = b"other.txt".to_vec();
    assert_eq!(refuses(&[good(), Member { offset: Some(0), ..second.clone() }]), "archive_overlap");
    assert_eq!(refuses(&[good(), Member { offset: Some(5), ..second.clone() }]), "archive_overlap");
    // One that would contain the whole archive.
    let outer = Member { offset: Some(0), ..Member::stored("all.txt", vec![0; 4000]) };
    assert_eq!(refuses(&[Member::stored("a.txt", "a"), good(), outer]), "archive_overlap");
    assert!(reads(&[second, good()]).is_empty());
}

#[test]
fn encrypted_files_are_refused() {
    for flags in [0x0001, 0x0041, 0x2000] {
        assert_eq!(refuses(&[Member { flags, ..good() }]), "archive_encrypted");
    }
    assert_eq!(refuses(&[Member { flags: 1, method: 99, ..good() }]), "archive_encrypted");
}

#[test]
fn unusual_compression_is_refused_by_name() {
    for (method, name) in [(9, "DEFLATE64"), (12, "BZIP2"), (14, "LZMA"), (93, "ZSTD"), (777, "number 777")] {
        let rejection = rejected(hand_in_zip(&[Member { method, ..good() }]));
        assert_eq!(rejection.code, "archive_method");
        assert!(rejection.why.contains(name), "{rejection:?}");
    }
}

#[test]
fn an_archive_in_an_archive_is_refused() {
    let inner = zip(&[good()]);
    assert_eq!(refuses(&[Member::stored("300000001_TerryFox.zip", &inner)]), "archive_nested");
    assert_eq!(refuses(&[Member::stored("a.rar", "x")]), "archive_nested");
    assert_eq!(
        refuses(&[Member::stored("a.zip", &inner), Member::stored("b.zip", &inner)]),
        "two_candidates"
    );
    assert!(reads(&[Member::stored("a.zip", &inner), good()]).is_empty(), "it is not looked at");
}

#[test]
fn too_many_files_are_refused() {
    let mut members = vec![Member::stored("x", ""); MAX_FILES];
    members[77] = good();
    assert!(reads(&members).is_empty());
    members.push(Member::stored("x", ""));
    assert_eq!(refuses(&members), "archive_too_many_files");
    members.resize(100_000, Member::stored("x", ""));
    assert_eq!(refuses(&members), "archive_too_many_files");
}

#[test]
fn an_archive_that_is_too_large_is_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.zip");
    std::fs::write(&path, b"PK\x03\x04").unwrap();
    std::fs::File::options().write(true).open(&path).unwrap().set_len(MAX_ARCHIVE + 1).unwrap();
    assert_eq!(code(submissions::read_one(&path, &support::wanted()).1), "archive_too_large");
}

#[test]
fn nothing_to_mark_is_said() {
    assert_eq!(refuses(&[]), "no_source");
    assert_eq!(refuses(&[Member::stored("__MACOSX/fk.rs", CODE)]), "no_source");
    assert_eq!(refuses(&[Member::stored("readme.md", "hello")]), "no_source");
    assert_eq!(refuses(&[Member::stored("fk.rs", "")]), "empty");
}

#[test]
fn archives_of_other_kinds_are_named() {
    let formats: [(&str, &[u8], &str); 6] = [
        ("a.rar", b"Rar!\x1a\x07\x01\0", "RAR"),
        ("a.7z", b"7z\xbc\xaf\x27\x1c\0\x04", "7-Zip"),
        ("a.tar.gz", b"\x1f\x8b\x08\0", "gzip"),
        ("a.zip", b"Rar!\x1a\x07\x01\0", "RAR"),
        ("a.zip", b"7z\xbc\xaf\x27\x1c\0\x04", "7-Zip"),
        ("a.zip", b"%PDF-1.7", "PDF"),
    ];
    for (name, bytes, format) in formats {
        let rejection = rejected(hand_in(name, bytes));
        assert_eq!(rejection.code, "not_a_zip", "{name}");
        assert!(rejection.why.contains(format), "{rejection:?}");
    }
    let mut tar = vec![0; 512];
    tar[257..262].copy_from_slice(b"ustar");
    assert!(rejected(hand_in("a.tar", &tar)).why.contains("tar archive"));
    assert_eq!(code(hand_in("fk.rs.txt", CODE.as_bytes())), "wrong_type");
    assert!(rejected(hand_in("fk.pdf", b"%PDF-1.7")).why.contains("a PDF"));
}

#[test]
fn a_zip_archive_needs_no_extension() {
    assert_eq!(source(hand_in("300000001_TerryFox", &zip(&[good()]))).text, CODE);
}

#[test]
fn bytes_in_front_and_a_comment_behind_do_no_harm() {
    let mut bytes = b"#!/bin/sh\n".to_vec();
    bytes.extend(zip(&[good()]));
    assert_eq!(source(hand_in("300000001_TerryFox.zip", &bytes)).text, CODE);
    let mut bytes = zip(&[good()]);
    let len = bytes.len();
    bytes[len - 2] = 5;
    bytes.extend(b"hello");
    assert_eq!(source(hand_in("300000001_TerryFox.zip", &bytes)).text, CODE);
}

/// Section 4.3.14: sizes and places of eight bytes.
#[test]
fn zip64_is_read() {
    let mut member = good();
    let sizes = [u64::from(member.size), member.data.len() as u64];
    member.extra = [&[1, 0, 16, 0][..], &sizes[0].to_le_bytes(), &sizes[1].to_le_bytes()].concat();
    let plain = zip(&[member]);
    let list_start = plain.windows(4).position(|four| four == b"PK\x01\x02").unwrap();
    let list_end = plain.len() - 22;
    let mut bytes = plain[..list_end].to_vec();
    for start in [0, list_start] {
        let at = start + if start == 0 { 18 } else { 20 };
        bytes[at..at + 8].fill(0xff);
    }
    let zip64_end = bytes.len() as u64;
    bytes.extend(b"PK\x06\x06");
    bytes.extend(44_u64.to_le_bytes());
    bytes.extend([45, 0, 45, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    for field in [1, 1, (list_end - list_start) as u64, list_start as u64] {
        bytes.extend(field.to_le_bytes());
    }
    bytes.extend(b"PK\x06\x07\0\0\0\0");
    bytes.extend(zip64_end.to_le_bytes());
    bytes.extend([1, 0, 0, 0]);
    let mut old_end = end(0, 0, 0);
    old_end[8..20].fill(0xff);
    bytes.extend(old_end);
    assert_eq!(source(hand_in("300000001_TerryFox.zip", &bytes)).text, CODE);
}
