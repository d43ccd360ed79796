use sandbox::*;
use std::time::*;
fn main() {
    enter_if_asked();
    let me = std::env::current_exe().unwrap();
    let sysroot =
        std::env::var("TC").unwrap_or("/root/.rustup/toolchains/1.95.0-x86_64-unknown-linux-gnu".into());
    let mut reads = system_libraries();
    reads.push(sysroot.clone().into());
    for f in findings(&me, &reads) {
        println!("{f}");
    }
    let s = match Sandbox::strongest(me.clone(), &reads) {
        Ok(s) => s,
        Err(e) => {
            println!("{e}");
            return;
        }
    };
    println!("{}", s.layers());
    let d = tempfile::tempdir().unwrap();
    std::fs::write(d.path().join("a.rs"), "pub fn f(x: f32) -> f32 { x.sin() } fn main(){println!(\"{}\", f(1.0)); std::thread::spawn(||std::process::abort()).join();}").unwrap();
    let limits = Limits {
        cpu: Duration::from_secs(5),
        wall: Duration::from_secs(9),
        memory: 3 << 30,
        threads: 64,
        output: 1 << 20,
        file_size: 1 << 26,
    };
    let c = Confinement {
        read: reads.clone(),
        folder: Some(d.path().to_path_buf()),
        environment: vec![("TMPDIR".into(), d.path().into())],
        limits,
    };
    let t = Instant::now();
    let r = s.run(
        0,
        &c,
        format!("{sysroot}/bin/rustc").as_ref(),
        &["--edition".into(), "2024".into(), "--emit=obj".into(), "a.rs".into()],
    );
    println!(
        "{:?} {:?}",
        t.elapsed(),
        r.map(|f| (f.status, f.limit, f.cpu, String::from_utf8_lossy(&f.stderr).into_owned(), f.stdout))
    );
    println!("{:?}", std::fs::read_dir(d.path()).unwrap().map(|e| e.unwrap().path()).collect::<Vec<_>>());
    for _ in 0..5 {
        let t = Instant::now();
        let mut c = c.clone();
        c.folder = None;
        c.read.push("/bin/true".into());
        let r = s.run(0, &c, "/bin/true".as_ref(), &[]).unwrap();
        println!("{:?} {:?} {:?}", t.elapsed(), r.cpu, r.status);
    }
}
