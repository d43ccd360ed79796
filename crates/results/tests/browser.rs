//! The report in a real browser: it sorts, searches and opens; nothing that a student is called runs; nothing is wider than a phone.
//!
//! It needs Chromium, and is run by `cargo test -p results --test browser -- --ignored`.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use common::{groups, records, run, write, write_class};
use results::Options;
use serde_json::Value;

/// Runs in a copy of the page that lets it: the page itself runs nothing but its own script.
const ACTIONS: &str = r#"
addEventListener("load", () => {
  const result = {};
  const table = document.getElementById("all");
  const names = () => [...table.tBodies].map((body) => body.querySelector("button.open").textContent);
  const cells = (column) => [...table.tBodies].map((body) => body.rows[0].cells[column].textContent.trim());
  const head = (column) => table.tHead.rows[0].cells[column];
  const search = (text) => {
    const input = document.getElementById("search");
    input.value = text;
    input.dispatchEvent(new Event("input"));
  };
  result.all = names();
  head(1).querySelector("button").click();
  result.points_down = cells(1);
  result.points_sort = head(1).getAttribute("aria-sort");
  head(1).querySelector("button").click();
  result.points_up = cells(1);
  head(0).querySelector("button").click();
  result.names_up = names();
  result.other_sort = head(1).getAttribute("aria-sort");
  search("WEI li");
  result.found = names();
  result.shown = document.getElementById("shown").textContent;
  search("angstrom");
  result.found_without_marks = names();
  search("no such student");
  result.found_none = names();
  search("");
  const filter = document.getElementById("filter");
  result.filters = [...filter.options].map((option) => option.textContent);
  filter.value = "does-not-compile";
  filter.dispatchEvent(new Event("change"));
  result.filtered = [...table.tBodies].map((body) => body.id);
  filter.value = "";
  filter.dispatchEvent(new Event("change"));
  document.querySelector("button.find").click();
  result.with_misconception = [...table.tBodies].map((body) => body.id);
  search("");
  for (const button of table.querySelectorAll("button.open")) button.click();
  result.open = [...table.querySelectorAll("tr.details")].filter((row) => !row.hidden).length;
  result.details = document.getElementById("d-300000003").textContent;
  result.images = document.images.length;
  result.scripts = document.scripts.length;
  result.title = document.title;
  result.focusable = [...table.tHead.querySelectorAll("button")].every((button) => button.tabIndex === 0);
  const outcome = document.createElement("pre");
  outcome.id = "outcome";
  outcome.textContent = "BEGIN" + JSON.stringify(result) + "END";
  document.body.append(outcome);
});
"#;

#[test]
#[ignore = "needs Chromium"]
fn sorts_searches_filters_and_opens() {
    let folder = report();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    let result = act(folder.path(), &page, ACTIONS);
    let list = |name: &str| -> Vec<String> {
        let values = result[name].as_array().unwrap().iter();
        values.map(|value| value.as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(list("all").len(), 8);
    let points = |name| -> Vec<String> {
        list(name)
            .iter()
            .map(|cell| cell.split(|c: char| !c.is_ascii_digit()).next().unwrap().into())
            .collect()
    };
    // A mark that does not exist is less than none.
    assert_eq!(points("points_down"), ["15", "12", "11", "10", "0", "0", "0", ""]);
    assert_eq!(points("points_up"), ["", "0", "0", "0", "10", "11", "12", "15"]);
    assert_eq!(result["points_sort"], "descending");
    assert_eq!(result["other_sort"], "none");
    let names = list("names_up");
    let place = |name: &str| names.iter().position(|found| found.contains(name)).unwrap();
    assert!(place("Li Wei") < place("TerryFox") && place("TerryFox") < place("Zoë"), "{names:?}");
    assert_eq!(list("found"), ["Li Wei", "Li Wei"]);
    assert_eq!(result["shown"], "2 of 8 students");
    assert_eq!(list("found_without_marks"), ["Zoë Ångström-O'Neill"]);
    assert!(list("found_none").is_empty());
    assert!(list("filters").contains(&"does not compile (1)".to_owned()), "{result}");
    assert_eq!(list("filtered"), ["r-300000004"]);
    assert_eq!(list("with_misconception"), ["r-300000002"]);
    assert_eq!(result["open"], 8);
    assert!(result["details"].as_str().unwrap().contains("the secret input is 815.25"), "{result}");
    // The page's own script, and the one of this test.
    assert_eq!(result["scripts"], 2);
    assert_eq!(result["images"], 0);
    assert_eq!(result["title"], "Forward kinematics: results");
    assert_eq!(result["focusable"], true);
}

#[test]
#[ignore = "needs Chromium"]
fn runs_nothing_but_its_own_script_and_says_nothing_to_the_console() {
    let folder = report();
    let path = folder.path().join("report.html");
    let (dom, console) = dump(&path, 1280);
    assert!(console.is_empty(), "{console:?}");
    assert!(dom.contains("<title>Forward kinematics: results</title>"), "{}", &dom[..1000]);
    assert!(dom.contains("<html lang=\"en\" class=\"js\">"), "the page's own script did not run");
    let (_, console) = dump(&frames(folder.path(), &feedback(folder.path())), 1280);
    assert!(console.is_empty(), "{console:?}");

    // What would happen if a name were not escaped: the browser refuses it, and this test sees that it does.
    let page = fs::read_to_string(&path).unwrap();
    let forged = page.replace("</body>", "<script>document.title='owned'</script></body>");
    fs::write(&path, forged).unwrap();
    let (dom, console) = dump(&path, 1280);
    assert!(dom.contains("<title>Forward kinematics: results</title>"), "a foreign script ran");
    assert!(console.iter().any(|line| line.contains("Content Security Policy")), "{console:?}");
}

#[test]
#[ignore = "needs Chromium"]
fn is_never_wider_than_a_phone() {
    let folder = report();
    let open_all = r#"addEventListener("load", () => {
        for (const button of document.querySelectorAll("button.open")) button.click();
        for (const details of document.querySelectorAll("details")) details.open = true;
    });"#;
    let report = fs::read_to_string(folder.path().join("report.html")).unwrap();
    fs::write(folder.path().join("open.html"), with_script(&report, open_all)).unwrap();
    let mut names = feedback(folder.path());
    names.extend(["report.html".to_owned(), "open.html".to_owned()]);
    let widths = widths_on_a_phone(folder.path(), &names);
    assert_eq!(widths, vec![375; names.len()], "{names:?}");
    // A page that is too wide would be found.
    let wide = report.replace("</body>", "<p><svg width=\"400\" height=\"9\"></svg></p></body>");
    fs::write(folder.path().join("wide.html"), with_script(&wide, "")).unwrap();
    assert!(widths_on_a_phone(folder.path(), &["wide.html".to_owned()])[0] > 375);
}

#[test]
#[ignore = "needs Chromium"]
fn stays_usable_with_ten_thousand_students() {
    let folder = tempfile::tempdir().unwrap();
    write_class(folder.path(), 10_000, &Options::default());
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    let result = act(
        folder.path(),
        &page,
        r#"addEventListener("load", () => {
            const table = document.getElementById("all");
            const result = { elements: document.getElementsByTagName("*").length, bodies: table.tBodies.length };
            table.tHead.querySelectorAll("button")[1].click();
            const search = document.getElementById("search");
            search.value = "300009999";
            search.dispatchEvent(new Event("input"));
            result.found = [...table.tBodies].map((body) => body.id);
            const outcome = document.createElement("pre");
            outcome.textContent = "BEGIN" + JSON.stringify(result) + "END";
            document.body.append(outcome);
        });"#,
    );
    // What is laid out does not grow with the class.
    assert_eq!(result["bodies"], 200);
    assert!(result["elements"].as_u64().unwrap() < 30_000, "{result}");
    assert_eq!(result["found"][0], "r-300009999");
}

/// A report with the nastiest names as they are, without a roster's names in their place.
fn report() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), &run(), &records(), &Options { groups: groups(), ..Options::default() }).unwrap();
    folder
}

/// What a script finds in a copy of the page, which it writes between BEGIN and END.
fn act(folder: &Path, page: &str, script: &str) -> Value {
    let path = folder.join("acted.html");
    fs::write(&path, with_script(page, script)).unwrap();
    let (dom, console) = dump(&path, 1280);
    assert!(console.is_empty(), "{console:?}");
    let result =
        dom.rsplit_once("BEGIN").and_then(|(_, rest)| rest.split_once("END")).map(|(result, _)| result);
    let result = result.unwrap_or_else(|| panic!("the script did not come to its end"));
    let result = result.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    serde_json::from_str(&result).unwrap()
}

/// The page with one more script and without the policy that forbids it.
fn with_script(page: &str, script: &str) -> String {
    let (before, rest) = page.split_once("<meta http-equiv=\"Content-Security-Policy\"").unwrap();
    let (_, after) = rest.split_once('>').unwrap();
    format!("{before}{after}<script>{script}</script>")
}

/// The feedback's pages.
fn feedback(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder.join("feedback")).unwrap();
    let names = names.map(|entry| format!("feedback/{}", entry.unwrap().file_name().into_string().unwrap()));
    names.filter(|name| name.ends_with(".html")).collect()
}

/// How wide pages are in a window of 375 pixels. A browser's own window is never that narrow, a frame can be.
fn widths_on_a_phone(folder: &Path, names: &[String]) -> Vec<u64> {
    let (dom, _) = dump(&frames(folder, names), 800);
    let (_, rest) = dom.rsplit_once("BEGIN").unwrap();
    serde_json::from_str(rest.split_once("END").unwrap().0).unwrap()
}

/// A page with others in frames as wide as a phone, which says how wide each would be.
fn frames(folder: &Path, names: &[String]) -> PathBuf {
    let frame =
        |name: &String| format!("<iframe src='{name}' width='375' height='800' style='border:0'></iframe>");
    let frames: String = names.iter().map(frame).collect();
    let script = r#"addEventListener("load", () => {
        const width = (frame) => frame.contentDocument.scrollingElement.scrollWidth;
        document.body.append("BEGIN" + JSON.stringify([...document.querySelectorAll("iframe")].map(width)) + "END");
    });"#;
    let path = folder.join("frames.html");
    fs::write(&path, format!("<!DOCTYPE html><body>{frames}<script>{script}</script></body>")).unwrap();
    path
}

/// The page after its scripts have run, and what they said to the console.
fn dump(path: &Path, width: u32) -> (String, Vec<String>) {
    let profile = tempfile::tempdir().unwrap();
    let output = Command::new(browser())
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"])
        .args(["--enable-logging=stderr", "--allow-file-access-from-files", "--virtual-time-budget=20000"])
        .arg(format!("--window-size={width},1000"))
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg("--dump-dom")
        .arg(format!("file://{}", path.display()))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8_lossy(&output.stderr);
    let console = said.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect();
    (String::from_utf8(output.stdout).unwrap(), console)
}

fn browser() -> PathBuf {
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    let folders = env::split_paths(&env::var_os("PATH").unwrap_or_default()).collect::<Vec<_>>();
    let all = names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    all.into_iter().find(|path| path.is_file()).unwrap_or_else(|| {
        panic!("NOT TESTED: no Chromium here, so nobody has looked at report.html; install the package `chromium`")
    })
}
