//! The book says what is true: its tables come from the rubric, its signatures from the solution, its links lead
//! somewhere, its commands exist. `FK_LAB_BLESS=1 cargo test -p grading --test book` writes the tables again.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

use glam::{Quat, Vec3};
use grading::{EXERCISES, Exercise, checks_table, misconceptions_table, rubric_table};
use parser::acclaim;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use skeleton::acclaim::{Bone, BoneId};

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The chapters, the README and other texts, by their path from the workspace's root.
fn texts() -> BTreeMap<String, String> {
    let mut texts = BTreeMap::new();
    for folder in ["", "docs", "data"] {
        for entry in fs::read_dir(workspace().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "md") {
                let name = Path::new(folder).join(path.file_name().unwrap());
                texts.insert(name.to_str().unwrap().replace('\\', "/"), fs::read_to_string(path).unwrap());
            }
        }
    }
    texts
}

#[test]
fn tables_come_from_the_rubric() {
    for Exercise { rubric, misconceptions, .. } in &EXERCISES {
        let (points, checks) = (rubric_table(rubric), checks_table(rubric));
        let all = rubric.parts.iter().map(|part| (part, misconceptions(part.id)));
        let mistakes = misconceptions_table(all);
        let name = rubric.exercise;
        for (file, place, table) in [
            (format!("docs/{name}.md"), "rubric".to_owned(), &points),
            ("docs/marking.md".to_owned(), format!("{name} rubric"), &checks),
            ("docs/marking.md".to_owned(), format!("{name} misconceptions"), &mistakes),
        ] {
            check_table(&file, &place, table);
        }
    }
}

/// Between two comments in `file` stands this table.
fn check_table(file: &str, place: &str, table: &str) {
    let path = workspace().join(file);
    let text = fs::read_to_string(&path).unwrap();
    let (begin, end) = (format!("<!-- {place}: begin -->\n"), format!("<!-- {place}: end -->"));
    let from = text.find(&begin).unwrap() + begin.len();
    let to = text.find(&end).unwrap();
    if env::var_os("FK_LAB_BLESS").is_some() {
        // Other tests read these files at the same time.
        if &text[from..to] == table {
            return;
        }
        fs::write(&path, format!("{}{table}{}", &text[..from], &text[to..])).unwrap();
    } else {
        assert_eq!(&text[from..to], table, "{file}");
    }
}

/// The source of an exercise's solution.
fn solution(exercise: &str) -> String {
    fs::read_to_string(workspace().join(format!("solutions/src/{}.rs", exercise.replace('-', "_")))).unwrap()
}

#[test]
fn signatures_are_the_solutions() {
    for Exercise { rubric, .. } in &EXERCISES {
        let solution = solution(rubric.exercise);
        let chapter = &texts()[&format!("docs/{}.md", rubric.exercise)];
        let blocks = code_blocks(chapter);
        let signatures: Vec<_> = blocks.iter().filter(|(kind, _)| kind == "rust,ignore").collect();
        assert_eq!(signatures.len(), 3, "{}", rubric.exercise);
        for (_, signature) in signatures {
            assert!(solution.contains(&format!("{} {{", signature.trim_end())), "{signature}");
        }
    }
}

#[test]
fn points_in_the_students_files_are_the_rubrics() {
    for Exercise { rubric, .. } in &EXERCISES {
        let solution = solution(rubric.exercise);
        for (number, part) in (1..).zip(rubric.parts) {
            let heading = format!("/// Part {number} ({} points): ", part.points());
            assert!(solution.contains(&heading), "there is no {heading:?} in the solution");
        }
    }
}

#[test]
fn the_motion_file_in_the_handout_can_be_read() {
    let chapter = &texts()["docs/fk.md"];
    let blocks = code_blocks(chapter);
    let block = |begin: &str| blocks.iter().find(|(_, code)| code.starts_with(begin)).unwrap().1.clone();
    let file = block("HIERARCHY") + &block("MOTION").replace("Frames: 1377", "Frames: 1");
    let reading = parser::bvh::read(file.as_bytes()).unwrap();
    assert!(reading.warnings.is_empty(), "{:?}", reading.warnings);
    assert_eq!(reading.motion.frame_count(), 1);
    assert_eq!(reading.motion.skeleton().len(), 4);
}

/// What the page says of its two files, and what it asks about them without giving the answer.
#[test]
fn the_files_of_bones_in_the_handout_can_be_read_and_are_what_the_page_says() {
    let chapter = &texts()["docs/acclaim.md"];
    let blocks = code_blocks(chapter);
    let block = |begin: &str| blocks.iter().find(|(_, code)| code.contains(begin)).unwrap().1.clone();
    let read = acclaim::read_skeleton(block(":version").as_bytes()).unwrap();
    assert!(read.warnings.is_empty(), "{:?}", read.warnings);
    let skeleton = read.skeleton;
    let bone = |name: &str| skeleton.find(name).unwrap();
    let names =
        |bones: &mut dyn Iterator<Item = &Bone>| bones.map(|bone| bone.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&mut skeleton.children(BoneId::ROOT)), ["lfemur", "lowerback"]);
    assert_eq!(names(&mut skeleton.children(bone("lfemur").id)), ["ltibia"]);

    // "The leg of the figure above points down and 15° outwards", and so do the axes of both bones.
    let turned = |rotation: Quat, degrees: f32| {
        let right = Quat::from_rotation_z(degrees.to_radians());
        grading::fk::angle_between(rotation, right) < 0.01
    };
    for leg in ["lfemur", "ltibia"] {
        let leg = bone(leg);
        assert!((leg.direction.angle_between(Vec3::NEG_Y).to_degrees() - 15.0).abs() < 0.01);
        assert!(turned(leg.axis_rotation, 15.0));
        assert!(leg.local_direction.abs_diff_eq(Vec3::NEG_Y, 1e-4), "{}", leg.local_direction);
    }
    assert!(turned(bone("lfemur").rot_parent_current, 15.0));
    assert!(turned(bone("ltibia").rot_parent_current, 0.0));
    // "The knee turns about X only, and the back of this small figure does not turn at all."
    let dofs = |name: &str| bone(name).dofs.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!((dofs("ltibia"), dofs("lowerback").len()), (vec!["rx".to_owned()], 0));

    let read = acclaim::read_motion(block(":FULLY-SPECIFIED").as_bytes(), &skeleton).unwrap();
    assert!(read.warnings.is_empty(), "{:?}", read.warnings);
    assert_eq!(read.motion.frame_count(), 1);
    let posture = read.motion.posture(0);
    assert_eq!(posture.angles[bone("ltibia").id.0], [35.1, 0.0, 0.0]);
    assert_eq!(posture.translations[0], Vec3::new(10.5, 88.2, -3.4));
}

#[test]
fn every_link_and_picture_leads_somewhere() {
    let texts = texts();
    let mut checked = 0;
    for (file, text) in &texts {
        let folder = workspace().join(file).parent().unwrap().to_owned();
        for link in links(text) {
            if link.starts_with("https://") {
                continue;
            }
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if path.is_empty() { workspace().join(file) } else { folder.join(path) };
            assert!(target.exists(), "{file}: {link} leads nowhere");
            if !anchor.is_empty() {
                let anchors = anchors(&fs::read_to_string(&target).unwrap());
                assert!(anchors.iter().any(|known| known == anchor), "{file}: {link}: no such heading");
            }
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}

#[test]
fn every_chapter_is_in_the_summary() {
    let texts = texts();
    let listed: Vec<String> = links(&texts["docs/SUMMARY.md"]);
    for file in
        texts.keys().filter_map(|file| file.strip_prefix("docs/")).filter(|file| *file != "SUMMARY.md")
    {
        assert!(listed.iter().any(|link| link == file), "docs/{file} is not in docs/SUMMARY.md");
    }
}

#[test]
fn every_command_exists() {
    let config = fs::read_to_string(workspace().join(".cargo/config.toml")).unwrap();
    let aliases = config.lines().filter_map(|line| line.split_once(" = ")).map(|(alias, _)| alias);
    let known: Vec<&str> = aliases.chain(["test", "bench"]).collect();
    let mut checked = 0;
    for (file, text) in texts() {
        for (_, code) in code_blocks(&text).into_iter().filter(|(kind, _)| kind == "sh") {
            for line in code.lines() {
                let words: Vec<&str> =
                    line.split_whitespace().skip_while(|word| word.contains('=')).collect();
                let known = words[0] != "cargo" || known.contains(&words[1]);
                assert!(known, "{file}: there is no {line:?}");
                let package = words.iter().position(|word| *word == "-p").map(|at| words[at + 1]);
                assert!(package.is_none_or(is_package), "{file}: {line:?}: no such package");
                let files = words.iter().filter(|word| word.starts_with("data/"));
                assert!(
                    files.clone().all(|path| workspace().join(path).exists()),
                    "{file}: {line:?}: no such file"
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 8, "{checked}");
}

/// Paths in the running text, written as code, are files or folders of the workspace.
#[test]
fn every_path_exists() {
    let roots = ["crates/", "exercises/", "solutions/", "data/", "docs/", ".ci/", ".cargo/"];
    for (file, text) in texts() {
        for event in events(&text) {
            let Event::Code(code) = event else { continue };
            if roots.iter().any(|root| code.starts_with(root)) && !code.contains(['*', ' ', '…']) {
                assert!(workspace().join(&*code).exists(), "{file}: {code} does not exist");
            }
        }
    }
}

fn is_package(name: &str) -> bool {
    ["crates", "exercises", "."]
        .iter()
        .any(|folder| workspace().join(folder).join(name).join("Cargo.toml").exists())
}

fn events(text: &str) -> impl Iterator<Item = Event<'_>> {
    Parser::new_ext(text, Options::ENABLE_TABLES)
}

fn code_blocks(text: &str) -> Vec<(String, String)> {
    let mut blocks = Vec::new();
    let mut open = None;
    for event in events(text) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(kind))) => {
                open = Some((kind.to_string(), String::new()))
            }
            Event::Text(text) => {
                if let Some((_, code)) = &mut open {
                    code.push_str(&text);
                }
            }
            Event::End(TagEnd::CodeBlock) => blocks.extend(open.take()),
            _ => {}
        }
    }
    blocks
}

fn links(text: &str) -> Vec<String> {
    let target = |event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => Some(dest_url.to_string()),
        _ => None,
    };
    events(text).filter_map(target).collect()
}

/// The headings as links name them: lower case, hyphens for blanks.
fn anchors(text: &str) -> Vec<String> {
    let headings = text.lines().filter_map(|line| line.strip_prefix('#'));
    let anchor = |heading: &str| {
        let heading = heading.trim_start_matches('#').trim().to_lowercase();
        let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
        kept.collect::<String>().replace(' ', "-")
    };
    headings.map(anchor).collect()
}
