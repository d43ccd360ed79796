//! Makes the motions in `data/`, byte for byte the same on every system.
//!
//! [`data_files`] gives them all: three motions as BVH and one as Acclaim skeleton and motion, and beside each a file that
//! says where its joints or bones are in three of its frames, computed in a second way.
//!
//! Everything is computed in double precision with operations that IEEE 754 defines exactly (no fused
//! multiply-add), and with the functions of the crate `libm` in place of the system's. Angles and positions are
//! rounded to four decimals before they become the `f32` values of a motion.
#![deny(missing_docs)]

mod arm;
mod dance;
mod error;
mod expected;
mod expected_bones;
mod humanoid;
mod leg;
mod math;
mod matrix;
mod recorder;
mod running;
mod spline;
mod two_bones;
mod walking;

pub use arm::arm;
pub use dance::dance;
pub use error::Error;
pub use expected::{expected, global_transforms};
pub use expected_bones::{PlacedBone, expected_bones, place_bones};
pub use running::running;
pub use walking::walking;

/// A file of the folder `data/`.
pub struct DataFile {
    /// Its name, for example `running.bvh`.
    pub name: String,
    /// What is in it.
    pub contents: Vec<u8>,
}

/// All files that the generator makes, in the order in which it makes them.
///
/// # Errors
///
/// None, unless the tables of this crate contradict each other.
pub fn data_files() -> Result<Vec<DataFile>, Error> {
    let mut files = Vec::new();
    for (name, motion) in [("running.bvh", running()?), ("dance.bvh", dance()?), ("arm.bvh", arm()?)] {
        let mut text = Vec::new();
        parser::bvh::write(&motion, &mut text)?;
        let json = expected(name, &motion, &String::from_utf8_lossy(&text))?;
        files.push(DataFile { name: name.to_string(), contents: text });
        files.push(DataFile { name: format!("{name}.expected.json"), contents: json });
    }
    let walk = walking()?;
    let (asf, amc) = ("walk.asf", "walk.amc");
    let (mut skeleton, mut motion) = (Vec::new(), Vec::new());
    parser::acclaim::write_skeleton(walk.skeleton(), &mut skeleton)?;
    parser::acclaim::write_motion(&walk, &mut motion)?;
    files.push(DataFile { name: asf.to_string(), contents: skeleton });
    files.push(DataFile { name: amc.to_string(), contents: motion });
    let json = expected_bones(asf, amc, &walk)?;
    files.push(DataFile { name: format!("{amc}.expected.json"), contents: json });
    Ok(files)
}
