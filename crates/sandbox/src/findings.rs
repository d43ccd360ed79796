//! What this machine offers, in words for people.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::Layer;

/// Whether this machine offers one layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The layer.
    pub layer: Layer,
    /// Whether a program ran behind it.
    pub available: bool,
    /// Why not.
    pub problem: Option<String>,
    /// What a person can do about it, if that is worth doing.
    pub remedy: Option<String>,
}

/// Tries each layer on this machine. `launcher` and `reads` are as for [`Sandbox::strongest`](crate::Sandbox::strongest),
/// which takes all that are available.
pub fn findings(launcher: &Path, reads: &[PathBuf]) -> Vec<Finding> {
    crate::platform::offers(launcher, reads)
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "  {:<11} {:<4} {}",
            self.layer,
            if self.available { "yes" } else { "no" },
            what_for(self.layer)
        )?;
        for text in [&self.problem, &self.remedy].into_iter().flatten() {
            write!(f, "\n{:19}{text}", "")?;
        }
        Ok(())
    }
}

fn what_for(layer: Layer) -> &'static str {
    match layer {
        Layer::Namespaces => "sees only the files it is given, no other process, no network",
        Layer::OwnUser => "runs as a user of its own, without rights over anybody's files",
        Layer::Cgroup => "memory and threads are counted for each submission",
        Layer::Landlock => "the kernel refuses all other files, and network connections",
        Layer::Seccomp => "the kernel refuses new processes, sockets, debugging and more",
        Layer::Limits => "processor time, memory, size of files, number of open files",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Unavailable;

    #[test]
    fn the_text_says_what_is_missing_and_what_to_do() {
        let there = Finding { layer: Layer::Limits, available: true, problem: None, remedy: None };
        let missing = Finding {
            layer: Layer::Landlock,
            available: false,
            problem: Some("the kernel is old".to_owned()),
            remedy: Some("Update it.".to_owned()),
        };
        let line = "  landlock    no   the kernel refuses all other files, and network connections";
        let more = "\n                   the kernel is old\n                   Update it.";
        assert_eq!(missing.to_string(), format!("{line}{more}"));
        let error = Unavailable { why: "Too little.".to_owned(), findings: vec![there, missing] };
        assert_eq!(error.to_string(), format!("Too little.\n{line}{more}"));
    }
}
