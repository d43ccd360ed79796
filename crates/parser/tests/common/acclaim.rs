//! Acclaim texts that the tests start from.

use parser::acclaim::{self, MotionReading};
use skeleton::acclaim::{Motion, Skeleton};

/// A small, flawless skeleton: a root and three bones, two of which move.
pub const ASF: &str = "\
:version 1.10
:name FIGURE
:units
  mass 1.0
  length 0.45
  angle deg
:documentation
  One leg.
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name hip
    direction 1 0 0
    length 2
    axis 0 0 0 XYZ
  end
  begin
    id 2
    name thigh
    direction 0 -1 0
    length 4
    axis 10 0 20 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-60.0 70.0)
  end
  begin
    id 3
    name shin
    direction 0 0.6 -0.8
    length 3.5
    axis 0 0 20 XYZ
    dof rx
    limits (-10.0 170.0)
  end
:hierarchy
  begin
    root hip
    hip thigh
    thigh shin
  end
";

/// A small, flawless motion of [`ASF`]: two frames of ten numbers.
pub const AMC: &str = "\
#!OML:ASF C:\\figure.asf
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 4 5 6
thigh 7 8 9
shin 10
2
root 11 12 13 14 15 16
thigh 17 18 19
shin 20
";

/// [`ASF`] with its first `old` made `new`.
pub fn asf(old: &str, new: &str) -> String {
    assert!(ASF.contains(old), "nothing to replace: {old:?}");
    ASF.replacen(old, new, 1)
}

/// [`AMC`] with its first `old` made `new`.
pub fn amc(old: &str, new: &str) -> String {
    assert!(AMC.contains(old), "nothing to replace: {old:?}");
    AMC.replacen(old, new, 1)
}

/// The skeleton of [`ASF`].
pub fn figure() -> Skeleton {
    skeleton(ASF)
}

/// Reads a skeleton in which there is nothing to warn of.
pub fn skeleton(text: impl AsRef<[u8]>) -> Skeleton {
    let (skeleton, warnings) = skeleton_and_warnings(text);
    assert_eq!(warnings, [""; 0]);
    skeleton
}

/// Reads a skeleton. Gives the warnings as they are shown, too.
pub fn skeleton_and_warnings(text: impl AsRef<[u8]>) -> (Skeleton, Vec<String>) {
    let text = text.as_ref();
    let reading = acclaim::read_skeleton(text)
        .unwrap_or_else(|error| panic!("{}\n{error}", String::from_utf8_lossy(text)));
    (reading.skeleton, reading.warnings.iter().map(ToString::to_string).collect())
}

/// Reads a motion of [`figure`] in which there is nothing to warn of.
pub fn motion(text: impl AsRef<[u8]>) -> Motion {
    let (motion, warnings) = motion_and_warnings(text, &figure());
    assert_eq!(warnings, [""; 0]);
    motion
}

/// Reads a motion. Gives the warnings as they are shown, too.
pub fn motion_and_warnings(text: impl AsRef<[u8]>, skeleton: &Skeleton) -> (Motion, Vec<String>) {
    let text = text.as_ref();
    let MotionReading { motion, warnings } = acclaim::read_motion(text, skeleton)
        .unwrap_or_else(|error| panic!("{}\n{error}", String::from_utf8_lossy(text)));
    (motion, warnings.iter().map(ToString::to_string).collect())
}
