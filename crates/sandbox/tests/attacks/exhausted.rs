//! What must come to an end.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::time::Duration;

use sandbox::{Confinement, Limit, Limits};

use crate::judge::{MIB, Scene, text};

pub fn memory(scene: &Scene) {
    let finished = scene.run("hog memory", &[]);
    assert_eq!(finished.limit, Some(Limit::Memory), "{finished:?}");
}

pub fn threads(scene: &Scene) {
    // Enough memory for many.
    let limits = Limits { memory: 16 << 30, ..scene.confinement.limits };
    let finished = scene.run_as(&Confinement { limits, ..scene.confinement.clone() }, "threads", &[]);
    let count: u32 = text(&finished).trim().parse().unwrap();
    // Together with all others of the same user, an exact number would mean nothing.
    let most = if scene.counts_threads() { limits.threads } else { 5000 };
    assert!((8..=most).contains(&count), "{count}");
}

pub fn open_files(scene: &Scene) {
    let count: u32 = text(&scene.run("open files", &[])).lines().next().unwrap().parse().unwrap();
    assert!((32..=256).contains(&count), "{count}");
}

pub fn recursion(scene: &Scene) {
    let signal = scene.run("recurse", &[]).status.unwrap().signal();
    assert!([Some(libc::SIGSEGV), Some(libc::SIGABRT)].contains(&signal), "{signal:?}");
}

pub fn processor_time(scene: &Scene) {
    let limits = Limits { cpu: Duration::from_secs(1), ..scene.confinement.limits };
    let confinement = Confinement { limits, ..scene.confinement.clone() };
    for attack in ["loop", "loop on"] {
        let finished = scene.run_as(&confinement, attack, &[]);
        assert_eq!(finished.limit, Some(Limit::Cpu), "{finished:?}");
        assert!(finished.cpu >= limits.cpu / 2, "{finished:?}");
    }
}

pub fn clock(scene: &Scene) {
    let limits = Limits { wall: Duration::from_millis(200), ..scene.confinement.limits };
    let confinement = Confinement { limits, ..scene.confinement.clone() };
    for attack in ["sleep", "hide and sleep"] {
        assert_eq!(scene.run_as(&confinement, attack, &[]).limit, Some(Limit::Wall));
    }
}

pub fn floods(scene: &Scene) {
    for attack in ["flood", "flood errors"] {
        let finished = scene.run(attack, &[]);
        assert_eq!(finished.limit, Some(Limit::Output));
        assert_eq!(finished.stdout.len() + finished.stderr.len(), scene.confinement.limits.output);
    }
    let limits = Limits { output: 0, ..scene.confinement.limits };
    let finished = scene.run_as(&Confinement { limits, ..scene.confinement.clone() }, "exit", &[]);
    assert_eq!((finished.limit, finished.status.unwrap().code()), (None, Some(7)));
}

pub fn disk(scene: &Scene) {
    let finished = scene.run("fill a file", &[]);
    assert_eq!(finished.status.unwrap().signal(), Some(libc::SIGXFSZ));
    assert_eq!(fs::metadata(scene.path("folder/large")).unwrap().len(), MIB);
    // Many small files: as many as fit into the time, all in the one folder.
    let limits = Limits { wall: Duration::from_millis(300), ..scene.confinement.limits };
    let finished = scene.run_as(&Confinement { limits, ..scene.confinement.clone() }, "fill the folder", &[]);
    assert_eq!(finished.limit, Some(Limit::Wall));
    fs::remove_dir_all(scene.path("folder")).unwrap();
}
