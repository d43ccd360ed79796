//! Texts that the tests start from.
#![allow(dead_code)] // Each test binary uses some of them.

pub mod acclaim;
pub mod bones;
pub mod damage;
pub mod pieces;
pub mod repeated;

/// A small, flawless file: one joint, one End Site, two frames of three channels.
pub const GOOD: &str = "\
HIERARCHY
ROOT Hips
{
	OFFSET 0 1 0
	CHANNELS 3 Zrotation Xrotation Yrotation
	End Site
	{
		OFFSET 0 2 0
	}
}
MOTION
Frames: 2
Frame Time: 0.04
1 2 3
4 5 6
";

/// [`GOOD`] with its first `old` made `new`.
pub fn with(old: &str, new: &str) -> String {
    assert!(GOOD.contains(old), "nothing to replace: {old:?}");
    GOOD.replacen(old, new, 1)
}
