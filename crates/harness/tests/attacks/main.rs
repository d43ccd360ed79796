//! All attacks of `tests/hostile` at once, among innocent submissions.
//!
//! A few of them run in every test; all of them, in every mode that the machine has, with `--ignored`.
#![allow(clippy::unwrap_used)] // Without libtest's harness clippy does not see that these are tests.

#[cfg(target_os = "linux")]
mod broken;
#[cfg(target_os = "linux")]
mod corpus;
#[cfg(target_os = "linux")]
mod evening;
#[cfg(target_os = "linux")]
mod expected;
#[cfg(target_os = "linux")]
mod hard_coded;
#[cfg(target_os = "linux")]
mod modes;
#[cfg(target_os = "linux")]
mod planted;
#[cfg(target_os = "linux")]
mod table;
#[cfg(target_os = "linux")]
mod undertaker;
#[cfg(target_os = "linux")]
mod zip;

#[cfg(not(target_os = "linux"))]
fn main() {
    println!("NOT RUN: only Linux has a sandbox, and attacks are only let loose in one");
}

#[cfg(target_os = "linux")]
fn main() {
    use libtest_mimic::{Arguments, Failed, Trial};
    use modes::Mode;

    undertaker::work_if_asked();
    modes::become_refused_if_asked();
    let mut arguments = Arguments::from_args();
    // One evening at a time: what it leaves behind is told by what is new.
    arguments.test_threads = Some(1);
    let test = |name: &str, test: fn() -> Result<(), Failed>| Trial::test(name.to_owned(), test);
    let mut trials = vec![
        test("table", table_is_as_the_heads_say),
        test("a_few", || evening::attacked(Mode::PLAIN, evening::Size::Few)),
        test("a_few_unprotected", || evening::unprotected(evening::Size::Few)),
        test("all_unprotected", || evening::unprotected(evening::Size::All)).with_ignored_flag(true),
        test("answers_by_heart", evening::answers_by_heart),
    ];
    for (name, mode) in Mode::ALL {
        let all = move || evening::attacked(mode, evening::Size::All);
        trials.push(Trial::test(format!("all_{name}"), all).with_ignored_flag(true));
    }
    libtest_mimic::run(&arguments, trials).exit();
}

#[cfg(target_os = "linux")]
fn table_is_as_the_heads_say() -> Result<(), libtest_mimic::Failed> {
    let path = corpus::folder().join("README.md");
    let table = table::table(&corpus::attacks(), &broken::broken());
    if std::env::var_os("FK_LAB_BLESS").is_some() {
        std::fs::write(&path, &table).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    if written == table {
        Ok(())
    } else {
        Err("tests/hostile/README.md is not as the heads say: FK_LAB_BLESS=1 writes it anew".into())
    }
}
