//! Reads a folder of motion files and compares the reference solution with poses computed elsewhere.
//!
//! The folder is the workspace's `data/`, or the one that the environment variable `FK_LAB_CORPUS` names, with
//! all folders inside it. In it, next to a motion file `X`, stands
//!
//! - `X.expected.json` (see [`Expected`]): reading must succeed and the poses must agree;
//! - or `X.expected-error`, an empty file: reading must fail with an error that names line and column;
//! - or neither: reading must end in a motion or in such an error. In `data/` no motion may be without poses.
//!
//! What is expected of a file that is not there is an error of the folder.

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use parser::bvh;
use serde::Deserialize;
use skeleton::{Frame, Joint, Motion, Pose, PositionChannels, pose_frame};

/// The farthest a joint may be off, as a part of the skeleton's extent: `f32` along a chain of joints.
const POSITION_TOLERANCE: f64 = 1e-4;

/// The most a joint may be turned too far, in degrees.
const ROTATION_TOLERANCE: f64 = 0.01;

/// What is known of a motion file from elsewhere.
#[derive(Deserialize)]
struct Expected {
    /// Frames in the motion: those declared.
    frames_used: usize,
    channels_per_frame: usize,
    /// As it is written in the file.
    frame_time: String,
    /// In the order of the file.
    nodes: Vec<ExpectedNode>,
    /// Some of the frames.
    frames: Vec<ExpectedFrame>,
}

#[derive(Deserialize)]
struct ExpectedNode {
    /// `root`, `joint` or `end`.
    kind: String,
    /// Empty for an End Site.
    name: String,
    /// −1 for a root.
    parent: i64,
}

#[derive(Deserialize)]
struct ExpectedFrame {
    /// From 0.
    frame: usize,
    /// Where each node is when position channels replace offsets.
    positions: Vec<[f64; 3]>,
    /// Where each node is when position channels add to offsets, if that is elsewhere.
    positions_add: Option<Vec<[f64; 3]>>,
    /// How each node is turned in the world.
    global_quat_wxyz: Vec<[f64; 4]>,
}

/// How far off the worst joint is.
#[derive(Clone, Copy, Default)]
struct Worst {
    /// As a part of the skeleton's extent.
    position: f64,
    /// In degrees.
    rotation: f64,
}

/// What came of one motion file.
enum Verdict {
    /// As expected. `None` where there were no poses to compare.
    Right(Option<Worst>),
    Wrong(String),
    NotReadYet,
}

#[test]
fn corpus_agrees_with_the_reference_solution() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let other_folder = std::env::var_os("FK_LAB_CORPUS").map(PathBuf::from);
    let must_compare = other_folder.is_none();
    let folder = other_folder.unwrap_or(workspace.join("data"));
    let Found { motions: mut files, mut orphans } = find_files(&folder);
    files.sort();
    orphans.sort();

    let (mut right, mut compared, mut unread) = (0, 0, 0);
    let mut failures: Vec<String> = orphans
        .iter()
        .map(|orphan| format!("{}: the motion file that it is about is missing", orphan.display()))
        .collect();
    let mut worst = Worst::default();
    for file in &files {
        match check(file) {
            Verdict::Right(None) if must_compare => {
                failures.push(format!("{}: there are no poses to compare it with", file.display()));
            }
            Verdict::Right(difference) => {
                right += 1;
                compared += usize::from(difference.is_some());
                worst.include(difference.unwrap_or_default());
            }
            Verdict::Wrong(why) => failures.push(format!("{}: {why}", file.display())),
            Verdict::NotReadYet => unread += 1,
        }
    }

    let checked = right + failures.len();
    // Written past the test's own capture: what has not been checked must be seen even if all is well.
    let mut out = std::io::stderr();
    let Worst { position, rotation } = worst;
    let summary = format!(
        "corpus {}: {checked} files checked, {} failed, {compared} compared pose by pose \
         (worst position {position:.1e} of the extent, worst rotation {rotation:.1e} degrees)\n\
         corpus: {unread} Acclaim motions not read yet\n",
        folder.display(),
        failures.len(),
    );
    out.write_all(summary.as_bytes()).expect("stderr can be written");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(compared > 0 || !must_compare, "no motion was compared in {}", folder.display());
    assert!(checked > 0, "no motion file was checked in {}", folder.display());
}

/// What a folder holds.
#[derive(Default)]
struct Found {
    motions: Vec<PathBuf>,
    /// Files that say what is expected of a motion file which is not there.
    orphans: Vec<PathBuf>,
}

fn find_files(folder: &Path) -> Found {
    let mut found = Found::default();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let entry = entry.expect("a folder can be listed");
            let path = entry.path();
            if entry.file_type().expect("an entry has a type").is_dir() {
                folders.push(path);
            } else if has_extension(&path, "bvh") || has_extension(&path, "amc") {
                found.motions.push(path);
            } else if expected_of(&path).is_some_and(|motion| !motion.exists()) {
                found.orphans.push(path);
            }
        }
    }
    found
}

/// `walk.bvh.expected.json` and `walk.bvh.expected-error` give `walk.bvh`.
fn expected_of(path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let motion = [".expected.json", ".expected-error"].into_iter().find_map(|end| name.strip_suffix(end))?;
    Some(path.with_file_name(motion))
}

#[test]
fn expectations_of_missing_files_are_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).expect("a folder");
    for name in ["a.bvh", "a.bvh.expected.json", "b.bvh.expected.json", "c.bvh.expected-error", "notes.md"] {
        fs::write(inner.join(name), "").expect("a file");
    }
    let Found { motions, mut orphans } = find_files(folder.path());
    orphans.sort();
    assert_eq!(motions, [inner.join("a.bvh")]);
    assert_eq!(orphans, ["b.bvh.expected.json", "c.bvh.expected-error"].map(|name| inner.join(name)));
}

fn has_extension(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(wanted))
}

/// `walk.bvh` and `.expected.json` give `walk.bvh.expected.json`.
fn beside(file: &Path, suffix: &str) -> PathBuf {
    let name: &OsStr = file.file_name().unwrap_or_default();
    let mut name = name.to_owned();
    name.push(suffix);
    file.with_file_name(name)
}

fn check(file: &Path) -> Verdict {
    if has_extension(file, "amc") {
        return Verdict::NotReadYet;
    }
    let Ok(result) = catch_unwind(AssertUnwindSafe(|| bvh::read_file(file))) else {
        return Verdict::Wrong("the reader panicked".into());
    };
    let json = beside(file, ".expected.json");
    let must_fail = beside(file, ".expected-error").exists();
    match result {
        Ok(_) if must_fail => Verdict::Wrong("was read, but must be refused".into()),
        Ok(reading) if json.exists() => match compare(&reading.motion, &json) {
            Ok(worst) => Verdict::Right(Some(worst)),
            Err(why) => Verdict::Wrong(why),
        },
        Ok(_) => Verdict::Right(None),
        Err(error) if !names_its_place(&error, file) => {
            Verdict::Wrong(format!("no line and column: {error}"))
        }
        Err(error) if json.exists() => Verdict::Wrong(format!("was refused: {error}")),
        Err(_) => Verdict::Right(None),
    }
}

fn names_its_place(error: &bvh::FileError, file: &Path) -> bool {
    let bvh::FileError::Read { cause, .. } = error else { return false };
    let (line, column) = (cause.line(), cause.column());
    line > 0 && column > 0 && error.to_string().starts_with(&format!("{}:{line}:{column}: ", file.display()))
}

/// Compares `motion` with what `json` says of it. Gives how far off the worst joint is, or what is wrong.
fn compare(motion: &Motion, json: &Path) -> Result<Worst, String> {
    let text = fs::read_to_string(json).map_err(|error| error.to_string())?;
    let expected: Expected = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let skeleton = motion.skeleton();
    same("frames", &motion.frame_count(), &expected.frames_used)?;
    same("channels", &skeleton.channel_count(), &expected.channels_per_frame)?;
    same("frame time", &Ok(motion.frame_time()), &expected.frame_time.parse::<f64>())?;
    same("nodes", &skeleton.len(), &expected.nodes.len())?;
    for (joint, node) in skeleton.joints().iter().zip(&expected.nodes) {
        same("node", &describe(joint), &(node.kind.as_str(), node.name.as_str(), node.parent))?;
    }

    let extent = f64::from(skeleton.extent());
    let unit = if extent > 0.0 { extent } else { 1.0 };
    let mut worst = Worst::default();
    for frame in &expected.frames {
        let replaced = pose(motion, frame.frame, PositionChannels::Replace);
        let added = pose(motion, frame.frame, PositionChannels::Add);
        let positions_add = frame.positions_add.as_ref().unwrap_or(&frame.positions);
        same("positions", &skeleton.len(), &frame.positions.len())?;
        same("positions_add", &skeleton.len(), &positions_add.len())?;
        same("rotations", &skeleton.len(), &frame.global_quat_wxyz.len())?;
        for (id, joint) in skeleton.joints().iter().enumerate() {
            let (got, got_add) = (&replaced.transforms()[id], &added.transforms()[id]);
            let position = distance(got.position.to_array(), frame.positions[id]) / unit;
            let position_add = distance(got_add.position.to_array(), positions_add[id]) / unit;
            let rotation = angle(got.rotation.to_array(), frame.global_quat_wxyz[id]);
            let position = larger(position, position_add);
            worst.include(Worst { position, rotation });
            // Written so that NaN is wrong, too.
            if !(position <= POSITION_TOLERANCE && rotation <= ROTATION_TOLERANCE) {
                let label = skeleton.label(joint.id);
                return Err(format!(
                    "frame {}, {label}: off by {position:.1e} of the extent and {rotation:.1e} degrees",
                    frame.frame
                ));
            }
        }
    }
    if expected.frames.is_empty() { Err("no frames to compare".into()) } else { Ok(worst) }
}

fn same<T: PartialEq + std::fmt::Debug>(what: &str, got: &T, expected: &T) -> Result<(), String> {
    if got == expected { Ok(()) } else { Err(format!("{what}: {got:?}, expected {expected:?}")) }
}

fn describe(joint: &Joint) -> (&str, &str, i64) {
    let parent = joint.parent.map_or(-1, |parent| parent.0 as i64);
    match joint {
        Joint { is_end_site: true, .. } => ("end", "", parent),
        Joint { parent: None, name, .. } => ("root", name, parent),
        Joint { name, .. } => ("joint", name, parent),
    }
}

fn pose(motion: &Motion, index: usize, positions: PositionChannels) -> Pose {
    let (mut frame, mut pose) = (Frame::default(), Pose::default());
    motion.read_frame(index, positions, &mut frame);
    pose_frame(motion.skeleton(), &frame, &solutions::FK, &mut pose);
    pose
}

fn distance(got: [f32; 3], expected: [f64; 3]) -> f64 {
    let square = |i: usize| (f64::from(got[i]) - expected[i]).powi(2);
    (square(0) + square(1) + square(2)).sqrt()
}

/// The angle between two rotations, in degrees: twice that of the quaternion which leads from one to the other. The
/// arctangent keeps small angles, which the arccosine of a number close to 1 would lose.
fn angle(got_xyzw: [f32; 4], expected_wxyz: [f64; 4]) -> f64 {
    let [x, y, z, w] = got_xyzw.map(f64::from);
    let [ew, ex, ey, ez] = expected_wxyz;
    // conjugate(expected) * got
    let scalar = ew * w + ex * x + ey * y + ez * z;
    let i = ew * x - ex * w - ey * z + ez * y;
    let j = ew * y + ex * z - ey * w - ez * x;
    let k = ew * z - ex * y + ey * x - ez * w;
    let vector = (i * i + j * j + k * k).sqrt();
    // q and −q are one rotation.
    (2.0 * vector.atan2(scalar.abs())).to_degrees()
}

impl Worst {
    fn include(&mut self, other: Worst) {
        self.position = larger(self.position, other.position);
        self.rotation = larger(self.rotation, other.rotation);
    }
}

/// The larger of two differences; NaN, if one is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
