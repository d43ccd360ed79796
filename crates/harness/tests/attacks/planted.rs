//! What lies around a run for attacks to reach: a secret, folders, services. And how it is found out whether one did.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::net::{TcpListener, UdpSocket};
use std::os::linux::net::SocketAddrExt;
use std::os::unix::fs::{MetadataExt, PermissionsExt, lchown};
use std::os::unix::net::{SocketAddr, UnixListener};
use std::path::{Path, PathBuf};

use tempfile::TempDir;

/// What the secret file holds. It must come out nowhere.
pub const WORD: &str = "Rumpelstilzchen";

/// The key under which the attacks would leave things in the kernel: `FKLB`.
const KERNEL_KEY: u32 = 0x464b_4c42;

/// Names of files that archives would leave behind if they were extracted or built.
const SLIPPED: &str = "fk-lab-slipped";

pub struct Planted {
    base: TempDir,
    mark: String,
    tcp: TcpListener,
    udp: UdpSocket,
    unix: UnixListener,
    hidden: UnixListener,
}

impl Planted {
    pub fn new() -> Planted {
        let base = tempfile::Builder::new().prefix("fk-lab attacks ").tempdir().unwrap();
        let path = base.path();
        let permit = |path: &Path, mode| fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
        permit(path, 0o755);
        fs::write(path.join("secret"), format!("{WORD} is my name\n")).unwrap();
        for folder in ["given", "outside/removable", "outside/inner"] {
            fs::create_dir_all(path.join(folder)).unwrap();
        }
        for file in ["outside/changeable", "outside/movable", "outside/removable/file"] {
            fs::write(path.join(file), "as it was").unwrap();
        }
        permit(&path.join("outside"), 0o777);

        // The folder's own ending makes it unlike that of any other run.
        let folder = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mark = format!("fk-lab-mark-{}", folder.rsplit(' ').next().unwrap_or_default());
        let unix = UnixListener::bind(path.join("service")).unwrap();
        permit(&path.join("service"), 0o777);
        let name = SocketAddr::from_abstract_name(format!("{mark}-service")).unwrap();
        let planted = Planted {
            mark,
            tcp: TcpListener::bind("127.0.0.1:0").unwrap(),
            udp: UdpSocket::bind("127.0.0.1:0").unwrap(),
            unix,
            hidden: UnixListener::bind_addr(&name).unwrap(),
            base,
        };
        planted.tcp.set_nonblocking(true).unwrap();
        planted.udp.set_nonblocking(true).unwrap();
        planted.unix.set_nonblocking(true).unwrap();
        planted.hidden.set_nonblocking(true).unwrap();
        planted
    }

    pub fn path(&self) -> &Path {
        self.base.path()
    }

    /// The folder of submissions.
    pub fn given(&self) -> PathBuf {
        self.path().join("given")
    }

    /// The folder of the run.
    pub fn out(&self) -> PathBuf {
        self.path().join("out")
    }

    /// What the words between `@` in the attacks stand for. `neighbour` is a file in the folder of submissions.
    pub fn names(&self, neighbour: &str) -> BTreeMap<&'static str, String> {
        let show = |path: PathBuf| path.display().to_string();
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap();
        let names = [
            ("SECRET", show(self.path().join("secret"))),
            ("WORD", WORD.to_owned()),
            ("NEIGHBOUR", show(self.given().join(neighbour))),
            ("SUBMISSIONS", show(self.given())),
            ("SOLUTION", show(workspace.join("solutions/src/fk.rs"))),
            ("OUT", show(self.out())),
            ("JOURNAL", show(self.out().join("journal.jsonl"))),
            ("OUTSIDE", show(self.path().join("outside"))),
            ("TCP", self.tcp.local_addr().unwrap().port().to_string()),
            ("UDP", self.udp.local_addr().unwrap().port().to_string()),
            ("UNIX", show(self.path().join("service"))),
            ("ABSTRACT", format!("{}-service", self.mark)),
            ("MARK", self.mark.clone()),
        ];
        names.into()
    }

    /// Everything that must stay as it is: names, sizes, times, owners and permissions.
    pub fn snapshot(&self) -> BTreeMap<PathBuf, String> {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap();
        let mut found = BTreeMap::new();
        for place in [self.path().join("secret"), self.path().join("outside"), self.given()] {
            walk(&place, &mut found);
        }
        for place in ["solutions/src", "solutions/templates", "exercises/fk"] {
            walk(&workspace.join(place), &mut found);
        }
        found
    }

    /// Files with the attacks' own names, wherever anybody may write.
    pub fn left_behind(&self) -> Vec<PathBuf> {
        let places =
            ["/", "/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run", "/run/lock"].map(PathBuf::from);
        let mut left = Vec::new();
        for place in places.into_iter().chain([self.path().join("outside"), self.given(), self.out()]) {
            let entries =
                fs::read_dir(place).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
            left.extend(entries.filter(|path| {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                name.contains(&self.mark) || name.contains(SLIPPED) || name == "fk-lab-queue"
            }));
        }
        for kind in ["shm", "msg", "sem"] {
            let table = PathBuf::from(format!("/proc/sysvipc/{kind}"));
            let text = fs::read_to_string(&table).unwrap_or_default();
            let is_ours = |line: &str| line.split_whitespace().next() == Some(&KERNEL_KEY.to_string());
            if text.lines().any(is_ours) {
                left.push(table);
            }
        }
        left
    }

    /// Which services were called.
    pub fn called(&self) -> Vec<&'static str> {
        let waits = |error: io::Error| assert_eq!(error.kind(), io::ErrorKind::WouldBlock, "{error}");
        let calls = [
            ("tcp", self.tcp.accept().map(|_| ()).map_err(waits).is_ok()),
            ("udp", self.udp.recv(&mut [0; 64]).map(|_| ()).map_err(waits).is_ok()),
            ("unix", self.unix.accept().map(|_| ()).map_err(waits).is_ok()),
            ("abstract", self.hidden.accept().map(|_| ()).map_err(waits).is_ok()),
        ];
        calls.into_iter().filter(|(_, called)| *called).map(|(name, _)| name).collect()
    }
}

/// Gives a folder and everything in it to another user.
pub fn give_to(path: &Path, user: u32) {
    lchown(path, Some(user), Some(user)).unwrap();
    if path.is_dir() && !path.is_symlink() {
        for entry in fs::read_dir(path).unwrap() {
            give_to(&entry.unwrap().path(), user);
        }
    }
}

fn walk(path: &Path, found: &mut BTreeMap<PathBuf, String>) {
    let Ok(metadata) = fs::symlink_metadata(path) else { return };
    let modified = (metadata.mtime(), metadata.mtime_nsec());
    let (mode, user, size) = (metadata.mode(), metadata.uid(), metadata.len());
    found.insert(path.to_path_buf(), format!("{mode:o} of {user}, {size} bytes, changed at {modified:?}"));
    if metadata.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            walk(&entry.unwrap().path(), found);
        }
    }
}

/// Every file below a folder.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = BTreeMap::new();
    walk(folder, &mut found);
    found.into_keys().filter(|path| path.is_file() && !path.is_symlink()).collect()
}
