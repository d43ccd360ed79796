//! From the files on the command line to motions: a skeleton of bones and its motion are in two files.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::targets::{shown, shown_in_command};
use crate::motion::source::{Source, ends_in};

/// So many skeletons are listed.
const MOST_LISTED: usize = 5;

/// One motion for each file, but for the skeletons of bones that a motion among the files needs. `source` makes a motion of a
/// path.
///
/// # Errors
///
/// When it is not known which skeleton a motion moves.
pub fn sources(files: &[PathBuf], source: impl Fn(PathBuf) -> Source) -> Result<Vec<Source>, String> {
    let mut sources = Vec::new();
    let mut used = vec![false; files.len()];
    for (at, file) in files.iter().enumerate().filter(|(_, file)| ends_in(file, "amc")) {
        // The skeleton in front of the motion, or else the first one behind it.
        let is_skeleton = |at: &usize| ends_in(&files[*at], "asf");
        let named = (0..at).rev().find(is_skeleton).or_else(|| (at..files.len()).find(is_skeleton));
        let skeleton = match named {
            Some(named) => {
                used[named] = true;
                files[named].clone()
            }
            None => beside(file)?,
        };
        sources.push((at, Source { skeleton: Some(skeleton), ..source(file.clone()) }));
    }
    for (at, file) in files.iter().enumerate().filter(|(_, file)| !ends_in(file, "amc")) {
        if !used[at] {
            sources.push((at, source(file.clone())));
        }
    }
    sources.sort_by_key(|(at, _)| *at);
    Ok(sources.into_iter().map(|(_, source)| source).collect())
}

/// The skeleton in the folder of a motion: that of the same name, or of the beginning of its name, as `35.asf` with
/// `35_01.amc`; otherwise the only one there.
///
/// # Errors
///
/// When it is none of these, with what there is, or when the folder cannot be listed.
fn beside(motion: &Path) -> Result<PathBuf, String> {
    let folder = motion.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    chosen(motion, folder, skeletons(folder))
}

/// The skeletons in a folder, in the order of their names: so that the same one is chosen everywhere.
fn skeletons(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    let files = entries.into_iter().map(|entry| entry.path());
    let mut skeletons: Vec<PathBuf> = files.filter(|file| ends_in(file, "asf") && !file.is_dir()).collect();
    skeletons.sort();
    Ok(skeletons)
}

/// The one of a motion among the `skeletons` in its folder.
fn chosen(motion: &Path, folder: &Path, skeletons: io::Result<Vec<PathBuf>>) -> Result<PathBuf, String> {
    match skeletons {
        Ok(skeletons) => {
            named(motion, &skeletons).cloned().ok_or_else(|| missing(motion, &among(&skeletons)))
        }
        Err(error) => {
            Err(missing(motion, &format!("the folder {} cannot be listed: {error}", shown(folder))))
        }
    }
}

/// The one of these skeletons that belongs to a motion, if that is clear.
fn named<'a>(motion: &Path, skeletons: &'a [PathBuf]) -> Option<&'a PathBuf> {
    let stem = |file: &Path| file.file_stem().map(|stem| stem.to_string_lossy().to_lowercase());
    let name = stem(motion)?;
    let begins = |skeleton: &PathBuf| {
        let rest = name.strip_prefix(stem(skeleton)?.as_str())?;
        (!rest.starts_with(char::is_alphanumeric)).then_some(rest.len())
    };
    let named = skeletons
        .iter()
        .filter(|skeleton| begins(skeleton).is_some())
        .min_by_key(|skeleton| begins(skeleton));
    named.or(skeletons.first().filter(|_| skeletons.len() == 1))
}

/// Sees to it that all motions have bones.
///
/// # Errors
///
/// When one has joints instead.
pub fn check_bones(sources: &[Source]) -> Result<(), String> {
    let Some(source) = sources.iter().find(|source| !source.has_bones()) else { return Ok(()) };
    let converted = source.path.with_extension("amc");
    let [file, converted] = [source.path.as_path(), &converted].map(shown_in_command);
    Err(format!(
        "{} holds joints, and this exercise moves bones: it needs a skeleton in an .asf file and its motion in an .amc file, \
         as data/walk.asf and data/walk.amc. A motion of joints can be converted where its joints allow it: \
         cargo view {file} --out {converted}",
        source.title()
    ))
}

/// What there is in the folder of a motion to which none of these skeletons belongs.
fn among(skeletons: &[PathBuf]) -> String {
    let name = |skeleton: &PathBuf| shown(Path::new(skeleton.file_name().unwrap_or_default()));
    let listed: Vec<String> = skeletons.iter().take(MOST_LISTED).map(name).collect();
    match skeletons.len() - listed.len() {
        0 if listed.is_empty() => "there is none in its folder".into(),
        0 => format!("none in its folder has its name ({})", listed.join(", ")),
        more => format!("none in its folder has its name ({}, and {more} more)", listed.join(", ")),
    }
}

/// Why there is no skeleton for a motion: the motion is not there, or this about its folder.
fn missing(motion: &Path, there: &str) -> String {
    if let Err(error) = fs::metadata(motion) {
        return format!("{}: cannot be opened: {error}", shown(motion));
    }
    format!(
        "{} is the motion of a skeleton that is in another file, an .asf file, and {there}; name it in front of the motion: \
         cargo view SKELETON.asf {}",
        shown(motion),
        shown_in_command(motion)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[&str]) -> Vec<(String, Option<String>)> {
        let files: Vec<PathBuf> = files.iter().map(PathBuf::from).collect();
        let text = |path: &Path| path.display().to_string();
        let sources = sources(&files, Source::new).unwrap();
        sources.iter().map(|source| (text(&source.path), source.skeleton.as_deref().map(text))).collect()
    }

    #[test]
    fn a_motion_moves_the_skeleton_in_front_of_it() {
        let pair = |motion: &str, skeleton: &str| (motion.to_owned(), Some(skeleton.to_owned()));
        let alone = |file: &str| (file.to_owned(), None);
        assert_eq!(found(&["a.asf", "w.amc"]), [pair("w.amc", "a.asf")]);
        assert_eq!(found(&["w.amc", "a.ASF"]), [pair("w.amc", "a.ASF")]);
        assert_eq!(found(&["a.asf", "w.AMC", "x.amc"]), [pair("w.AMC", "a.asf"), pair("x.amc", "a.asf")]);
        let two = found(&["a.asf", "w.amc", "b.asf", "x.amc"]);
        assert_eq!(two, [pair("w.amc", "a.asf"), pair("x.amc", "b.asf")]);
        assert_eq!(found(&["a.asf"]), [alone("a.asf")]);
        let mixed = found(&["r.bvh", "b.asf", "a.asf", "w.amc"]);
        assert_eq!(mixed, [alone("r.bvh"), alone("b.asf"), pair("w.amc", "a.asf")]);
    }

    #[test]
    fn joints_are_told_apart_from_bones_and_how_to_convert_them() {
        let check = |files: &[&str]| {
            let path = |file: &&str| PathBuf::from(file);
            let skeleton = Some("s.asf".into());
            let source = |path| Source { skeleton: skeleton.clone(), ..Source::new(path) };
            check_bones(&files.iter().map(path).map(source).collect::<Vec<_>>())
        };
        assert_eq!(check(&["a.amc", "b.ASF"]), Ok(()));
        let told = check(&["a.amc", "my files/walk.bvh"]).unwrap_err();
        assert!(told.starts_with("walk.bvh holds joints"), "{told}");
        assert!(told.ends_with("cargo view \"my files/walk.bvh\" --out \"my files/walk.amc\""), "{told}");
    }

    #[test]
    fn a_skeleton_in_the_folder_of_the_motion_is_found_by_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let skeleton = |motion: &str| {
            let sources = sources(&[path(motion)], Source::new);
            sources.map(|mut sources| sources.remove(0).skeleton.unwrap())
        };
        let told = skeleton("35_01.amc").unwrap_err();
        assert!(told.starts_with(&format!("{}: cannot be opened: ", path("35_01.amc").display())), "{told}");
        fs::write(path("35_01.amc"), "").unwrap();
        fs::create_dir(path("a folder.asf")).unwrap();
        let told = skeleton("35_01.amc").unwrap_err();
        assert!(told.contains("there is none in its folder") && told.contains("SKELETON.asf"), "{told}");
        for name in ["walker.asf", "35.asf", "walk.asf", "35_01.asf", "Walk_On.ASF"] {
            fs::write(path(name), "").unwrap();
            if name == "walker.asf" {
                assert_eq!(skeleton("35_01.amc").unwrap(), path("walker.asf"), "the only one");
            }
        }
        assert_eq!(skeleton("35_02.amc").unwrap(), path("35.asf"));
        assert_eq!(skeleton("35_01.amc").unwrap(), path("35_01.asf"));
        assert_eq!(skeleton("walk_on_2.AMC").unwrap(), path("Walk_On.ASF"));
        assert_eq!(skeleton("walk.amc").unwrap(), path("walk.asf"));
        fs::write(path("36_01.amc"), "").unwrap();
        let told = skeleton("36_01.amc").unwrap_err();
        assert!(told.contains("(35.asf, 35_01.asf, Walk_On.ASF, walk.asf, walker.asf)"), "{told}");
    }

    #[test]
    fn a_folder_that_cannot_be_listed_is_not_said_to_hold_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let told = |motion: &Path| {
            let refused = Err(io::ErrorKind::PermissionDenied.into());
            chosen(motion, folder.path(), refused).unwrap_err()
        };
        let motion = folder.path().join("w.amc");
        assert!(told(&motion).contains("w.amc: cannot be opened: "), "{}", told(&motion));
        fs::write(&motion, "").unwrap();
        let (told, folder) = (told(&motion), folder.path().display());
        let why = format!("and the folder {folder} cannot be listed: permission denied; name it in front");
        assert!(told.contains(&why) && told.contains("SKELETON.asf"), "{told}");
        // Of a file there is no list at all.
        assert!(skeletons(&motion).is_err());
    }
}
