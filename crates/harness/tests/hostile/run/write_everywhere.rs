//! Goes through all folders from the root down, and writes a file wherever it can.
//!
//! expect: graded 15
//! quick: yes

use std::path::Path;

static ONCE: std::sync::OnceLock<Vec<String>> = std::sync::OnceLock::new();

fn attack() {
    let written = ONCE.get_or_init(|| {
        let mut written = Vec::new();
        for folder in ["/", "/tmp", "/var/tmp", "/dev", "/dev/shm", "/run", "/proc/self", "/sys", ".", ".."] {
            write(Path::new(folder), 3, &mut written);
        }
        written
    });
    if !written.is_empty() {
        panic!("{written:?}");
    }
}

fn write(folder: &Path, depth: u32, written: &mut Vec<String>) {
    let file = folder.join("@MARK@-everywhere");
    if std::fs::File::create(&file).is_ok() {
        written.push(file.display().to_string());
    }
    if depth == 0 {
        return;
    }
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries.flatten().take(100) {
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            write(&entry.path(), depth - 1, written);
        }
    }
}
