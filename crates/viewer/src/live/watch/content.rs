//! What files hold, and when a change of it counts.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hasher};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// Editors write more than once for one save. Whole content counts when it has stayed the same for some time, and at the
/// latest some time after the first change. A student waits for every millisecond; a motion may be long, and takes longer
/// to write and to read.
const SETTLED: [Duration; 2] = [Duration::from_millis(3), Duration::from_millis(12)];
const SETTLED_MOTION: [Duration; 2] = [Duration::from_millis(60), Duration::from_millis(2000)];

/// A file that is gone or empty counts as that when it has stayed so for this long.
const LASTING: Duration = Duration::from_millis(300);

/// Which files are looked at together.
pub(super) enum Files {
    /// All `*.rs` directly in a folder.
    SourcesIn(PathBuf),
    /// A single file.
    One(PathBuf),
}

/// Files, what they held when that last counted as a change, and what they hold since then.
pub(super) struct Watched {
    files: Files,
    /// Changes are told from this.
    told: Contents,
    stamps: Stamps,
    news: Option<News>,
    /// Whether the files have to be read, whatever their stamps say.
    heard: bool,
}

/// Content that has not counted yet.
struct News {
    contents: Contents,
    since: Instant,
    /// Since when anything at all is new.
    first: Instant,
    due: Instant,
}

/// Length and hash of every file that is there, by name.
type Contents = BTreeMap<OsString, (u64, u64)>;

/// Length and time of every file that is there: when these are the same, nothing was written.
type Stamps = BTreeMap<OsString, (u64, Option<SystemTime>)>;

impl Watched {
    pub(super) fn new(files: Files) -> Watched {
        let (stamps, told) = (files.stamps(), files.contents());
        // Something may have happened before the system was listened to.
        Watched { files, told, stamps, news: None, heard: true }
    }

    pub(super) fn files(&self) -> &Files {
        &self.files
    }

    /// Something happened to the files of these paths, or to any file when there are none.
    pub(super) fn hear(&mut self, paths: &[PathBuf]) {
        // Only names are compared: the system may know the folder by another path.
        let mine = |path: &PathBuf| match &self.files {
            Files::SourcesIn(_) => is_source(path),
            Files::One(own) => path.file_name() == own.file_name(),
        };
        self.heard |= paths.is_empty() || paths.iter().any(mine);
    }

    /// When to look again, at the latest.
    pub(super) fn due(&self) -> Option<Instant> {
        self.news.as_ref().map(|news| news.due)
    }

    /// Looks at the files, and gives whether a change counts now.
    pub(super) fn look(&mut self, now: Instant) -> bool {
        let stamps = self.files.stamps();
        let heard = std::mem::take(&mut self.heard);
        if !heard && self.news.is_none() && stamps == self.stamps {
            return false;
        }
        self.stamps = stamps;
        let contents = self.files.contents();
        self.consider(contents, now)
    }

    fn consider(&mut self, contents: Contents, now: Instant) -> bool {
        if contents == self.told {
            self.news = None;
            return false;
        }
        let (since, first) = match &self.news {
            Some(news) if news.contents == contents => (news.since, news.first),
            Some(news) => (now, news.first),
            None => (now, now),
        };
        let [settled, latest] = match self.files {
            Files::SourcesIn(_) => SETTLED,
            Files::One(_) => SETTLED_MOTION,
        };
        let due =
            if self.has_hole(&contents) { since + LASTING } else { (since + settled).min(first + latest) };
        if now >= due {
            self.told = contents;
            self.news = None;
            return true;
        }
        self.news = Some(News { contents, since, first, due });
        false
    }

    /// Whether a file is empty, or one is missing that was there.
    fn has_hole(&self, contents: &Contents) -> bool {
        let was_empty = |name| self.told.get(name).is_some_and(|(length, _)| *length == 0);
        contents.iter().any(|(name, (length, _))| *length == 0 && !was_empty(name))
            || self.told.keys().any(|name| !contents.contains_key(name))
            || contents.is_empty()
    }
}

impl Files {
    fn list(&self) -> Vec<PathBuf> {
        match self {
            Files::One(path) => vec![path.clone()],
            Files::SourcesIn(folder) => {
                let entries = fs::read_dir(folder).into_iter().flatten().flatten();
                entries.map(|entry| entry.path()).filter(|path| is_source(path)).collect()
            }
        }
    }

    fn stamps(&self) -> Stamps {
        let stamp = |path: PathBuf| {
            let metadata = fs::metadata(&path).ok().filter(|metadata| metadata.is_file())?;
            Some((path.file_name()?.to_owned(), (metadata.len(), metadata.modified().ok())))
        };
        self.list().into_iter().filter_map(stamp).collect()
    }

    fn contents(&self) -> Contents {
        let content = |path: PathBuf| Some((path.file_name()?.to_owned(), read(&path)?));
        self.list().into_iter().filter_map(content).collect()
    }
}

/// Length and hash of the file, if it is one and can be read.
fn read(path: &Path) -> Option<(u64, u64)> {
    // A pipe would keep whoever opens it waiting.
    fs::metadata(path).ok().filter(|metadata| metadata.is_file())?;
    let mut file = File::open(path).ok()?;
    let (mut hasher, mut length) = (DefaultHasher::new(), 0);
    let mut chunk = vec![0; 64 * 1024];
    loop {
        match file.read(&mut chunk).ok()? {
            0 => return Some((length, hasher.finish())),
            count => {
                hasher.write(&chunk[..count]);
                length += count as u64;
            }
        }
    }
}

/// Editors' own files, such as `.#fk.rs` and `.fk.rs.swp`, are not among the sources.
fn is_source(path: &Path) -> bool {
    let hidden = path.file_name().is_none_or(|name| name.as_encoded_bytes().starts_with(b"."));
    !hidden && path.extension().is_some_and(|extension| extension == "rs")
}

/// The folder that a file is in.
pub(super) fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contents(length: u64, hash: u64) -> Contents {
        Contents::from([("fk.rs".into(), (length, hash))])
    }

    fn watched() -> (Watched, Instant) {
        watched_as(Files::SourcesIn("src".into()))
    }

    fn watched_as(files: Files) -> (Watched, Instant) {
        let told = contents(100, 1);
        (Watched { files, told, stamps: Stamps::new(), news: None, heard: false }, Instant::now())
    }

    #[test]
    fn new_content_counts_once_and_as_soon_as_it_has_settled() {
        let (mut watched, start) = watched();
        assert!(!watched.consider(contents(100, 2), start));
        assert_eq!(watched.due(), Some(start + SETTLED[0]));
        assert!(watched.consider(contents(100, 2), start + SETTLED[0]));
        assert!(!watched.consider(contents(100, 2), start + 2 * SETTLED[0]));
        assert_eq!(watched.due(), None);
    }

    #[test]
    fn content_that_goes_on_changing_counts_after_a_while_and_so_does_the_last() {
        let (mut watched, start) = watched();
        let step = Duration::from_millis(1);
        let counted =
            (0..100).filter(|i| watched.consider(contents(100, 2 + u64::from(*i)), start + *i * step));
        assert!((2..20).contains(&counted.count()));
        assert!(watched.consider(contents(100, 101), start + 200 * step), "the last one");
    }

    #[test]
    fn a_long_motion_may_take_its_time_to_be_written() {
        let (mut watched, start) = watched_as(Files::One("fk.rs".into()));
        let step = Duration::from_millis(20);
        for piece in 0..40 {
            assert!(
                !watched.consider(contents(100 + u64::from(piece), 2), start + piece * step),
                "not all of it"
            );
        }
        assert!(watched.consider(contents(139, 2), start + 44 * step));
    }

    #[test]
    fn a_neighbour_that_has_always_been_empty_keeps_nobody_waiting() {
        let (mut watched, start) = watched();
        let with_neighbour = |hash| {
            let mut contents = contents(100, hash);
            contents.insert("notes.rs".into(), (0, 0));
            contents
        };
        watched.told = with_neighbour(1);
        assert!(!watched.consider(with_neighbour(2), start));
        assert!(watched.consider(with_neighbour(2), start + SETTLED[0]));
    }

    #[test]
    fn a_file_that_is_gone_or_empty_for_a_moment_is_no_change() {
        for hole in [contents(0, 0), Contents::new()] {
            let (mut watched, start) = watched();
            assert!(!watched.consider(hole.clone(), start));
            assert!(!watched.consider(hole.clone(), start + LASTING / 2));
            assert!(!watched.consider(contents(100, 1), start + LASTING), "it is as it was");

            let later = start + 2 * LASTING;
            assert!(!watched.consider(hole.clone(), later));
            assert!(watched.consider(hole, later + LASTING), "it has stayed so");
        }
    }

    #[test]
    fn editors_own_files_are_not_sources() {
        for (name, expected) in
            [("fk.rs", true), (".#fk.rs", false), (".fk.rs.swp", false), ("fk.rs~", false), ("4913", false)]
        {
            assert_eq!(is_source(&Path::new("a folder").join(name)), expected, "{name}");
        }
    }
}
