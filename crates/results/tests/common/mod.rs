//! A small run with every verdict in it and the nastiest names.
#![allow(dead_code, clippy::unwrap_used)] // Not every test uses everything.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use results::{
    CheckInfo, CheckResult, CheckState, CompileError, Error, Group, Lms, Named, Options, PartInfo,
    PartResult, PartState, Picture, Record, RunInfo, SCHEMA, Student, Summary, Verdict, Whole, write_all,
};

pub fn run() -> RunInfo {
    let check = |id: &str, title: &str, points| CheckInfo { id: id.into(), title: title.into(), points };
    let part = |id: &str, function: &str, title: &str, checks: Vec<CheckInfo>| PartInfo {
        id: id.into(),
        function: function.into(),
        title: title.into(),
        points: checks.iter().map(|check| check.points).sum(),
        checks,
    };
    let map = |pairs: &[(&str, &str)]| -> BTreeMap<String, String> {
        pairs.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
    };
    RunInfo {
        schema: SCHEMA,
        exercise: "fk".into(),
        title: "Forward kinematics".into(),
        parts: vec![
            part(
                "part1",
                "local_quaternion",
                "local quaternion",
                vec![
                    check("single_axes", "one angle, the others zero", 1),
                    check("rotation_orders", "three angles, in each of the six rotation orders", 2),
                    check("big_angles", "angles beyond 180 degrees, of either sign", 1),
                    check("cursor", "each joint takes its own angles from the frame, and NONE takes none", 1),
                ],
            ),
            part(
                "part2",
                "global_quaternion",
                "global quaternion",
                vec![
                    check("root", "a root, which has no parent", 1),
                    check("parent", "a joint and its parent", 2),
                    check("branch", "a joint at a branch: the joint before it is not its parent", 1),
                    check("chain", "joints and End Sites far down a chain", 1),
                ],
            ),
            part(
                "part3",
                "global_position",
                "global position",
                vec![
                    check("root", "a root, which the frame moves", 1),
                    check("parent", "a joint or an End Site and its parent", 2),
                    check("branch", "a joint at a branch: the joint before it is not its parent", 1),
                    check("own_position", "a joint with position channels of its own", 1),
                ],
            ),
        ],
        seed: 12_345_678_901_234_567_890,
        versions: map(&[("fk-lab", "0.1.0"), ("rustc", "1.95.0")]),
        limits: map(&[("memory", "512 MiB"), ("time for a check", "10 s")]),
        sandbox: "namespaces, Landlock, seccomp, limits".into(),
        sandboxed: true,
        shard: None,
        reference_picture: Some(figure(|point| point)),
    }
}

/// A runner, each point changed.
pub fn figure(change: impl Fn([f32; 3]) -> [f32; 3]) -> Picture {
    let points = [
        [0.0, 90.0, 0.0],
        [0.0, 115.0, 4.0],
        [0.0, 142.0, 8.0],
        [0.0, 165.0, 10.0],
        [18.0, 138.0, 6.0],
        [30.0, 115.0, 22.0],
        [24.0, 112.0, 48.0],
        [-18.0, 138.0, 6.0],
        [-30.0, 114.0, -14.0],
        [-26.0, 92.0, 2.0],
        [10.0, 86.0, 0.0],
        [12.0, 52.0, 26.0],
        [12.0, 16.0, 4.0],
        [12.0, 8.0, 22.0],
        [-10.0, 86.0, 0.0],
        [-12.0, 48.0, -16.0],
        [-12.0, 26.0, -48.0],
        [-12.0, 12.0, -40.0],
    ];
    let bones = [
        (0, 1),
        (1, 2),
        (2, 3),
        (2, 4),
        (4, 5),
        (5, 6),
        (2, 7),
        (7, 8),
        (8, 9),
        (0, 10),
        (10, 11),
        (11, 12),
        (12, 13),
        (0, 14),
        (14, 15),
        (15, 16),
        (16, 17),
    ];
    Picture { points: points.map(change).to_vec(), bones: bones.to_vec() }
}

pub const NASTY: &str = "</script><script>document.title='owned'</script>\"'&<img src=x onerror=alert(1)>";
pub const FORMULA: &str = "=cmd|'/C calc'!A0";

/// All verdicts, in the order of the ids.
pub fn records() -> Vec<Record> {
    vec![
        record("300000001_TerryFox", Some("300000001"), "TerryFox", graded([5, 5, 5], PartState::Right, figure(|p| p))),
        Record {
            lms: Lms::Canvas { user_id: "4711".into() },
            marked_late: true,
            remarks: vec!["The file was read as Latin-1.".into()],
            ..record("300000002", Some("300000002"), NASTY, reversed())
        },
        record("300000003", Some("300000003"), FORMULA, panicked()),
        record(
            "300000004",
            Some("300000004"),
            "محمد \u{202e}عبد",
            Verdict::DoesNotCompile {
                errors: vec![CompileError {
                    message: "mismatched types".into(),
                    line: Some(42),
                    column: Some(5),
                    text: "error[E0308]: mismatched types\n  --> fk.rs:42:5\n   |\n42 |     \u{1b}[31m\"```</pre>\"\u{202e}\n   |     ^^^ expected `Quat`, found `&str`\n".into(),
                }],
                left_out: 3,
            },
        ),
        record(
            "300000005",
            Some("300000005"),
            "Zoë Ångström-O'Neill",
            Verdict::TooExpensiveToCompile { limit: "20 seconds".into(), text: "warning: long running `const`".into() },
        ),
        record(
            "300000006-a",
            Some("300000006"),
            "Li Wei",
            Verdict::Rejected { code: "two-files".into(), why: "The archive holds two files `fk.rs`: a/fk.rs and b/fk.rs.".into() },
        ),
        record("300000006-b", Some("300000006"), "Li Wei", graded([5, 0, 5], PartState::NotStarted, figure(|[x, y, z]| [x, y * f32::NAN, z]))),
        Record {
            lms: Lms::Moodle { participant_id: "815".into() },
            ..record("nobody-knows", None, "", Verdict::HarnessError { what: "the sandbox did not start: /var/lib/fk-lab/slot-3 is full".into() })
        },
    ]
}

pub fn record(id: &str, number: Option<&str>, name: &str, verdict: Verdict) -> Record {
    Record {
        id: id.into(),
        student: Student { number: number.map(str::to_owned), name: name.into() },
        lms: Lms::None,
        file: format!("{id}-upload.zip"),
        sha256: Some("9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08".into()),
        marked_late: false,
        remarks: Vec::new(),
        sandbox: "namespaces, Landlock, seccomp, limits".into(),
        verdict,
    }
}

/// Parts with all points or none.
pub fn graded(points: [u32; 3], otherwise: PartState, picture: Picture) -> Verdict {
    let run = run();
    let parts = run.parts.iter().zip(points).map(|(info, points)| {
        let right = points == info.points;
        let check = |check: &CheckInfo| CheckResult {
            id: check.id.clone(),
            points: if right { check.points } else { 0 },
            of: check.points,
            state: if right { CheckState::Right } else { CheckState::Wrong },
            note: String::new(),
            private_note: String::new(),
        };
        PartResult {
            id: info.id.clone(),
            points,
            of: info.points,
            state: if right { PartState::Right } else { otherwise },
            checks: info.checks.iter().map(check).collect(),
            named: Vec::new(),
            remark: None,
        }
    });
    let right = points == [5, 5, 5];
    let note = if right {
        ""
    } else {
        "LeftFoot is off by 12.3 cm in frame 100; the first wrong joint is LeftUpLeg"
    };
    let whole = Some(Whole { frames: 240, right, note: note.into() });
    Verdict::Graded { parts: parts.collect(), whole, picture: Some(picture) }
}

pub fn reversed() -> Verdict {
    let mut verdict =
        graded([5, 5, 5], PartState::Right, figure(|[x, y, z]| [x + y * 0.2, y * 0.9, z - 20.0]));
    if let Verdict::Graded { parts, whole, .. } = &mut verdict {
        let part = &mut parts[0];
        part.points = 2;
        part.state = PartState::PartlyRight;
        for index in [1, 2] {
            part.checks[index].points = 0;
            part.checks[index].state = CheckState::Wrong;
            part.checks[index].note = "11 of 14 cases are wrong; only these are wrong: ZYX, YZX, ZXY".into();
            part.checks[index].private_note = format!("angles 310.5, -12.25, 77 in ZYX for {NASTY}");
        }
        part.named.push(Named {
            id: "order_reversed".into(),
            title: "Your order is reversed.".into(),
            explanation: "The angles are about the joint's own axes, so that the first angle's quaternion stands leftmost: `a * b * c`.".into(),
            hint: "Multiply in the order in which `joint.rotation_order` names the axes.".into(),
        });
        parts[1].remark = Some("You use 3.14 for π. That is near enough, and `to_radians` is nearer.".into());
        *whole =
            Some(Whole { frames: 240, right: false, note: "LeftFoot is off by 12.3 cm in frame 100".into() });
    }
    verdict
}

pub fn panicked() -> Verdict {
    let mut verdict = graded([5, 5, 0], PartState::Panicked, figure(|[x, y, z]| [x * 1e30, y * 3e38, z]));
    if let Verdict::Graded { parts, .. } = &mut verdict {
        parts[2].points = 1;
        parts[2].state = PartState::PartlyRight;
        parts[2].checks[0] =
            CheckResult { points: 1, state: CheckState::Right, ..parts[2].checks[0].clone() };
        parts[2].checks[1].state = CheckState::Stopped;
        parts[2].checks[1].note = "your code panicked at exercises/fk/src/fk.rs:12:5".into();
        parts[2].checks[1].private_note = "index out of bounds: \u{7} the secret input is 815.25".into();
    }
    verdict
}

/// Two that are alike, and one that nobody knows.
pub fn groups() -> Vec<Group> {
    let ids = ["300000001_TerryFox", "300000002", "gone"].map(str::to_owned).to_vec();
    vec![Group { ids, similarity: 0.974, kind: "the same but for names and comments".into() }]
}

pub fn write(out: &Path, run: &RunInfo, records: &[Record], options: &Options) -> Result<Summary, Error> {
    write_all(out, run, &|| Ok(Box::new(records.iter().cloned().map(io::Result::Ok))), options)
}

/// A plausible class, one record at a time: the same for the same index.
pub fn student(index: usize) -> Record {
    const FIRST: [&str; 12] =
        ["Ada", "Björn", "Chidi", "Dana", "Élodie", "Farid", "Grace", "Hana", "Ivo", "Júlia", "Kofi", "Lin"];
    const LAST: [&str; 11] = [
        "Okafor",
        "Lindqvist",
        "Moreau",
        "Tanaka",
        "Novák",
        "Haddad",
        "Silva",
        "Kowalski",
        "Chen",
        "O'Brien",
        "Yılmaz",
    ];
    let (number, name) = (300_000_000 + index, format!("{} {}", FIRST[index % 12], LAST[index % 11]));
    let bend = (index % 7) as f32 * 4.0;
    let picture = || figure(|[x, y, z]| [x + bend * (y / 90.0), y - bend, z + bend]);
    let verdict = match index % 19 {
        3 => reversed(),
        7 => panicked(),
        9 => graded([5, 5, 0], PartState::Wrong, picture()),
        11 => graded([5, 0, 0], PartState::NotStarted, picture()),
        13 => graded([0, 5, 5], PartState::TimedOut, picture()),
        17 if index.is_multiple_of(2) => records()[3].verdict.clone(),
        18 if index.is_multiple_of(5) => Verdict::HarnessError { what: "no space left".into() },
        _ => graded([5, 5, 5], PartState::Right, figure(|point| point)),
    };
    record(&format!("{number}"), Some(&number.to_string()), &name, verdict)
}

pub fn write_class(out: &Path, count: usize, options: &Options) -> Summary {
    let run = run();
    write_all(out, &run, &|| Ok(Box::new((0..count).map(|index| Ok(student(index))))), options).unwrap()
}
