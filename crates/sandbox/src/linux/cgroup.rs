//! Memory and tasks of a slot, counted by a control group (version 1 or 2).

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::Limits;
use crate::unix::Context;

/// How our groups' names begin. Then follow the process and a number.
const PREFIX: &str = "fk-lab-sandbox-";

/// The groups of one sandbox. They are removed with it.
pub struct Cgroups {
    parents: Parents,
    number: u32,
    others: u32,
    groups: Mutex<HashMap<Key, Group>>,
}

/// Version 1 has a tree for memory and one for tasks, version 2 one for both.
enum Parents {
    One { memory: PathBuf, tasks: PathBuf },
    Two(PathBuf),
}

/// Programs of one slot and with the same limits share a group, one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Key {
    slot: u32,
    memory: u64,
    tasks: u32,
}

struct Group {
    folders: Vec<PathBuf>,
    /// The files in which a process joins.
    joins: Vec<PathBuf>,
    /// Where the system counts whom it ended to get memory back, and the last count.
    counter: PathBuf,
    killed: u64,
}

impl Cgroups {
    /// Finds the place for groups. That one can be made there turns out with the first.
    ///
    /// Besides the program's threads, `others` tasks are in each group.
    pub fn open(others: u32) -> Result<Cgroups, String> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let own = fs::read_to_string("/proc/self/cgroup").context("read this process's control groups")?;
        let parents = Parents::find(&own).ok_or("neither a memory nor a tasks controller is mounted")?;
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let cgroups = Cgroups { parents, number, others, groups: Mutex::default() };
        cgroups.remove_leftovers();
        Ok(cgroups)
    }

    /// The files into which a process of `slot` writes 0 to join its groups.
    pub fn files(&self, slot: u32, limits: &Limits) -> io::Result<Vec<PathBuf>> {
        let key = self.key(slot, limits);
        let mut groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(group) = groups.get(&key) {
            return Ok(group.joins.clone());
        }
        let name = format!("{PREFIX}{}-{}-{}", process::id(), self.number, groups.len());
        let group = self.parents.make(&name, key)?;
        let joins = group.joins.clone();
        groups.insert(key, group);
        Ok(joins)
    }

    /// Whether the system has ended a process of this group since the last call.
    pub fn killed(&self, slot: u32, limits: &Limits) -> bool {
        let mut groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(group) = groups.get_mut(&self.key(slot, limits)) else { return false };
        let before = group.killed;
        group.killed = group.count();
        group.killed > before
    }

    fn key(&self, slot: u32, limits: &Limits) -> Key {
        Key { slot, memory: limits.memory, tasks: limits.threads.saturating_add(self.others) }
    }

    /// Removes groups of processes that were ended before they could do so.
    fn remove_leftovers(&self) {
        for parent in self.parents.folders() {
            let Ok(entries) = fs::read_dir(parent) else { continue };
            for entry in entries.flatten() {
                let name = entry.file_name();
                let rest = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
                let owner = rest.and_then(|rest| rest.split('-').next()?.parse::<u32>().ok());
                if owner.is_some_and(|owner| !Path::new(&format!("/proc/{owner}")).exists()) {
                    let _ = fs::remove_dir(entry.path());
                }
            }
        }
    }
}

impl Drop for Cgroups {
    fn drop(&mut self) {
        let groups = self.groups.get_mut().unwrap_or_else(PoisonError::into_inner);
        for folder in groups.values().flat_map(|group| &group.folders) {
            let _ = fs::remove_dir(folder);
        }
    }
}

impl Parents {
    /// From the lines of `/proc/self/cgroup`: `number:controllers:path`. Groups are made below the own one, so that its
    /// limits hold for them too.
    fn find(own: &str) -> Option<Parents> {
        let mut lines = own.lines().filter_map(|line| {
            let mut parts = line.splitn(3, ':').skip(1);
            Some((parts.next()?, parts.next()?))
        });
        let version_one = |name: &str| {
            let mut all = own.lines().filter_map(|line| line.split_once(':')?.1.split_once(':'));
            let path = all.find(|(names, _)| names.split(',').any(|other| other == name))?.1;
            let root = Path::new("/sys/fs/cgroup").join(name);
            // In a container the path may be one that only the host knows.
            let inner = root.join(path.trim_start_matches('/'));
            [inner, root].into_iter().find(|folder| folder.join("tasks").exists())
        };
        if let (Some(memory), Some(tasks)) = (version_one("memory"), version_one("pids")) {
            return Some(Parents::One { memory, tasks });
        }
        let own = lines.find(|(names, _)| names.is_empty())?.1;
        let root = Path::new("/sys/fs/cgroup");
        // A group that holds processes passes no controllers on, but one above it does.
        let own = root.join(own.trim_start_matches('/'));
        let above = own.ancestors().take_while(|folder| folder.starts_with(root));
        let passes_on = |folder: &&Path| {
            let passed = fs::read_to_string(folder.join("cgroup.subtree_control")).unwrap_or_default();
            ["memory", "pids"].iter().all(|name| passed.split_whitespace().any(|word| word == *name))
        };
        above.filter(passes_on).map(Path::to_path_buf).next().map(Parents::Two)
    }

    fn folders(&self) -> Vec<&Path> {
        match self {
            Parents::One { memory, tasks } => vec![memory, tasks],
            Parents::Two(both) => vec![both],
        }
    }

    fn make(&self, name: &str, key: Key) -> io::Result<Group> {
        let folders: Vec<PathBuf> = self.folders().iter().map(|parent| parent.join(name)).collect();
        for folder in &folders {
            let explain = |error: io::Error| {
                io::Error::new(
                    error.kind(),
                    format!("could not make the group {}: {error}", folder.display()),
                )
            };
            fs::create_dir(folder).map_err(explain)?;
        }
        let tasks = key.tasks.to_string();
        let memory = key.memory.to_string();
        match &folders[..] {
            [memory_folder, tasks_folder] => {
                fs::write(memory_folder.join("memory.limit_in_bytes"), memory)?;
                fs::write(tasks_folder.join("pids.max"), tasks)?;
                // `tasks` moves the calling thread alone, the only one: `cgroup.procs` would wait for milliseconds.
                let joins = folders.iter().map(|folder| folder.join("tasks")).collect();
                let counter = memory_folder.join("memory.oom_control");
                Ok(Group { joins, counter, folders, killed: 0 })
            }
            folder => {
                let folder = folder.first().ok_or(io::ErrorKind::NotFound)?;
                fs::write(folder.join("memory.max"), memory)?;
                // Not every system counts what is swapped out.
                let _ = fs::write(folder.join("memory.swap.max"), "0");
                fs::write(folder.join("pids.max"), tasks)?;
                let (joins, counter) = (vec![folder.join("cgroup.procs")], folder.join("memory.events"));
                Ok(Group { joins, counter, folders, killed: 0 })
            }
        }
    }
}

impl Group {
    /// The number after `oom_kill`.
    fn count(&self) -> u64 {
        let text = fs::read_to_string(&self.counter).unwrap_or_default();
        let number = text.lines().find_map(|line| line.strip_prefix("oom_kill ")?.trim().parse().ok());
        number.unwrap_or(0)
    }
}
