//! Sees to it that no motion is lost because its name stands where that of a picture belongs.

use std::path::Path;

use super::arguments::Output;
use crate::motion::source::Source;

impl Output {
    /// The file to write.
    pub fn path(&self) -> &Path {
        match self {
            Output::Png(path) | Output::Gif(path) | Output::Apng(path) | Output::Sheet(path) => path,
        }
    }

    /// The option that names it, what it is, and the endings that its name may have.
    fn kind(&self) -> (&'static str, &'static str, &'static [&'static str]) {
        match self {
            Output::Png(_) => ("--png", "picture", &["png"]),
            Output::Gif(_) => ("--gif", "film", &["gif"]),
            Output::Apng(_) => ("--apng", "film", &["png", "apng"]),
            Output::Sheet(_) => ("--sheet", "picture", &["png"]),
        }
    }
}

/// Looks at the name of what is to be written.
pub fn check(output: &Output, sources: &[Source]) -> Result<(), String> {
    let (path, (option, what, endings)) = (output.path(), output.kind());
    let ends_in = |ending: &str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
    let ending = endings[0];
    if ends_in("bvh") {
        let name = path.file_name().unwrap_or_default().display();
        let path = path.display().to_string();
        let quote = if path.contains(' ') { "\"" } else { "" };
        return Err(format!(
            "{option} names the {what} to write; to show {name}: cargo view {quote}{path}{quote} {option} {what}.{ending}"
        ));
    }
    if !endings.iter().any(|ending| ends_in(ending)) {
        return Err(format!(
            "{option} names the {what} to write, and that name ends in .{}: {} does not",
            endings.join(" or ."),
            path.display()
        ));
    }
    for source in sources {
        // Neither can be found when it does not exist; then there is nothing to lose.
        if let (Ok(target), Ok(motion)) = (path.canonicalize(), source.path.canonicalize())
            && target == motion
        {
            return Err(format!("{} is the motion: the {what} needs a name of its own", path.display()));
        }
    }
    Ok(())
}
