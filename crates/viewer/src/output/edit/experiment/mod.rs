//! The book's experiment: Euler angles or quaternions? Its curves and its tables, from the motions in `data/`.

mod noise;
mod tables;
mod turn;

use std::fs;
use std::path::Path;

use reduction::{Curve, Errors, curve};
use skeleton::{Frame, Motion, Representation};

/// How many keyframes the curves go down to, and the first tables are about.
const KEYFRAMES: usize = 20;

/// The motions of the experiment, and their curves.
#[derive(Debug)]
pub struct Experiment {
    dance: Clip,
    running: Clip,
    arm: Clip,
}

/// A motion, its errors and its curves in both representations, Euler angles first.
#[derive(Debug)]
struct Clip {
    name: &'static str,
    motion: Motion,
    errors: [Errors; 2],
    curves: [Curve; 2],
}

impl Experiment {
    /// Reads the motions in `data` and draws their curves.
    ///
    /// # Errors
    ///
    /// When one of them is not there or cannot be read.
    pub fn new(data: &Path) -> Result<Experiment, String> {
        let clip = |name| Clip::read(data, name);
        Ok(Experiment { dance: clip("dance")?, running: clip("running")?, arm: clip("arm")? })
    }

    /// The pictures of the curves: the names of the files in `docs/pictures/`, and what they hold.
    ///
    /// # Errors
    ///
    /// When there is a number that nothing can be drawn of.
    pub fn pictures(&self) -> Result<Vec<(String, String)>, String> {
        let picture = |clip: &Clip| {
            let [euler, quaternions] = &clip.curves;
            let title = format!("Accumulated error of {}.bvh", clip.name);
            let svg = super::svg(&title, clip.motion.frame_count(), euler, quaternions)?;
            Ok((format!("{}-error.svg", clip.name), svg))
        };
        [&self.dance, &self.running].into_iter().map(picture).collect()
    }

    /// The tables of the chapter: their places, and their text. Unless it is `whole`, the rows that take long are left out: the
    /// optimum of a long motion.
    pub fn tables(&mut self, whole: bool) -> Vec<(&'static str, String)> {
        vec![
            ("dance", tables::methods(&mut self.dance, KEYFRAMES, true)),
            ("running", tables::methods(&mut self.running, KEYFRAMES, whole)),
            ("running with 100 keyframes", tables::methods(&mut self.running, 100, whole)),
            ("gaps", tables::gaps(&[&self.dance, &self.running, &self.arm])),
            ("tips", tables::tips(&self.dance, 4)),
            ("falls", tables::falls(&self.running)),
            ("curves", tables::curves(&[&self.dance, &self.running])),
            ("orders", tables::orders(&self.dance, KEYFRAMES)),
            ("noise", noise::table(&[(&self.dance, &[KEYFRAMES]), (&self.running, &[KEYFRAMES, 100])])),
            ("turns", turn::table()),
        ]
    }

    /// Writes the pictures and the tables into the book in `docs`, and gives the names of the files.
    ///
    /// # Errors
    ///
    /// When a file cannot be read or written, or a table has no place in the chapter.
    pub fn write(&mut self, docs: &Path) -> Result<Vec<String>, String> {
        let mut names = Vec::new();
        for (name, svg) in self.pictures()? {
            let path = docs.join("pictures").join(&name);
            fs::write(&path, svg).map_err(|error| format!("{}: {error}", path.display()))?;
            names.push(format!("docs/pictures/{name}"));
        }
        let path = docs.join(CHAPTER);
        let told = |error| format!("{}: {error}", path.display());
        let mut text = fs::read_to_string(&path).map_err(told)?;
        for (place, table) in self.tables(true) {
            let at = place_of(&text, place).ok_or_else(|| format!("{CHAPTER} has no place for {place:?}"))?;
            text.replace_range(at, &table);
        }
        fs::write(&path, text).map_err(told)?;
        names.push(format!("docs/{CHAPTER}"));
        Ok(names)
    }
}

/// The chapter in `docs/`.
pub const CHAPTER: &str = "experiment.md";

/// Where in `text` a table stands: between two comments with its name.
pub fn place_of(text: &str, place: &str) -> Option<std::ops::Range<usize>> {
    let (begin, end) = (format!("<!-- {place}: begin -->\n"), format!("<!-- {place}: end -->"));
    let from = text.find(&begin)? + begin.len();
    let to = from + text[from..].find(&end)?;
    Some(from..to)
}

impl Clip {
    fn read(data: &Path, name: &'static str) -> Result<Clip, String> {
        let path = data.join(format!("{name}.bvh"));
        let motion = parser::bvh::read_file(path).map_err(|error| error.to_string())?.motion;
        Ok(Clip::new(name, motion))
    }

    fn new(name: &'static str, motion: Motion) -> Clip {
        let frames: Vec<Frame> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
        let errors =
            Representation::ALL.map(|representation| Errors::new(motion.skeleton(), &frames, representation));
        let curves = errors
            .each_ref()
            .map(|errors| curve(errors, KEYFRAMES, &mut |_, _| std::ops::ControlFlow::Continue(())));
        Clip { name, motion, errors, curves }
    }
}
