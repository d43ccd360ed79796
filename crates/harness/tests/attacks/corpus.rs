//! The attacks in `tests/hostile`: one small file each, with what must become of it in its head.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::expected::Expected;

/// The reference solution, without the words at its head: attacks stand before it.
pub fn solution() -> String {
    let lines =
        include_str!("../../../../solutions/src/fk.rs").lines().filter(|line| !line.starts_with("//!"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// One attack.
pub struct Attack {
    /// Its folder and name, for example `run/endless_loop`.
    pub name: String,
    /// What it tries.
    pub text: String,
    pub expect: Expected,
    /// Where it sees more than in a root of its own.
    pub without_namespaces: Option<Expected>,
    /// What becomes of it when nothing holds it back: the proof that it is an attack.
    pub unprotected: Option<Expected>,
    /// Whether it is one of the few that every test run tries.
    pub quick: bool,
    place: Place,
    code: String,
}

/// Where the attack stands in an otherwise right solution.
enum Place {
    /// Beside the functions.
    Beside,
    /// Called first thing in this function.
    Before(String),
    /// In place of these functions. The right ones are there as `right_…`.
    InsteadOf(Vec<String>),
    /// There is no solution beside it.
    Alone,
}

/// The folder of the attacks.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hostile")
}

/// All of them, in the order of their names.
pub fn attacks() -> Vec<Attack> {
    let mut attacks = Vec::new();
    for kind in ["compile", "raw", "run"] {
        let files = fs::read_dir(folder().join(kind)).unwrap().map(|entry| entry.unwrap().path());
        attacks.extend(files.map(|file| attack(kind, &file)));
    }
    attacks.sort_by(|a, b| a.name.cmp(&b.name));
    attacks
}

fn attack(kind: &str, file: &Path) -> Attack {
    let name = format!("{kind}/{}", file.file_stem().unwrap().to_string_lossy());
    let source = fs::read_to_string(file).unwrap();
    let is_head = |line: &&str| line.starts_with("//!");
    let head = source.lines().take_while(is_head).map(|line| line.trim_start_matches("//!").trim());
    let (text, keys): (Vec<&str>, Vec<&str>) =
        head.filter(|line| !line.is_empty()).partition(|line| !is_key(line));
    let mut keys: BTreeMap<&str, &str> = keys.iter().filter_map(|line| line.split_once(": ")).collect();
    let expected = |text: &str| Expected::parse(text).unwrap_or_else(|why| panic!("{name}: {why}"));

    let code = source.lines().skip_while(is_head).flat_map(|line| [line, "\n"]).collect::<String>();
    let helper = keys.remove("with").map(|name| fs::read_to_string(folder().join(format!("with/{name}.rs"))));
    let attack = Attack {
        text: text.join(" "),
        expect: expected(keys.remove("expect").unwrap_or_default()),
        without_namespaces: keys.remove("expect without namespaces").map(expected),
        unprotected: keys.remove("unprotected").map(expected),
        quick: keys.remove("quick").is_some(),
        place: place(keys.remove("place"), kind),
        // Attributes of the file stand first, so that helpers come behind.
        code: code + &helper.map(Result::unwrap).unwrap_or_default(),
        name,
    };
    assert!(!attack.text.is_empty() && keys.is_empty(), "{}: {keys:?}", attack.name);
    attack
}

fn is_key(line: &str) -> bool {
    const KEYS: [&str; 6] = ["place", "with", "expect", "expect without namespaces", "unprotected", "quick"];
    line.split_once(": ").is_some_and(|(key, _)| KEYS.contains(&key))
}

fn place(place: Option<&str>, kind: &str) -> Place {
    let Some(place) = place else {
        return if kind == "compile" { Place::Beside } else { Place::Before("local_quaternion".to_owned()) };
    };
    match (place.strip_prefix("before "), place.strip_prefix("instead of ")) {
        (Some(function), _) => Place::Before(function.to_owned()),
        (_, Some(functions)) => Place::InsteadOf(functions.split(", ").map(str::to_owned).collect()),
        _ => {
            assert_eq!(place, "alone");
            Place::Alone
        }
    }
}

impl Attack {
    /// The file as it is handed in. `names` are put in place of the words between `@`.
    pub fn source(&self, names: &BTreeMap<&str, String>) -> String {
        let mut rest = match &self.place {
            Place::Alone => String::new(),
            _ => solution(),
        };
        match &self.place {
            Place::Before(function) => {
                let start = rest.find(&format!("pub fn {function}(")).unwrap();
                let body = start + rest[start..].find("{\n").unwrap() + 2;
                rest.insert_str(body, "    attack();\n");
            }
            Place::InsteadOf(functions) => {
                for function in functions {
                    rest = rest.replace(&format!("pub fn {function}("), &format!("fn right_{function}("));
                }
            }
            Place::Beside | Place::Alone => {}
        }
        // What is long comes last: nothing is looked for in it.
        lengthen(&fill(&self.code, names)) + &rest
    }
}

/// Puts `names` in place of the words between `@`.
pub fn fill(text: &str, names: &BTreeMap<&str, String>) -> String {
    names.iter().fold(text.to_owned(), |text, (name, value)| text.replace(&format!("@{name}@"), value))
}

/// `@REPEAT 3 ab@` is `ababab`; `@CHAR 202E@` is the letter with this number.
fn lengthen(code: &str) -> String {
    let mut long = String::new();
    let mut rest = code;
    while let Some((before, command, after)) = command(rest) {
        long.push_str(before);
        long.push_str(&command);
        rest = after;
    }
    long + rest
}

fn command(text: &str) -> Option<(&str, String, &str)> {
    let at = [text.find("@REPEAT "), text.find("@CHAR ")].into_iter().flatten().min()?;
    let (before, text) = (&text[..at], &text[at + 1..]);
    let (command, after) = text.split_once('@').unwrap();
    let (word, what) = command.split_once(' ').unwrap();
    let result = if word == "CHAR" {
        char::from_u32(u32::from_str_radix(what, 16).unwrap()).unwrap().to_string()
    } else {
        let (count, what) = what.split_once(' ').unwrap();
        what.replace("\\n", "\n").repeat(count.parse().unwrap())
    };
    Some((before, result, after))
}
