//! The book names the keys that the viewer has. `FK_LAB_BLESS=1 cargo test -p viewer --test book` writes them again.

use std::path::Path;
use std::{env, fs};

use viewer::window::keys;

#[test]
fn the_keys_in_the_book_are_those_of_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/viewer.md");
    let text = fs::read_to_string(&path).unwrap();
    let rows: String = keys::help().map(|(name, help)| format!("| {name} | {help} |\n")).collect();
    let table = format!("| key | what it does |\n|---|---|\n{rows}");

    let (begin, end) = ("<!-- keys: begin -->\n", "<!-- keys: end -->");
    let from = text.find(begin).unwrap() + begin.len();
    let to = text.find(end).unwrap();
    if env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(&path, format!("{}{table}{}", &text[..from], &text[to..])).unwrap();
    } else {
        assert_eq!(text[from..to], table);
    }
}
