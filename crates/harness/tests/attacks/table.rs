//! The table of all attacks, for people.

use std::fmt::Write;

use crate::broken::Broken;
use crate::corpus::Attack;

/// `tests/hostile/README.md`.
pub fn table(attacks: &[Attack], broken: &[Broken]) -> String {
    let mut text = String::from(HEAD);
    for (kind, title, words) in KINDS {
        let of_kind: Vec<&Attack> = attacks.iter().filter(|attack| attack.name.starts_with(kind)).collect();
        write!(text, "\n## {title}\n\n{words}\n\n| file | what it tries | verdict |\n|---|---|---|\n")
            .unwrap();
        for attack in of_kind {
            let file = attack.name.trim_start_matches(kind);
            let mut verdict = code(attack.expect.text());
            if let Some(other) = &attack.without_namespaces {
                write!(verdict, "; without namespaces {}", code(other.text())).unwrap();
            }
            writeln!(text, "| [{file}]({}.rs) | {} | {verdict} |", attack.name, cell(&attack.text)).unwrap();
        }
    }
    write!(text, "\n## Files, archives and names\n\nThese are made by `tests/attacks/broken.rs`: no tool would write them.\n\n| name | what is odd about it | verdict |\n|---|---|---|\n").unwrap();
    for one in broken {
        writeln!(text, "| {} | {} | {} |", code(&shown(&one.name)), cell(one.text), code(one.expect.text()))
            .unwrap();
    }
    text + TAIL
}

const HEAD: &str = "# Hostile and broken submissions

Each must get its verdict, and may do nothing else: change no file, leave no process, read no secret, reach no service, delay the
others by no more than its limits, change nobody's points. `tests/attacks/main.rs` hands all of them in together, among innocent
ones, and looks.

A file's head says what it tries and what must become of it. Those with `unprotected` are also run without the sandbox, where they
must succeed: what cannot succeed would prove nothing.

This table is made from the heads: `FK_LAB_BLESS=1 cargo test -p harness --test attacks table` writes it.
";

const KINDS: [(&str, &str, &str); 3] = [
    (
        "compile/",
        "At compile time",
        "These stand beside the right solution, unless their head says otherwise.",
    ),
    (
        "run/",
        "At run time",
        "The right solution calls `attack` first thing in `local_quaternion`: an attack that comes to nothing gets all points.",
    ),
    (
        "raw/",
        "By system calls",
        "The same, past the compiler: unsafe code is forbidden, but the compiler has a known hole. Only for x86-64.",
    ),
];

const TAIL: &str = "
One more is made from the questions of the public seed: it knows their answers by heart. With any other seed it gets nearly nothing.
";

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn code(text: &str) -> String {
    format!("`{}`", cell(text))
}

fn shown(name: &str) -> String {
    let name: String = name
        .chars()
        .take(60)
        .flat_map(|c| {
            if c.is_ascii_graphic() || c == ' ' || c.is_alphabetic() {
                vec![c]
            } else {
                c.escape_default().collect()
            }
        })
        .collect();
    name.replace('`', "'")
}
