//! Notices when the exercise or a motion is saved.
//!
//! The system tells when something happens in a folder: in the folder, since editors often put a new file in the old
//! one's place. What counts is what the files hold: a touch changes nothing, and a file that is gone or empty for a moment
//! is about to come back. Folders from which no word comes, as on some network drives, are looked at twice a second.

mod content;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

use notify::event::{AccessKind, AccessMode};
use notify::{EventKind, RecommendedWatcher, RecursiveMode, Watcher as _};

use content::{Files, Watched};

/// How often the files are looked at when no word comes.
const POLL: Duration = Duration::from_millis(500);

/// What was saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Some file that the exercise's program is built of.
    Exercise,
    /// The file of a motion, of this path as it was given to [`Baseline::now`].
    Motion(PathBuf),
}

/// Watches the exercise and any number of motions. Ends when it is dropped.
pub struct Watcher {
    changes: Receiver<Change>,
    note: Option<String>,
    /// Dropping these ends the thread.
    _system: Option<RecommendedWatcher>,
    _alive: Sender<Heard>,
}

/// What the system said: names of files, or that it may have missed some.
struct Heard(Vec<PathBuf>);

/// What the files hold at some moment: changes are told from this.
pub struct Baseline {
    exercise: Option<PathBuf>,
    motions: Vec<PathBuf>,
    watched: Vec<Watched>,
}

impl Baseline {
    /// What all `*.rs` directly in the folder `exercise`, and the files of each of `motions`, hold now. None of them needs to
    /// exist.
    pub fn now(exercise: &Path, motions: &[Vec<PathBuf>]) -> Baseline {
        Baseline::of(Some(exercise), motions)
    }

    /// What the files of each of `motions` hold now, without an exercise.
    pub fn of_motions(motions: &[Vec<PathBuf>]) -> Baseline {
        Baseline::of(None, motions)
    }

    fn of(exercise: Option<&Path>, motions: &[Vec<PathBuf>]) -> Baseline {
        // Two motions can share a file.
        let motions: BTreeSet<PathBuf> = motions.iter().flatten().cloned().collect();
        let sources = exercise.map(|folder| Watched::new(Files::SourcesIn(folder.to_owned())));
        let ones = motions.iter().map(|path| Watched::new(Files::One(path.clone())));
        let watched = sources.into_iter().chain(ones).collect();
        Baseline { exercise: exercise.map(Path::to_owned), motions: motions.into_iter().collect(), watched }
    }
}

impl Watcher {
    /// Watches the files of `baseline`, and notices what has changed since then.
    ///
    /// `at_once` is called for every change on the thread that notices it, before it is among the
    /// [`changes`](Watcher::changes).
    pub fn start(baseline: Baseline, mut at_once: impl FnMut(&Change) + Send + 'static) -> Watcher {
        let Baseline { exercise, motions, mut watched } = baseline;
        let (alive, heard) = mpsc::channel();
        let folders: BTreeSet<&Path> =
            motions.iter().map(|path| content::folder_of(path)).chain(exercise.as_deref()).collect();
        let (system, trouble) = match listen(&folders, alive.clone()) {
            Ok(system) => (Some(system), None),
            Err(error) => (None, Some(error.to_string())),
        };
        let note = trouble.map(|why| {
            format!("The system does not tell when a file is saved ({why}): it is looked at twice a second instead.")
        });

        let (sender, changes) = mpsc::channel();
        let tell = move |change| {
            at_once(&change);
            sender.send(change).is_ok()
        };
        let work = move || watch(&mut watched, &heard, tell);
        let note = match thread::Builder::new().name("watch".into()).spawn(work) {
            Ok(_) => note,
            Err(error) => Some(format!("Saved files cannot be noticed: {error}")),
        };
        Watcher { changes, note, _system: system, _alive: alive }
    }

    /// What has changed since this was last asked. Does not wait.
    pub fn changes(&mut self) -> impl Iterator<Item = Change> + '_ {
        self.changes.try_iter()
    }

    /// Which of `motions`, each given by its files, are saved anew according to what has [changed](Watcher::changes), counted
    /// from 0.
    pub fn saved_motions(&mut self, motions: &[Vec<PathBuf>]) -> Vec<usize> {
        let changes: Vec<Change> = self.changes().collect();
        let is_news = |file: &PathBuf| changes.contains(&Change::Motion(file.clone()));
        let is_saved = |index: &usize| motions[*index].iter().any(is_news);
        if changes.is_empty() { Vec::new() } else { (0..motions.len()).filter(is_saved).collect() }
    }

    /// What the user should know about how changes are noticed, if anything.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }
}

/// Has the system send word of what happens directly in `folders`.
fn listen(folders: &BTreeSet<&Path>, sender: Sender<Heard>) -> notify::Result<RecommendedWatcher> {
    let tell = move |event: notify::Result<notify::Event>| {
        let names = match event {
            Ok(event) if !matters(event.kind) => return,
            Ok(event) if !event.need_rescan() => event.paths,
            Ok(_) | Err(_) => Vec::new(),
        };
        // Nobody listens any more only when the watcher is about to go.
        let _ = sender.send(Heard(names));
    };
    let mut system = notify::recommended_watcher(tell)?;
    for folder in folders {
        system.watch(folder, RecursiveMode::NonRecursive)?;
    }
    Ok(system)
}

/// Reading changes nothing; and reading is what looking at the files does.
fn matters(kind: EventKind) -> bool {
    match kind {
        EventKind::Access(access) => access == AccessKind::Close(AccessMode::Write),
        _ => true,
    }
}

/// Looks at the files whenever word comes, or it is time to, until the watcher has gone.
fn watch(watched: &mut [Watched], heard: &Receiver<Heard>, mut tell: impl FnMut(Change) -> bool) {
    loop {
        for one in watched.iter_mut() {
            if one.look(Instant::now()) {
                let change = match one.files() {
                    Files::SourcesIn(_) => Change::Exercise,
                    Files::One(path) => Change::Motion(path.clone()),
                };
                if !tell(change) {
                    return;
                }
            }
        }
        let now = Instant::now();
        let next = watched.iter().filter_map(Watched::due).min();
        let wait = next.map_or(POLL, |due| due.saturating_duration_since(now).min(POLL));
        match heard.recv_timeout(wait) {
            Ok(first) => {
                for Heard(names) in [first].into_iter().chain(heard.try_iter()) {
                    watched.iter_mut().for_each(|one| one.hear(&names));
                }
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}
