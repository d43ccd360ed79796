//! Submissions whose files, archives and names are the attack: made here, as no tool would make them.

mod archives;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::corpus::solution;
use crate::expected::Expected;
use crate::zip::{File, archive};

/// A submission that is made by code.
pub struct Broken {
    /// What follows the student's number in the name of the file. `None`: the file has `name` alone.
    pub name: String,
    /// What is odd about it.
    pub text: &'static str,
    pub expect: Expected,
    pub quick: bool,
    what: What,
    has_number: bool,
}

enum What {
    File(Vec<u8>),
    /// Files in a folder.
    Folder(Vec<(&'static str, Vec<u8>)>),
    /// A link to the file of this name (see [`crate::corpus::fill`]).
    Link(&'static str),
    /// A folder with a link of this name in it to that file.
    FolderWithLink(&'static str, &'static str),
    Pipe,
}

impl Broken {
    /// The file's name for the student with this number.
    pub fn file_name(&self, number: u32) -> String {
        if self.has_number { format!("{number}_{}", self.name) } else { self.name.clone() }
    }

    /// Puts it into `folder`.
    pub fn write(&self, folder: &Path, number: u32, names: &BTreeMap<&str, String>) {
        let path = folder.join(self.file_name(number));
        let target = |name: &str| names[name].clone();
        match &self.what {
            What::File(bytes) => fs::write(path, bytes).unwrap(),
            What::Folder(files) => {
                for (name, bytes) in files {
                    let file = path.join(name);
                    fs::create_dir_all(file.parent().unwrap()).unwrap();
                    fs::write(file, bytes).unwrap();
                }
            }
            What::Link(to) => std::os::unix::fs::symlink(target(to), path).unwrap(),
            What::FolderWithLink(name, to) => {
                fs::create_dir(&path).unwrap();
                std::os::unix::fs::symlink(target(to), path.join(name)).unwrap();
            }
            What::Pipe => {
                let mode = nix::sys::stat::Mode::from_bits_truncate(0o644);
                nix::unistd::mkfifo(&path, mode).unwrap();
            }
        }
    }
}

struct List(Vec<Broken>);

impl List {
    fn add(&mut self, name: &str, text: &'static str, expect: &str, what: What) -> &mut Broken {
        let expect = Expected::parse(expect).unwrap();
        self.0.push(Broken { name: name.to_owned(), text, expect, quick: false, what, has_number: true });
        self.0.last_mut().unwrap()
    }

    fn zip(&mut self, name: &str, text: &'static str, expect: &str, files: &[File]) -> &mut Broken {
        self.add(&format!("{name}.zip"), text, expect, What::File(archive(files)))
    }

    fn text(&mut self, name: &str, text: &'static str, expect: &str, bytes: impl AsRef<[u8]>) -> &mut Broken {
        self.add(&format!("{name}.rs"), text, expect, What::File(bytes.as_ref().to_vec()))
    }
}

/// All of them.
pub fn broken() -> Vec<Broken> {
    let mut list = List(Vec::new());
    archives::paths(&mut list);
    archives::damaged(&mut list);
    archives::choices(&mut list);
    texts(&mut list);
    names(&mut list);
    no_files(&mut list);
    list.0
}

/// The right solution, with a line of its own so that it is nobody else's file.
fn right(name: &str) -> String {
    format!("{}\npub const HANDED_IN_AS: &str = {name:?};\n", solution())
}

/// Texts in every encoding, and what is none.
fn texts(list: &mut List) {
    let template = include_bytes!("../../../../solutions/templates/fk.rs");
    let untouched = "graded 0; part1 not-started; part2 not-started; part3 not-started";
    list.text("untouched", "The file as it was handed out", untouched, template).quick = true;
    list.text("zero_bytes", "No bytes at all", "rejected empty", "").quick = true;
    list.text("blanks", "Blanks and empty lines", "rejected empty", " \n\t\n\r\n");
    let mut mark = b"\xef\xbb\xbf".to_vec();
    mark.extend(right("byte order mark").bytes());
    list.text("byte_order_mark", "A byte order mark", "graded 15", mark);
    let wide = |name: &str, unit: fn(u16) -> [u8; 2]| -> Vec<u8> {
        ('\u{feff}'.to_string() + &right(name)).encode_utf16().flat_map(unit).collect()
    };
    list.text("utf_16", "UTF-16, as Windows has it", "graded 15", wide("little", u16::to_le_bytes)).quick =
        true;
    list.text("utf_16_other", "UTF-16, the other way around", "graded 15", wide("big", u16::to_be_bytes));
    list.text("crlf", "Lines that end as in Windows", "graded 15", right("crlf").replace('\n', "\r\n"));
    list.text("cr", "Lines that end as on old Macs", "graded 15", right("cr").replace('\n', "\r"));
    list.text("zero_byte", "A zero byte in the middle", "rejected binary", right("zero") + "// \0\n");
    let turned = right("turned") + "// \u{202e}graded 15\u{2066}\n";
    list.text(
        "turned_around",
        "Letters that turn the writing direction around",
        "does-not-compile \"visible direction\"",
        turned,
    );
    let mut latin = right("latin").into_bytes();
    latin.extend(b"// Schr\xf6dingers L\xf6sung\n");
    list.text("latin_1", "Letters in Latin-1", "graded 15", latin);
    list.text(
        "zero_width",
        "Letters that cannot be seen, in a name",
        "does-not-compile",
        right("zero width") + "const A\u{200b}B: u8 = 0;\n",
    );
    list.text("pdf", "A PDF that is called a Rust file", "rejected not_source", "%PDF-1.7\n");
    list.text(
        "program",
        "A program that is called a Rust file",
        "rejected not_source",
        b"\x7fELF\x02\x01\x01\0",
    );
    let long = right("long") + &"// All work and no play makes Jack a dull boy\n".repeat(10_000);
    list.text("too_long", "460 kB of comments", "rejected too_large", long);
    list.text(
        "one_line",
        "Everything in one line of 200,000 letters",
        "graded 15",
        right("one line") + &format!("const LONG: &str = \"{}\";\n", "x".repeat(200_000)),
    );
    list.add(
        "notes.txt",
        "Neither a Rust file nor an archive",
        "rejected wrong_type",
        What::File(b"done".to_vec()),
    );
}

/// Names of students and of files.
fn names(list: &mut List) {
    let mut name = |name: &str, text| {
        let mut file = archive(&[File::new("fk.rs", right(name))]);
        file.extend_from_slice(b"");
        list.add(&format!("{name}.zip"), text, "graded 15", What::File(file));
    };
    name("=cmd|' C calc'!A0", "A name that a spreadsheet would compute");
    name("+1+1", "Another one");
    name("@SUM(A1)", "And another");
    name("Robert\"); DROP TABLE Students;--", "A name with quotes, semicolons and dashes");
    name("Fox, Terry, \"the runner\"", "A name with commas and quotes");
    name("<script>document.title = 'taken over'", "A name with a script");
    name("<img src=x onerror=alert(1)>&amp;", "A name with HTML");
    name("\u{1b}[31mred\u{1b}[0m\u{7}", "A name with commands for a terminal");
    name("two\nlines\r\nand more", "A name of several lines");
    name("\u{202e}xoF yrreT", "A name that turns the writing direction around");
    name("Łukasz Żółć 张伟", "A name with letters of other scripts");
    name("[link](javascript:alert(1)) `code` **bold** | cell", "A name that a page of Markdown would obey");
    name(&"long".repeat(55), "A name as long as names can be");
    name("..", "A name that means the folder above");
    name("%2e%2e%2f&#60;b&#62;", "A name that is written in codes");
    name("%s%n%x{}{0}$HOME`id`$(id)", "A name that a program could mistake for commands");
    let file = |name: &str| What::File(archive(&[File::new("fk.rs", right(name))]));
    for (name, text) in
        [("homework.zip", "No student's number"), ("CON.zip", "A name that Windows keeps for itself")]
    {
        list.add(name, text, "graded 15", file(name)).has_number = false;
    }
    for name in ["300999999_TwiceHandedIn.zip", "300999999_TwiceHandedIn.rs"] {
        let what = if name.ends_with("zip") { file(name) } else { What::File(right(name).into_bytes()) };
        list.add(name, "Two submissions of one student", "graded 15", what).has_number = false;
    }
}

/// What is no file.
fn no_files(list: &mut List) {
    let right = |name: &str| right(name).into_bytes();
    list.add("folder", "A folder", "graded 15", What::Folder(vec![("src/fk.rs", right("folder"))]));
    list.add(
        "empty_folder",
        "A folder without files",
        "rejected no_source",
        What::Folder(vec![(".hidden", Vec::new())]),
    );
    list.add("link.rs", "A link to a file outside", "rejected link", What::Link("SECRET"));
    list.add(
        "link_to_solution.rs",
        "A link to the reference solution",
        "rejected link",
        What::Link("SOLUTION"),
    );
    list.add("link_to_folder", "A link to a folder outside", "rejected link", What::Link("OUTSIDE"));
    list.add(
        "folder_with_link",
        "A folder with a link to the solution in it",
        "rejected link",
        What::FolderWithLink("fk.rs", "SOLUTION"),
    );
    list.add(
        "folder_in_itself",
        "A folder that holds itself",
        "rejected no_source | rejected link",
        What::FolderWithLink("again", "SUBMISSIONS"),
    );
    list.add("pipe.rs", "A pipe, from which reading never ends", "rejected special_file", What::Pipe);
}
