//! Sees to it that no motion is lost because its name stands where that of a picture belongs, or of another motion.

use std::borrow::Cow;
use std::path::Path;

use parser::printable;

use super::arguments::Output;
use crate::motion::source::{self, Source};

/// The endings of files that can be shown.
const MOTIONS: [&str; 3] = ["bvh", "amc", "asf"];

/// A file to write.
#[derive(Clone, Debug)]
pub struct Target<'a> {
    /// Where.
    pub path: Cow<'a, Path>,
    /// The option that names it.
    pub option: &'static str,
    /// What it is.
    pub what: &'static str,
    /// The endings that its name may have, the usual one first.
    pub endings: &'static [&'static str],
    /// Whether it may take the place of what is there: of a picture, which can be made again, but not of any motion.
    pub may_replace: bool,
}

impl Output {
    /// The file to write.
    pub fn path(&self) -> &Path {
        match self {
            Output::Png(path) | Output::Gif(path) | Output::Apng(path) | Output::Sheet(path) => path,
        }
    }

    /// What is known of it before it is written.
    pub fn target(&self) -> Target<'_> {
        let (option, what, endings): (_, _, &[&str]) = match self {
            Output::Png(_) => ("--png", "picture", &["png"]),
            Output::Gif(_) => ("--gif", "film", &["gif"]),
            Output::Apng(_) => ("--apng", "film", &["png", "apng"]),
            Output::Sheet(_) => ("--sheet", "picture", &["png"]),
        };
        Target { path: self.path().into(), option, what, endings, may_replace: true }
    }
}

/// Endings as people list them, behind the first point.
fn list(endings: &[&str]) -> String {
    match endings {
        [others @ .., last] if others.len() > 1 => format!("{} or .{last}", others.join(", .")),
        _ => endings.join(" or ."),
    }
}

/// A path for people and terminals.
pub fn shown(path: &Path) -> String {
    printable(&path.display().to_string())
}

/// A path as one would write it in a command.
pub fn shown_in_command(path: &Path) -> String {
    let path = shown(path);
    let is_plain = |c: char| c.is_alphanumeric() || "._-+/\\:,=@%".contains(c);
    // Between double quotes a shell still reads these.
    let quote = match () {
        () if !path.is_empty() && path.chars().all(is_plain) => "",
        () if path.contains(['"', '$', '`', '!']) && !path.contains('\'') => "'",
        () => "\"",
    };
    format!("{quote}{path}{quote}")
}

/// Looks at where something is to be written, before any work is done for it.
///
/// # Errors
///
/// When it cannot be written there, or something would be lost.
pub fn check(target: Target, sources: &[Source]) -> Result<(), String> {
    let Target { ref path, option, what, endings, may_replace } = target;
    let ends_in = |ending: &str| source::ends_in(path, ending);
    let ending = endings[0];
    let is_motion = MOTIONS.into_iter().any(ends_in);
    if is_motion && !endings.iter().any(|ending| MOTIONS.contains(ending)) {
        let name = printable(&path.file_name().unwrap_or_default().display().to_string());
        let path = shown_in_command(path);
        return Err(format!(
            "{option} names the {what} to write; to show {name}: cargo view {path} {option} {what}.{ending}"
        ));
    }
    if !endings.iter().any(|ending| ends_in(ending)) {
        return Err(format!(
            "{option} names the {what} to write, and that name ends in .{}: {} does not",
            list(endings),
            shown(path)
        ));
    }
    for file in sources.iter().flat_map(Source::files) {
        // Neither can be found when it does not exist; then there is nothing to lose.
        if let (Ok(target), Ok(read)) = (path.canonicalize(), file.canonicalize())
            && target == read
        {
            let is = if source::ends_in(&file, "asf") { "skeleton" } else { "motion" };
            return Err(format!("{} is the {is}: the {what} needs a name of its own", shown(path)));
        }
    }
    if path.is_dir() {
        return Err(format!("{} is a folder: the {what} needs a name of its own", shown(path)));
    }
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()) {
        let is = if folder.exists() { "is no folder" } else { "is not there" };
        return Err(format!(
            "the {what} cannot be written to {}: the folder {} {is}; make it first, or choose another",
            shown(path),
            shown(folder)
        ));
    }
    // A link is there, even if it leads nowhere.
    if !may_replace && path.symlink_metadata().is_ok() {
        return Err(format!(
            "{} is there already: choose another name, or add --overwrite to put the {what} in its place",
            shown(path)
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_in_a_command_is_one_word_of_it() {
        for (path, word) in [
            ("data/walk-2.bvh", "data/walk-2.bvh"),
            ("my files/walk.bvh", "\"my files/walk.bvh\""),
            ("a(1).bvh", "\"a(1).bvh\""),
            ("it's.bvh", "\"it's.bvh\""),
            ("$x `y` \"z\".bvh", "'$x `y` \"z\".bvh'"),
        ] {
            assert_eq!(shown_in_command(Path::new(path)), word);
        }
    }
}
