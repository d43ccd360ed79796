//! What must be refused.

use std::ffi::OsString;
use std::net::{TcpListener, UdpSocket};
use std::os::fd::AsRawFd;
use std::os::linux::net::SocketAddrExt;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::net::{SocketAddr, UnixListener};
use std::os::unix::process::ExitStatusExt;
use std::{env, fs, process};

use sandbox::{Confinement, Layer, Limits, Sandbox};

use crate::judge::{SECRET, Scene, text};

/// Shows that the attacks are real: what is refused elsewhere is refused by the sandbox.
pub fn control(scene: &Scene) {
    let sandbox = Sandbox::unsandboxed(env::current_exe().unwrap());
    assert_eq!(sandbox.layers().to_string(), "unsandboxed");
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let name = format!("sandbox-test-{}", process::id());
    let _listener = UnixListener::bind_addr(&SocketAddr::from_abstract_name(&name).unwrap()).unwrap();
    let path = |name: &str| scene.path(name).to_str().unwrap().to_owned();
    let _socket = UnixListener::bind(path("outside/socket")).unwrap();
    let (secret, own) = (path("outside/secret"), process::id().to_string());
    let attacks: &[&[&str]] = &[
        &["read", &secret],
        &["read", &format!("/proc/{own}/environ")],
        &["see", &secret],
        &["list", "/"],
        &["append", &secret],
        &["write", &path("outside/new")],
        &["hard link", &path("outside/new"), "linked"],
        &["rename", &path("outside/new"), "moved"],
        &["symbolic link", "/etc/passwd", "link"],
        &["pipe file", "pipe"],
        &["set-user bit", "file"],
        &["change mode", "file"],
        &["connect", &address],
        &["send", &address],
        &["unix socket", &path("outside/socket")],
        &["abstract socket", &name],
        &["fork"],
        &["signal by a file", &own],
        &["cut off", "linked"],
        &["delete", &secret],
    ];
    for words in attacks {
        let words: Vec<OsString> = [&["attacker"], *words].concat().iter().map(OsString::from).collect();
        let program = env::current_exe().unwrap();
        let finished = sandbox.run(1, &scene.confinement, &program, &words).unwrap();
        assert!(finished.stdout.starts_with(b"SUCCEEDED"), "{words:?}: {}", text(&finished));
    }
}

pub fn descriptors(scene: &Scene) {
    let file = fs::File::open(scene.secret()).unwrap();
    let inherited = nix::fcntl::fcntl(&file, nix::fcntl::FcntlArg::F_DUPFD(100)).unwrap();
    assert!(inherited >= 100 && file.as_raw_fd() > 2);
    scene.refuses("files left open", &[]);
}

pub fn files(scene: &Scene) {
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

pub fn readable(scene: &Scene) {
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

pub fn folder(scene: &Scene) {
    scene.refuses("set-user bit", &["file"]);
    scene.refuses("change mode", &["."]);
    scene.refuses("change owner", &["."]);
    scene.refuses("pipe file", &["pipe"]);
    scene.refuses("symbolic link", &["/etc/passwd", "link"]);
}

pub fn programs(scene: &Scene) {
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

pub fn processes(scene: &Scene) {
    filtered(scene, "fork", &[]);
    raw(scene, libc::SYS_clone3, &["memory", "64"]);
    #[cfg(target_arch = "x86_64")]
    for call in [libc::SYS_fork, libc::SYS_vfork] {
        raw(scene, call, &[]);
    }
    let new_namespace = (libc::CLONE_NEWUSER | libc::SIGCHLD).to_string();
    raw(scene, libc::SYS_clone, &[&new_namespace]);
}

pub fn others(scene: &Scene) {
    let own = process::id().to_string();
    for target in [&own, "-1", "0", "1"] {
        filtered(scene, "signal", &[target]);
        filtered(scene, "signal by a file", &[target]);
    }
    filtered(scene, "thread signal", &[&own]);
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

pub fn network(scene: &Scene) {
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

pub fn back_doors(scene: &Scene) {
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

pub fn rights(scene: &Scene) {
    filtered(scene, "limits", &[]);
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

pub fn old_numbers(scene: &Scene) {
    assert_eq!(scene.run("old numbers", &[]).status.unwrap().signal(), Some(libc::SIGSYS));
}

/// The filter must refuse the call: other reasons to fail do not count.
fn raw(scene: &Scene, number: i64, arguments: &[&str]) {
    let number = number.to_string();
    let words: Vec<&str> = [number.as_str()].into_iter().chain(arguments.iter().copied()).collect();
    filtered(scene, "system call", &words);
}

fn filtered(scene: &Scene, attack: &str, arguments: &[&str]) {
    scene.refuses(attack, arguments);
    let said = text(&scene.run(attack, arguments));
    assert!(said.contains("os error 38"), "{attack} {arguments:?}: {said}");
}
