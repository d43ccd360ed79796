//! Ten thousand submissions take no more memory than three hundred. The compiler is left out: it is a process of its own.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use harness::batch::{Jobs, Marking, Outcome};
use harness::exercise::Exercise;
use harness::journal::{Header, Journal};
use harness::log::Log;
use harness::{finish, picture};
use peak_alloc::PeakAlloc;
use results::{CompileError, RunInfo, SCHEMA, Verdict};
use submissions::Batch;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Every submission gets a verdict of a common size.
struct Fake;

impl Marking for Fake {
    fn mark(&self, _slot: u32, _folder: &Path, source: &str) -> Outcome {
        let error = CompileError {
            message: "mismatched types".to_owned(),
            line: Some(12),
            column: Some(5),
            text: source.chars().take(1000).collect(),
        };
        let verdict = Verdict::DoesNotCompile { errors: vec![error; 3], left_out: 0 };
        Outcome { verdict, compile: Duration::ZERO, run: Duration::ZERO }
    }
}

/// The most memory in use at once while so many are marked and written, in bytes.
fn peak(count: usize) -> usize {
    let folder = tempfile::tempdir().unwrap();
    let given = folder.path().join("given");
    support::submissions::write(&given, count);
    let out = folder.path().join("out");
    std::fs::create_dir(&out).unwrap();
    MEMORY.reset_peak_usage();

    let batch = Batch::open(&given, &Exercise::named("fk").unwrap().wanted()).unwrap();
    let portrait = picture::Portrait::of_joints().unwrap();
    let info = RunInfo {
        schema: SCHEMA,
        exercise: "fk".to_owned(),
        title: String::new(),
        parts: Vec::new(),
        seed: 1,
        versions: BTreeMap::new(),
        limits: BTreeMap::new(),
        sandbox: "unsandboxed".to_owned(),
        sandboxed: false,
        shard: None,
        reference_picture: Some(portrait.reference.clone()),
    };
    let journal = Journal::begin(&out, Header { info, total: count, digest: String::new() }).unwrap();
    let jobs = Jobs {
        batch: &batch,
        marking: &Fake,
        sandbox: "unsandboxed",
        scratch: out.join("scratch"),
        journal: &journal,
        log: &Log::open(&out).unwrap(),
        stop: &AtomicBool::new(false),
        progress: &|_| {},
    };
    let entries: Vec<_> = batch.entries().iter().collect();
    assert!(jobs.run(&entries, 2).unwrap());
    let ids = batch.entries().iter().map(|entry| entry.id.clone()).collect();
    let exercise = Exercise::named("fk").unwrap();
    finish::write(&out, &journal, &ids, exercise, results::Options::default()).unwrap();
    MEMORY.peak_usage()
}

#[test]
fn memory_stays_flat() {
    grows_little(2_000);
}

#[test]
#[ignore = "takes a minute: .ci/run does it"]
fn memory_stays_flat_for_ten_thousand() {
    grows_little(10_000);
}

fn grows_little(count: usize) {
    let few = peak(300);
    let many = peak(count);
    println!("300 submissions: {} KiB; {count}: {} KiB", few / 1024, many / 1024);
    // What is kept of each is its name, a hash and a fingerprint: some 2 KiB.
    assert!(many < few + count * 3 * 1024, "{few} bytes for 300, {many} for {count}");
}
