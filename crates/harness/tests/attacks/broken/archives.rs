//! Archives that lie about where their files belong, how large they are or what they hold.

use super::{List, What, right};
use crate::zip::{File, archive};

/// Where files in archives say that they belong.
pub fn paths(list: &mut List) {
    let right = |path: &str| [File::new(path, right(path))];
    list.zip("plain", "An archive as it should be", "graded 15", &right("fk.rs")).quick = true;
    let path = "../../../../../../../../../../tmp/fk-lab-slipped/fk.rs";
    list.zip("slips_out", "A file that would lie outside, by `../`", "graded 15", &right(path)).quick = true;
    list.zip("absolute", "A file that would lie at the root", "graded 15", &right("/fk-lab-slipped/fk.rs"));
    list.zip("drive", "A file that would lie on another drive", "graded 15", &right("C:\\fk.rs"));
    list.zip(
        "slips_out_backwards",
        "A file that would lie outside, by `..\\`",
        "graded 15",
        &right("..\\..\\fk.rs"),
    );
    list.zip(
        "windows_names",
        "Folders as Windows separates them",
        "graded 15",
        &right("exercises\\fk\\src\\fk.rs"),
    );
    list.zip("wrapped", "A folder around the file", "graded 15", &right("TerryFox/assignment 1/fk.rs"));
    list.zip(
        "odd_letters",
        "A path that is no text, with commands for a terminal",
        "graded 15",
        &[File::new(b"\xff\x1b[31m\r\n/fk.rs".to_vec(), super::right("odd letters"))],
    );
    let mut link = File::new("fk.rs", "/etc/passwd");
    link.mode = 0o120_777;
    list.zip("link", "The file is a link to a file outside", "rejected link", &[link]);
    let mut device = File::new("fk.rs", "");
    device.mode = 0o020_666;
    list.zip("device", "The file is a device", "rejected special_file", &[device]);
}

/// Archives that are damaged, too large, or lie.
pub fn damaged(list: &mut List) {
    let plain = |name: &str| File::new("fk.rs", right(name));
    let bomb = File::new("fk.rs", vec![b' '; 256 << 20]).compressed();
    list.zip("bomb", "256 MiB of blanks in 256 KiB", "rejected too_large", &[bomb]).quick = true;
    let mut lies = plain("says less").compressed();
    lies.size = 10;
    list.zip("says_less", "Says that the file is smaller than it is", "rejected archive_damaged", &[lies]);
    let mut lies = plain("says more").compressed();
    lies.size = u32::MAX - 1;
    list.zip(
        "says_more",
        "Says that the file has four thousand million bytes",
        "rejected archive_damaged | rejected too_large",
        &[lies],
    );
    let mut lies = plain("other checksum");
    lies.crc32 ^= 1;
    list.zip(
        "other_checksum",
        "The contents are not those of the checksum",
        "rejected archive_damaged",
        &[lies],
    );
    let mut twin = plain("twin");
    twin.name = b"notes.txt".to_vec();
    twin.place_of = Some(0);
    list.zip("overlap", "Two files share their bytes", "rejected archive_overlap", &[plain("overlap"), twin]);
    let many: Vec<File> = (0..100_000).map(|i| File::new(format!("{i}.txt"), "")).collect();
    list.zip("many", "A hundred thousand files", "rejected archive_too_many_files", &many);
    let inner = archive(&[plain("nested")]);
    list.zip(
        "nested",
        "An archive in an archive",
        "rejected archive_nested",
        &[File::new("inner.zip", inner)],
    );
    let mut secret = plain("encrypted");
    secret.flags = 1;
    list.zip("encrypted", "Needs a password", "rejected archive_encrypted", &[secret]);
    let mut lzma = plain("lzma");
    lzma.method = 14;
    list.zip("method", "Compressed in a way that few programs know", "rejected archive_method", &[lzma]);
    let mut cut = archive(&[plain("cut")]);
    cut.truncate(cut.len() / 2);
    list.add("cut.zip", "Cut off in the middle", "rejected archive_damaged", What::File(cut)).quick = true;
    list.add(
        "prose.zip",
        "A text that is called an archive",
        "rejected not_a_zip",
        What::File(b"see my repository".to_vec()),
    );
    list.add(
        "rar.zip",
        "Another kind of archive",
        "rejected not_a_zip",
        What::File(b"Rar!\x1a\x07\x01\0\0\0\0\0".to_vec()),
    );
    list.add("nothing.zip", "No bytes at all", "rejected empty", What::File(Vec::new()));
    list.zip("without_files", "An archive without files", "rejected no_source", &[]);
    let mut prefix = b"#!/bin/sh\nexit 0\n".to_vec();
    prefix.extend(archive(&[plain("prefix")]));
    list.add(
        "prefix.zip",
        "Something else before the archive",
        "graded 15 | rejected archive_damaged | rejected not_a_zip",
        What::File(prefix),
    );
    let mut noise = archive(&[plain("noise")]);
    for (i, byte) in noise.iter_mut().enumerate().skip(4) {
        *byte ^= (i as u8).wrapping_mul(167);
    }
    list.add(
        "noise.zip",
        "Begins like an archive and goes on as noise",
        "rejected archive_damaged",
        What::File(noise),
    );
}

/// Archives in which the file is to be found.
pub fn choices(list: &mut List) {
    let file = |path: &str| File::new(path, right(path));
    let rust = |path: &str| File::new(path, "pub fn other() {}\n");
    list.zip(
        "same_name_twice",
        "Two files of one name",
        "rejected two_candidates",
        &[file("fk.rs"), rust("fk.rs")],
    );
    list.zip("upper_and_lower", "Names that differ in case", "graded 15", &[rust("FK.rs"), file("fk.rs")]);
    list.zip(
        "only_upper",
        "Two names that are nearly right",
        "rejected two_candidates",
        &[file("FK.RS"), rust("Fk.rs")],
    );
    let litter = [
        File::new("__MACOSX/._fk.rs", b"\0\x05\x16\x07"),
        File::new("._fk.rs", b"\0\x05\x16\x07"),
        file("fk.rs"),
    ];
    list.zip("from_a_mac", "What a Mac leaves behind", "graded 15", &litter).quick = true;
    list.zip("other_name", "The file under another name", "graded 15", &[file("my_solution.rs")]);
    list.zip(
        "other_names",
        "Two files under other names",
        "rejected wrong_name",
        &[file("one.rs"), rust("two.rs")],
    );
    list.zip(
        "two_folders",
        "Two files of the right name",
        "rejected two_candidates",
        &[file("old/fk.rs"), rust("new/fk.rs")],
    );
    list.zip(
        "whole_project",
        "The whole project",
        "graded 15",
        &[
            file("fk-lab/exercises/fk/src/fk.rs"),
            rust("fk-lab/solutions/src/fk.rs"),
            rust("fk-lab/exercises/fk/src/lib.rs"),
        ],
    );
    list.zip(
        "brings_a_build",
        "A build script, a procedural macro and settings of cargo, none of which is used",
        "graded 15",
        &build(),
    );
    list.zip(
        "a_document",
        "A document of an office program, which is an archive",
        "rejected no_source",
        &[File::new("[Content_Types].xml", "<Types/>"), File::new("word/document.xml", "<document/>")],
    );
    list.zip(
        "a_folder_of_that_name",
        "A folder that is called like the file",
        "rejected no_source",
        &[File::new("fk.rs/", "")],
    );
}

fn build() -> [File; 6] {
    let script =
        "fn main() { std::fs::write(\"/tmp/fk-lab-slipped\", \"built\").unwrap(); panic!(\"built\"); }\n";
    let manifest =
        "[package]\nname = \"fk\"\nversion = \"9.9.9\"\nbuild = \"build.rs\"\n[lib]\nproc-macro = true\n";
    let settings = "[build]\nrustc-wrapper = \"/bin/false\"\nrustflags = [\"-Clinker=/bin/false\"]\n";
    [
        File::new("exercises/fk/src/fk.rs", right("brings a build")),
        File::new("exercises/fk/build.rs", script),
        File::new("exercises/fk/Cargo.toml", manifest),
        File::new(".cargo/config.toml", settings),
        File::new("rust-toolchain.toml", "[toolchain]\nchannel = \"1.0.0\"\n"),
        File::new("exercises/fk/src/lib.rs", "compile_error!(\"replaced\");\n"),
    ]
}
