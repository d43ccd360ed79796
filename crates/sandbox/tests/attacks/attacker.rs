//! The attacker: tries one thing and says how it went.
#![allow(unsafe_code)] // It would not ask.

use std::ffi::CString;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, Read, Write};
use std::net::{TcpStream, UdpSocket};
use std::os::fd::FromRawFd;
use std::os::linux::net::SocketAddrExt;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, chown, symlink};
use std::os::unix::net::{SocketAddr, UnixStream};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, abort, exit};
use std::time::Duration;
use std::{env, hint, ptr, thread};

pub const ROLE: &str = "attacker";
pub const REFUSED: &str = "REFUSED";

/// Tries `attack`, and says what was gained.
pub fn run(attack: &str, arguments: &[&str]) {
    match attempt(attack, arguments) {
        Ok(gain) => println!("SUCCEEDED: {gain}"),
        Err(error) => println!("{REFUSED}: {error}"),
    }
    exit(0);
}

fn attempt(attack: &str, arguments: &[&str]) -> io::Result<String> {
    let first = arguments.first().copied().unwrap_or_default();
    let number = first.parse::<i64>().unwrap_or_default();
    match attack {
        "read" => fs::read_to_string(first),
        "write" => fs::write(first, "graffiti").map(done),
        "append" => OpenOptions::new().append(true).open(first)?.write_all(b"graffiti").map(done),
        "cut off" => {
            let path = CString::new(first)?;
            call(|| unsafe { libc::open(path.as_ptr(), libc::O_RDONLY | libc::O_TRUNC).into() })
        }
        "delete" => fs::remove_file(first).map(done),
        "rename" => fs::rename(first, arguments[1]).map(done),
        "hard link" => fs::hard_link(first, arguments[1]).map(done),
        "symbolic link" => symlink(first, arguments[1]).map(done),
        "see" => fs::metadata(first).map(done),
        "list" => fs::read_dir(first).map(done),
        "change mode" => fs::set_permissions(first, Permissions::from_mode(0o777)).map(done),
        "set-user bit" => File::create(first)?.set_permissions(Permissions::from_mode(0o4755)).map(done),
        "change owner" => chown(first, Some(0), Some(0)).map(done),
        "pipe file" => {
            let path = CString::new(first)?;
            call(|| unsafe { libc::mkfifo(path.as_ptr(), 0o666).into() })
        }
        "run" => Err(Command::new(first).args(&arguments[1..]).exec()),
        "run a copy" => {
            fs::copy(env::current_exe()?, first)?;
            fs::set_permissions(first, Permissions::from_mode(0o755))?;
            Err(Command::new(first).arg(ROLE).arg("honest").exec())
        }
        "fork" => call(|| unsafe { fork_and_leave() }),
        "system call" => raw(arguments),
        "signal" => call(|| unsafe { libc::kill(number as i32, libc::SIGTERM).into() }),
        "thread signal" => call(|| unsafe { libc::syscall(libc::SYS_tgkill, number, number, libc::SIGTERM) }),
        "signal by a file" => call(|| unsafe { libc::fcntl(0, libc::F_SETOWN, number as i32).into() }),
        "connect" => TcpStream::connect(first).map(done),
        "send" => UdpSocket::bind("127.0.0.1:0")?.send_to(b"gone", first).map(done),
        "unix socket" => UnixStream::connect(first).map(done),
        "abstract socket" => UnixStream::connect_addr(&SocketAddr::from_abstract_name(first)?).map(done),
        "limits" => {
            let most = libc::rlimit { rlim_cur: libc::RLIM_INFINITY, rlim_max: libc::RLIM_INFINITY };
            call(|| unsafe { libc::setrlimit(libc::RLIMIT_CPU, &most).into() })
        }
        "files left open" => left_open(),
        _ => {
            behave(attack, arguments);
            exit(0)
        }
    }
}

/// Attacks on the machine rather than on others, and what honest programs do.
fn behave(attack: &str, arguments: &[&str]) {
    match attack {
        "honest" => honest(arguments),
        "environment" => {
            env::vars().for_each(|(name, value)| println!("{name}={value}"));
            env::args().for_each(|argument| println!("{argument}"));
        }
        "old numbers" => old_numbers(),
        "abort" => abort(),
        "crash" => unsafe { ptr::null_mut::<u8>().write_volatile(1) },
        "exit" => exit(7),
        "recurse" => println!("{}", recurse(0)),
        "hog memory" => {
            let mut all = Vec::new();
            loop {
                all.push(vec![1_u8; 1 << 20]);
            }
        }
        "threads" => {
            println!("{}", start_threads());
            let _ = io::stdout().flush();
            exit(0);
        }
        "hold threads" => {
            start_threads();
            sleep()
        }
        "open files" => {
            let path = env::current_exe().unwrap();
            let open: Vec<File> = (0..100_000).map_while(|_| File::open(&path).ok()).collect();
            println!("{}", open.len());
        }
        "loop" => endless(),
        "loop on" => {
            unsafe { libc::signal(libc::SIGXCPU, libc::SIG_IGN) };
            endless()
        }
        "sleep" => sleep(),
        "hide and sleep" => {
            unsafe { libc::signal(libc::SIGTERM, libc::SIG_IGN) };
            unsafe { (libc::close(1), libc::close(2)) };
            sleep()
        }
        "flood" => {
            let chunk = [b'x'; 8192];
            while io::stdout().write_all(&chunk).is_ok() && io::stderr().write_all(&chunk).is_ok() {}
        }
        "flood errors" => while io::stderr().write_all(&[b'x'; 8192]).is_ok() {},
        "fill a file" => {
            let mut file = File::create("large").unwrap();
            while file.write_all(&[0; 65536]).is_ok() {}
        }
        "fill the folder" => {
            let mut number = 0_u64;
            loop {
                let _ = File::create(number.to_string());
                number += 1;
            }
        }
        _ => panic!("unknown attack: {attack}"),
    }
}

fn done<T>(_: T) -> String {
    "done".to_owned()
}

fn call(call: impl FnOnce() -> i64) -> io::Result<String> {
    match call() {
        -1 => Err(io::Error::last_os_error()),
        result => Ok(result.to_string()),
    }
}

/// The child does nothing but end: whoever has a child has won.
unsafe fn fork_and_leave() -> i64 {
    let child = unsafe { libc::syscall(libc::SYS_clone, libc::SIGCHLD, 0, 0, 0, 0) };
    if child == 0 {
        unsafe { libc::_exit(0) };
    }
    child
}

/// A system call by its number, with small numbers as arguments, and memory to write to where an argument is `memory`.
fn raw(arguments: &[&str]) -> io::Result<String> {
    let mut memory = [0_u8; 4096];
    let mut numbers = arguments.iter().map(|argument| match *argument {
        "memory" => memory.as_mut_ptr() as i64,
        number => number.parse().unwrap(),
    });
    let mut next = || numbers.next().unwrap_or(0);
    let (number, a, b, c, d, e) = (next(), next(), next(), next(), next(), next());
    call(|| unsafe { libc::syscall(number, a, b, c, d, e) })
}

fn left_open() -> io::Result<String> {
    for descriptor in 3..1024 {
        let mut text = String::new();
        // What is not open fails; nothing else in this program uses these numbers.
        let mut file = std::mem::ManuallyDrop::new(unsafe { File::from_raw_fd(descriptor) });
        if file.read_to_string(&mut text).is_ok() {
            return Ok(text);
        }
    }
    Err(io::Error::other("nothing is open"))
}

/// `getpid` by the numbers of 32-bit programs, of which a filter for 64-bit ones knows nothing.
fn old_numbers() {
    #[cfg(target_arch = "x86_64")]
    {
        let mut result: i64 = 20;
        unsafe { std::arch::asm!("int 0x80", inout("rax") result) };
        println!("{result}");
    }
    #[cfg(not(target_arch = "x86_64"))]
    unsafe {
        libc::raise(libc::SIGSYS)
    };
}

fn honest(arguments: &[&str]) {
    let threads: Vec<_> = (0..4).map(|number| thread::spawn(move || number * 2)).collect();
    let sum: i32 = threads.into_iter().map(|thread| thread.join().unwrap()).sum();
    let read = arguments.first().map(|path| fs::read(path).unwrap().len());
    if let Some(output) = arguments.get(1) {
        fs::write(output, "result").unwrap();
        fs::rename(output, "renamed").unwrap();
        fs::create_dir("made").unwrap();
        fs::copy("renamed", "made/copy").unwrap();
    }
    let name = env::current_exe().unwrap();
    let is_own = Path::new(name.as_os_str()).as_os_str().as_bytes().ends_with(b"attacks");
    println!("{sum} {read:?} {} {is_own}", env::var("GIVEN").unwrap());
}

/// As many as it can have, the first one included. They never end.
fn start_threads() -> u32 {
    let park = || loop {
        thread::park();
    };
    let mut count = 1;
    while count < 20_000 && thread::Builder::new().stack_size(16 * 1024).spawn(park).is_ok() {
        count += 1;
    }
    count
}

#[allow(unconditional_recursion)] // That is the point.
fn recurse(depth: u64) -> u64 {
    let numbers = hint::black_box([depth; 64]);
    recurse(depth + 1) + numbers[7]
}

fn endless() {
    while hint::black_box(true) {}
}

fn sleep() {
    println!("asleep");
    let _ = io::stdout().flush();
    loop {
        thread::sleep(Duration::from_secs(1000));
    }
}
