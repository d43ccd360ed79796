//! Systems on which the linker cannot be called directly: the compiler links, and nothing is confined.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::time::Duration;

use harness::batch::{CompileAndAsk, Marking};
use harness::compile::Compiler;
use harness::exercise::Exercise;
use harness::kit::Kit;
use harness::mark::Examiner;
use harness::picture::Portrait;
use harness::toolchain::{Linker, Toolchain};
use harness::workspace;
use results::Verdict;
use sandbox::{Limits, Sandbox};
use support::submissions;

#[test]
fn a_submission_is_marked_the_same() {
    let workspace = workspace::find().unwrap();
    let toolchain = Toolchain { linker: Linker::ByRustc, ..Toolchain::find(&workspace).unwrap() };
    let kit = Kit::build(&workspace, &toolchain).unwrap();
    let exercise = Exercise::named("fk").unwrap();
    let sandbox = Sandbox::unsandboxed(env!("CARGO_BIN_EXE_harness").into());
    let exam = exercise.exam(7);
    let limits = Limits {
        cpu: Duration::from_secs(60),
        wall: Duration::from_secs(120),
        memory: 8 << 30,
        threads: 64,
        output: 1 << 20,
        file_size: 1 << 30,
    };
    let marking = CompileAndAsk {
        compiler: Compiler { exercise, toolchain: &toolchain, kit: &kit, sandbox: &sandbox, limits },
        examiner: Examiner {
            exam: &exam,
            portrait: Some(&Portrait::of_joints().unwrap()),
            sandbox: &sandbox,
            limits,
            patience: Duration::from_secs(10),
        },
    };
    let folder = tempfile::Builder::new().prefix("by rustc ").tempdir().unwrap();
    let points = |source: &str| {
        let verdict = marking.mark(0, &folder.path().join("0"), source).verdict;
        match verdict {
            Verdict::Graded { parts, .. } => parts.iter().map(|part| part.points).sum::<u32>(),
            Verdict::DoesNotCompile { errors, .. } => {
                assert!(errors[0].line.is_some(), "{errors:?}");
                0
            }
            other => panic!("{other:?}"),
        }
    };
    assert_eq!([0, 2, 3, 4, 5].map(|number| points(&submissions::source(number))), [15, 11, 14, 0, 0]);
}
