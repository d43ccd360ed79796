//! What must become of each attack.

use std::io::{BufRead, BufReader, Read};
use std::net::{TcpListener, UdpSocket};
use std::os::fd::AsRawFd;
use std::os::linux::net::SocketAddrExt;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::{SocketAddr, UnixListener};
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;
use std::{env, fs, process, thread};

use sandbox::{Confinement, Layer, Layers, Limit, Limits, Sandbox};

use crate::judge::{HARNESS, MIB, SECRET, Scene, text};

type Case = (&'static str, fn(&Scene));

const CASES: &[Case] = &[
    ("an honest program works", honest),
    ("it ends as the program does", endings),
    ("its environment is what was given", environment),
    ("open files are not inherited", descriptors),
    ("files of others", files),
    ("files that may be read", readable),
    ("links, pipes and modes in the folder", folder),
    ("programs", programs),
    ("processes", processes),
    ("signals and debugging", others),
    ("network", network),
    ("shared memory and the kernel's back doors", back_doors),
    ("rights", rights),
    ("old numbers of system calls", old_numbers),
    ("memory", memory),
    ("threads", threads),
    ("open files", open_files),
    ("recursion", recursion),
    ("processor time", processor_time),
    ("time by the clock", clock),
    ("floods of output", floods),
    ("the disk", disk),
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

fn descriptors(scene: &Scene) {
    let file = fs::File::open(scene.secret()).unwrap();
    let inherited = nix::fcntl::fcntl(&file, nix::fcntl::FcntlArg::F_DUPFD(100)).unwrap();
    assert!(inherited >= 100 && file.as_raw_fd() > 2);
    scene.refuses("files left open", &[]);
}

fn files(scene: &Scene) {
    let secret = scene.secret();
    let own = process::id();
    let new = scene.path("outside/new");
    let new = new.to_str().unwrap();
    for path in [&secret, "/etc/passwd", "/etc/shadow", &format!("/proc/{own}/environ"), "/proc/self/environ"]
    {
        scene.refuses("read", &[path]);
    }
    for path in
        [&secret, new, "/dev/shm/sandbox-test", "/tmp/sandbox-test", "/proc/self/mem", "/proc/self/comm"]
    {
        scene.refuses("write", &[path]);
        scene.refuses("append", &[path]);
    }
    for attack in ["delete", "cut off", "change mode", "change owner"] {
        scene.refuses(attack, &[&secret]);
    }
    for attack in ["rename", "hard link"] {
        scene.refuses(attack, &[&secret, "here"]);
        scene.refuses(attack, &["here", new]);
    }
    for folder in ["/etc", "/home", "/proc/self/fd", "/dev", "/sys"] {
        scene.refuses("list", &[folder]);
    }
    if scene.has(Layer::Landlock) {
        // Without, these hold what leads to the given files, and nothing else.
        scene.refuses("list", &["/"]);
        scene.refuses("list", &["/tmp"]);
    }
    if scene.has(Layer::Namespaces) {
        scene.refuses("see", &[&secret]);
        scene.refuses("see", &["/etc"]);
    }
    assert_eq!(fs::read_to_string(secret).unwrap(), SECRET);
    assert_eq!(fs::read_dir(scene.path("outside")).unwrap().count(), 1);
}

fn readable(scene: &Scene) {
    let path = scene.path("library/readable");
    let readable = path.to_str().unwrap();
    for attack in ["write", "append", "cut off", "delete", "change mode", "change owner"] {
        scene.refuses(attack, &[readable]);
    }
    scene.refuses("rename", &[readable, "here"]);
    scene.refuses("hard link", &[readable, "here"]);
    scene.refuses("write", &[scene.path("library/new").to_str().unwrap()]);
    assert_eq!(fs::read_to_string(&path).unwrap(), SECRET);
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, 0o666);
}

fn folder(scene: &Scene) {
    scene.refuses("set-user bit", &["file"]);
    scene.refuses("change mode", &["."]);
    scene.refuses("change owner", &["."]);
    scene.refuses("pipe file", &["pipe"]);
    scene.refuses("symbolic link", &["/etc/passwd", "link"]);
}

fn programs(scene: &Scene) {
    scene.refuses("run", &["/bin/sh", "-c", "echo SUCCEEDED"]);
    scene.refuses("run", &["/usr/bin/env"]);
    let limits = Limits { file_size: 1 << 30, ..scene.confinement.limits };
    let roomy = Confinement { limits, ..scene.confinement.clone() };
    scene.refuses_as(&roomy, "run a copy", &["copy"]);
    assert!(scene.path("folder/copy").exists());
    // Itself it may start anew; it stays where it is.
    let program = env::current_exe().unwrap();
    let program = program.to_str().unwrap();
    scene.refuses("run", &[program, "attacker", "read", &scene.secret()]);
    scene.refuses("run", &[program, "attacker", "fork"]);
    let finished = scene.run("run", &[program, "--enter-sandbox", "token", "spec"]);
    assert!(text(&finished).contains("does not understand") && !finished.status.unwrap().success());
    let finished = scene.run("run", &[program, "--make-namespaces"]);
    assert!(text(&finished).contains("could not"), "{}", text(&finished));
}

fn processes(scene: &Scene) {
    scene.refuses("fork", &[]);
    raw(scene, libc::SYS_clone3, &["memory", "64"]);
    #[cfg(target_arch = "x86_64")]
    for call in [libc::SYS_fork, libc::SYS_vfork] {
        raw(scene, call, &[]);
    }
    let new_namespace = (libc::CLONE_NEWUSER | libc::SIGCHLD).to_string();
    raw(scene, libc::SYS_clone, &[&new_namespace]);
}

fn others(scene: &Scene) {
    let own = process::id().to_string();
    for target in [&own, "-1", "0", "1"] {
        scene.refuses("signal", &[target]);
        scene.refuses("signal by a file", &[target]);
    }
    scene.refuses("thread signal", &[&own]);
    let attach = libc::PTRACE_ATTACH.to_string();
    raw(scene, libc::SYS_ptrace, &[&attach, &own]);
    raw(scene, libc::SYS_ptrace, &["0"]);
    raw(scene, libc::SYS_process_vm_readv, &[&own, "memory", "1", "memory", "1"]);
    raw(scene, libc::SYS_process_vm_writev, &[&own, "memory", "1", "memory", "1"]);
    raw(scene, libc::SYS_pidfd_open, &[&own]);
    raw(scene, libc::SYS_kcmp, &[&own, &own]);
    raw(scene, libc::SYS_setpriority, &["0", "0", "10"]);
    let no_signal = ["1", "0"];
    raw(scene, libc::SYS_prctl, &no_signal); // PR_SET_PDEATHSIG
}

fn network(scene: &Scene) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    scene.refuses("connect", &[&listener.local_addr().unwrap().to_string()]);
    let receiver = UdpSocket::bind("127.0.0.1:0").unwrap();
    scene.refuses("send", &[&receiver.local_addr().unwrap().to_string()]);
    let path = scene.path("library/socket");
    let _listener = UnixListener::bind(&path).unwrap();
    scene.refuses("unix socket", &[path.to_str().unwrap()]);
    let name = format!("sandbox-test-{}", process::id());
    let _listener = UnixListener::bind_addr(&SocketAddr::from_abstract_name(&name).unwrap()).unwrap();
    scene.refuses("abstract socket", &[&name]);
    raw(scene, libc::SYS_socketpair, &["1", "1", "0", "memory"]);
    for family in [libc::AF_NETLINK, libc::AF_PACKET, libc::AF_ALG, libc::AF_VSOCK] {
        raw(scene, libc::SYS_socket, &[&family.to_string(), "3", "0"]);
    }
}

fn back_doors(scene: &Scene) {
    raw(scene, libc::SYS_shmget, &["0", "4096", "950"]);
    raw(scene, libc::SYS_msgget, &["0", "950"]);
    raw(scene, libc::SYS_semget, &["0", "1", "950"]);
    raw(scene, libc::SYS_mq_open, &["memory", "66", "438", "0"]);
    raw(scene, libc::SYS_memfd_create, &["memory", "0"]);
    raw(scene, libc::SYS_io_uring_setup, &["8", "memory"]);
    raw(scene, libc::SYS_userfaultfd, &["1"]);
    raw(scene, libc::SYS_bpf, &["0", "memory", "64"]);
    raw(scene, libc::SYS_perf_event_open, &["memory", "0", "-1", "-1", "0"]);
    raw(scene, libc::SYS_keyctl, &["0", "-3", "0"]);
    raw(scene, libc::SYS_open_by_handle_at, &["0", "memory", "0"]);
    raw(scene, libc::SYS_execveat, &["0", "memory", "0", "0", "4096"]);
    raw(scene, libc::SYS_fanotify_init, &["0", "0"]);
    raw(scene, libc::SYS_inotify_init1, &["0"]);
    raw(scene, libc::SYS_syslog, &["2", "memory", "100"]);
}

fn rights(scene: &Scene) {
    scene.refuses("limits", &[]);
    raw(scene, libc::SYS_setuid, &["0"]);
    raw(scene, libc::SYS_setresuid, &["0", "0", "0"]);
    raw(scene, libc::SYS_setgroups, &["0", "memory"]);
    raw(scene, libc::SYS_capset, &["memory", "memory"]);
    for kind in [libc::CLONE_NEWUSER, libc::CLONE_NEWNS, libc::CLONE_NEWPID] {
        raw(scene, libc::SYS_unshare, &[&kind.to_string()]);
    }
    raw(scene, libc::SYS_setns, &["0", "0"]);
    raw(scene, libc::SYS_mount, &["memory", "memory", "memory", "4096", "0"]);
    raw(scene, libc::SYS_umount2, &["memory", "2"]);
    raw(scene, libc::SYS_chroot, &["memory"]);
    raw(scene, libc::SYS_pivot_root, &["memory", "memory"]);
    raw(scene, libc::SYS_setsid, &[]);
    raw(scene, libc::SYS_personality, &["262144"]);
    raw(scene, libc::SYS_seccomp, &["1", "0", "memory"]);
}

fn raw(scene: &Scene, number: i64, arguments: &[&str]) {
    let number = number.to_string();
    let words: Vec<&str> = [number.as_str()].into_iter().chain(arguments.iter().copied()).collect();
    scene.refuses("system call", &words);
}

fn old_numbers(scene: &Scene) {
    assert_eq!(scene.run("old numbers", &[]).status.unwrap().signal(), Some(libc::SIGSYS));
}

fn memory(scene: &Scene) {
    let finished = scene.run("hog memory", &[]);
    assert_eq!(finished.limit, Some(Limit::Memory), "{finished:?}");
}

fn threads(scene: &Scene) {
    // Enough memory for many.
    let limits = Limits { memory: 16 << 30, ..scene.confinement.limits };
    let finished = scene.run_as(&Confinement { limits, ..scene.confinement.clone() }, "threads", &[]);
    let said = text(&finished);
    let count: u32 = said.lines().find_map(|line| line.parse().ok()).unwrap();
    let are_counted =
        [Layer::Namespaces, Layer::OwnUser, Layer::Cgroup].into_iter().any(|layer| scene.has(layer));
    // Together with all others of the same user, an exact number would mean nothing.
    let most = if are_counted { limits.threads } else { 5000 };
    assert!((8..=most).contains(&count), "{count}");
}

fn open_files(scene: &Scene) {
    let count: u32 = text(&scene.run("open files", &[])).lines().next().unwrap().parse().unwrap();
    assert!((32..=256).contains(&count), "{count}");
}

fn recursion(scene: &Scene) {
    let signal = scene.run("recurse", &[]).status.unwrap().signal();
    assert!([Some(libc::SIGSEGV), Some(libc::SIGABRT)].contains(&signal), "{signal:?}");
}

fn processor_time(scene: &Scene) {
    let limits = Limits { cpu: Duration::from_secs(1), ..scene.confinement.limits };
    let confinement = Confinement { limits, ..scene.confinement.clone() };
    for attack in ["loop", "loop on"] {
        let finished = scene.run_as(&confinement, attack, &[]);
        assert_eq!(finished.limit, Some(Limit::Cpu), "{finished:?}");
        assert!(finished.cpu >= limits.cpu / 2, "{finished:?}");
    }
}

fn clock(scene: &Scene) {
    let limits = Limits { wall: Duration::from_millis(200), ..scene.confinement.limits };
    let confinement = Confinement { limits, ..scene.confinement.clone() };
    for attack in ["sleep", "hide and sleep"] {
        assert_eq!(scene.run_as(&confinement, attack, &[]).limit, Some(Limit::Wall));
    }
}

fn floods(scene: &Scene) {
    for attack in ["flood", "flood errors"] {
        let finished = scene.run(attack, &[]);
        assert_eq!(finished.limit, Some(Limit::Output));
        assert_eq!(finished.stdout.len() + finished.stderr.len(), scene.confinement.limits.output);
    }
}

fn disk(scene: &Scene) {
    let finished = scene.run("fill a file", &[]);
    assert_eq!(finished.status.unwrap().signal(), Some(libc::SIGXFSZ));
    assert_eq!(fs::metadata(scene.path("folder/large")).unwrap().len(), MIB);
    // Many small files: as many as fit into the time, all in the one folder.
    let limits = Limits { wall: Duration::from_millis(300), ..scene.confinement.limits };
    let finished = scene.run_as(&Confinement { limits, ..scene.confinement.clone() }, "fill the folder", &[]);
    assert_eq!(finished.limit, Some(Limit::Wall));
    fs::remove_dir_all(scene.path("folder")).unwrap();
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
    let mut harness = harness.args([HARNESS, scene.mode.name]).stdout(Stdio::piped()).spawn().unwrap();
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
