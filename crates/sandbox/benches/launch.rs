//! What each layer costs: starting a program that does nothing. `cargo bench -p sandbox`
#![allow(clippy::unwrap_used)] // A program for developers.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use sandbox::{Confinement, Layer, Layers, Limits, Sandbox, enter_if_asked, system_libraries};

const RUNS: u32 = 200;

fn main() {
    enter_if_asked();
    let program = Path::new("/bin/true");
    println!("{:<58} {:>9} {:>9}", "microseconds per launch, median of 200", "CPU", "wall");

    let bare = || {
        let start = children();
        Command::new(program).status().unwrap();
        children() - start
    };
    report("the program alone", bare);

    let launcher = env::current_exe().unwrap();
    time("unsandboxed", &Sandbox::unsandboxed(launcher.clone()), program);
    let mut layers = Layers::default();
    for layer in
        [Layer::Limits, Layer::Seccomp, Layer::Landlock, Layer::Cgroup, Layer::Namespaces, Layer::OwnUser]
    {
        let mut all: Vec<Layer> = Layer::ALL.into_iter().filter(|layer| layers.has(*layer)).collect();
        all.push(layer);
        let more = Layers::of(&all);
        match Sandbox::with_layers(launcher.clone(), more) {
            Ok(sandbox) => {
                time(&more.to_string(), &sandbox, program);
                layers = more;
            }
            Err(error) => println!("{layer}: {error}"),
        }
    }
}

fn time(name: &str, sandbox: &Sandbox, program: &Path) {
    let limits = Limits {
        cpu: Duration::from_secs(5),
        wall: Duration::from_secs(5),
        memory: 1 << 30,
        threads: 8,
        output: 1 << 16,
        file_size: 0,
    };
    let mut read: Vec<PathBuf> = system_libraries();
    read.push(program.to_path_buf());
    let confinement = Confinement { read, folder: None, environment: Vec::new(), limits };
    let mut command = sandbox.command(0, &confinement, program).unwrap();
    report(name, || {
        let start = children();
        assert!(command.status().unwrap().success());
        children() - start
    });
}

fn report(name: &str, mut launch: impl FnMut() -> Duration) {
    let mut times: Vec<(Duration, Duration)> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            (launch(), start.elapsed())
        })
        .collect();
    let middle = times.len() / 2;
    let cpu = times.select_nth_unstable_by_key(middle, |time| time.0).1.0;
    let wall = times.select_nth_unstable_by_key(middle, |time| time.1).1.1;
    println!("{name:<58} {:>9} {:>9}", cpu.as_micros(), wall.as_micros());
}

/// Processor time of all children so far.
#[cfg(unix)]
fn children() -> Duration {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN).unwrap();
    let micros = usage.user_time().num_microseconds() + usage.system_time().num_microseconds();
    Duration::from_micros(micros.unsigned_abs())
}

#[cfg(not(unix))]
fn children() -> Duration {
    Duration::ZERO
}
