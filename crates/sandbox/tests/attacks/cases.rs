//! What must become of each attack.

use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;
use std::{env, fs, thread};

use sandbox::{Confinement, Layer, Layers, Limits, Sandbox};

use crate::attacker::REFUSED;
use crate::judge::{HARNESS, MIB, SECRET, Scene, text};
use crate::modes::TOOLCHAIN;
use crate::{exhausted, refused};

type Case = (&'static str, fn(&Scene));

/// Needs a toolchain.
pub const COMPILER: &str = "a compiler and a linker work";

const CASES: &[Case] = &[
    ("an honest program works", honest),
    (COMPILER, compiler),
    ("without a sandbox the attacks succeed", refused::control),
    ("it ends as the program does", endings),
    ("its environment is what was given", environment),
    ("open files are not inherited", refused::descriptors),
    ("files of others", refused::files),
    ("files that may be read", refused::readable),
    ("links, pipes and modes in the folder", refused::folder),
    ("programs", refused::programs),
    ("processes", refused::processes),
    ("signals and debugging", refused::others),
    ("network", refused::network),
    ("shared memory and the kernel's back doors", refused::back_doors),
    ("rights", refused::rights),
    ("old numbers of system calls", refused::old_numbers),
    ("memory", exhausted::memory),
    ("threads", exhausted::threads),
    ("open files", exhausted::open_files),
    ("recursion", exhausted::recursion),
    ("processor time", exhausted::processor_time),
    ("time by the clock", exhausted::clock),
    ("floods of output", exhausted::floods),
    ("the disk", exhausted::disk),
    ("neighbours", neighbours),
    ("killing it ends everything", killed),
    ("it ends with its harness", harness_killed),
    ("trouble of the jail is told apart", trouble),
    ("what is not possible is refused", impossible),
];

pub fn names() -> impl Iterator<Item = &'static str> {
    CASES.iter().map(|(name, _)| *name)
}

pub fn judge(name: &str, scene: &Scene) {
    let (_, case) = CASES.iter().find(|(other, _)| *other == name).unwrap();
    case(scene);
}

fn honest(scene: &Scene) {
    let readable = scene.path("library/readable");
    let finished = scene.run("honest", &[readable.to_str().unwrap(), "out"]);
    assert_eq!(text(&finished), format!("12 Some({}) yes true\n", SECRET.len()));
    assert!(finished.status.unwrap().success() && finished.limit.is_none());
    assert!(finished.cpu > Duration::ZERO);
    assert_eq!(fs::read_to_string(scene.path("folder/made/copy")).unwrap(), "result");
}

fn compiler(scene: &Scene) {
    let sysroot = env::current_exe().unwrap().with_file_name(TOOLCHAIN);
    let (rustc, linker) = (sysroot.join("bin/rustc"), PathBuf::from("/usr/bin/ld"));
    let mut confinement = scene.confinement.clone();
    confinement.read.extend([sysroot, linker.clone()]);
    confinement.limits = Limits { memory: 3 << 30, threads: 64, file_size: 64 * MIB, ..confinement.limits };
    fs::write(scene.path("folder/lib.rs"), "#[unsafe(no_mangle)] pub fn answer() -> u32 { 42 }").unwrap();
    let run = |program: &PathBuf, words: &[&str]| {
        let words: Vec<OsString> = words.iter().map(OsString::from).collect();
        let finished = scene.sandbox.run(1, &confinement, program, &words).unwrap();
        assert!(finished.status.unwrap().success(), "{:?}: {}", finished.status, text(&finished));
    };
    run(&rustc, &["--crate-type=lib", "--emit=obj", "lib.rs", "-o", "lib.o"]);
    run(&linker, &["-shared", "lib.o", "-o", "lib.so"]);
    assert!(fs::read(scene.path("folder/lib.so")).unwrap().starts_with(b"\x7fELF"));
    // Nothing that a source names is there but what is given.
    let secret = scene.secret();
    fs::write(scene.path("folder/spy.rs"), format!("const _: &str = include_str!({secret:?});")).unwrap();
    let words = ["--crate-type=lib", "--emit=obj", "spy.rs"].map(OsString::from);
    let finished = scene.sandbox.run(1, &confinement, &rustc, &words).unwrap();
    assert!(!text(&finished).contains(SECRET) && finished.status.unwrap().code() == Some(1));
}

fn endings(scene: &Scene) {
    let ending = |attack| scene.run(attack, &[]).status.unwrap();
    assert_eq!(ending("exit").code(), Some(7));
    assert_eq!(ending("abort").signal(), Some(libc::SIGABRT));
    assert_eq!(ending("crash").signal(), Some(libc::SIGSEGV));
    assert_eq!(ending("no such attack").code(), Some(101));
    // No core dump.
    assert_eq!(fs::read_dir(scene.path("folder")).unwrap().count(), 1);
}

fn environment(scene: &Scene) {
    let finished = scene.run("environment", &[]);
    let program = env::current_exe().unwrap();
    assert_eq!(text(&finished), format!("GIVEN=yes\n{}\nattacker\nenvironment\n", program.display()));
}

/// A program that holds all that it can get does not take it from others, nor do they see its files.
fn neighbours(scene: &Scene) {
    // Enough memory for many threads: one that begins without any for its own needs would end them all.
    let limits = Limits { memory: 16 << 30, ..scene.confinement.limits };
    let confinement = Confinement { limits, ..scene.confinement.clone() };
    let mut hog = scene.command_as(&confinement, "hold threads", &[]);
    let mut hog = hog.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
    let output = wait_until_asleep(hog.stdout.take().unwrap());
    let confinement = Confinement { folder: None, ..scene.confinement.clone() };
    let other = scene.mode.sandbox().unwrap();
    for (sandbox, slot) in [(&scene.sandbox, 2), (&other, 1)] {
        if scene.counts_threads() {
            let finished = scene.run_in(sandbox, slot, &confinement, "honest", &[]);
            assert!(finished.status.unwrap().success(), "{}", text(&finished));
        }
        let file = scene.path("folder/here");
        let finished = scene.run_in(sandbox, slot, &confinement, "read", &[file.to_str().unwrap()]);
        assert!(finished.stdout.starts_with(REFUSED.as_bytes()), "{}", text(&finished));
    }
    hog.kill().unwrap();
    hog.wait().unwrap();
    ends(output);
}

fn killed(scene: &Scene) {
    let mut child = scene.command("sleep", &[]).stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
    let output = wait_until_asleep(child.stdout.take().unwrap());
    child.kill().unwrap();
    ends(output);
    assert_eq!(child.wait().unwrap().signal(), Some(libc::SIGKILL));
}

fn harness_killed(scene: &Scene) {
    let mut harness = Command::new(env::current_exe().unwrap());
    // What it leaves behind goes with the judge's own files.
    let mut harness = harness
        .args([HARNESS, scene.mode.name])
        .arg(scene.home.path())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let output = wait_until_asleep(harness.stdout.take().unwrap());
    harness.kill().unwrap();
    harness.wait().unwrap();
    ends(output);
}

fn wait_until_asleep<R: Read>(output: R) -> BufReader<R> {
    let mut output = BufReader::new(output);
    let mut line = String::new();
    output.read_line(&mut line).unwrap();
    assert_eq!(line, "asleep\n");
    output
}

/// Whoever still ran would hold this pipe open.
fn ends(mut output: impl Read + Send + 'static) {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(output.read_to_end(&mut Vec::new())));
    receiver.recv_timeout(Duration::from_secs(20)).expect("something still runs").unwrap();
}

fn trouble(scene: &Scene) {
    let program = env::current_exe().unwrap();
    let run = |confinement: &Confinement, program: &str| {
        scene.sandbox.run(1, confinement, program.as_ref(), &[]).unwrap_err().to_string()
    };
    let mut missing = scene.confinement.clone();
    missing.read.push(PathBuf::from("/nowhere/to be found"));
    let error = run(&missing, program.to_str().unwrap());
    assert!(error.contains("/nowhere/to be found"), "{error}");
    let error = run(&scene.confinement, "/nowhere/program");
    assert!(error.contains("/nowhere/program"), "{error}");
    for path in ["relative", "/", "/some/../where"] {
        let mut confinement = scene.confinement.clone();
        confinement.read.push(path.into());
        let error = run(&confinement, program.to_str().unwrap());
        assert!(error.contains("not an absolute path"), "{error}");
    }
    // Also where nothing that it says is wanted.
    missing.limits.output = 0;
    let error = run(&missing, program.to_str().unwrap());
    assert!(error.contains("/nowhere/to be found"), "{error}");
    // For users of `command`.
    let mut command = scene.sandbox.command(1, &missing, &program).unwrap();
    let output = command.output().unwrap();
    assert!(scene.sandbox.setup_failure(&output.stderr).unwrap().contains("/nowhere/to be found"));
    assert_eq!(scene.sandbox.setup_failure(b"sandbox-0123456789abcdef: no\nthread panicked"), None);
}

fn impossible(scene: &Scene) {
    let launcher = env::current_exe().unwrap();
    if !nix::unistd::geteuid().is_root() {
        let layers = Layers::of(&[Layer::OwnUser, Layer::Landlock, Layer::Seccomp, Layer::Limits]);
        assert!(Sandbox::with_layers(launcher, layers).is_err());
    } else if !scene.has(Layer::Namespaces) {
        // A toolchain in a home that only root can enter.
        let home = scene.path("outside");
        fs::set_permissions(&home, fs::Permissions::from_mode(0o700)).unwrap();
        let sandbox = Sandbox::strongest(launcher, &[home.join("secret")]).unwrap();
        assert!(!sandbox.layers().own_user);
    }
}
