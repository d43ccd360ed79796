//! Joints and a summary of their motion.

use std::fmt::Write;

use skeleton::{Channel, Joint, Motion, RotationOrder, Skeleton};

use super::numbers::{is_plain, length, number, scientific};
use super::tree::{branches, padded, width};
use super::{lines, numbering};
use crate::view::texts::count;

/// The skeleton as a tree: one line per joint with its name, offset (in the file's unit), rotation order and channels.
pub fn tree(skeleton: &Skeleton) -> String {
    let extent = extent(skeleton);
    let joints = skeleton.joints().iter();
    let branches = branches(joints.map(|joint| (&*joint.name, joint.parent.map(|parent| parent.0))));
    let width = width(&branches);
    let mut text = String::new();
    for (joint, branch) in skeleton.joints().iter().zip(&branches) {
        let [x, y, z] = joint.offset.to_array().map(|offset| length(offset.into(), extent));
        let order = joint.rotation_order.to_string();
        let (branch, channels) = (padded(branch, width), channels(joint));
        let line = format!("{branch}  {x:>9} {y:>9} {z:>9}  {order:<5}  {channels}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let header = format!(
        "{:width$}  {:>9} {:>9} {:>9}  {:<5}  {}",
        "joint", "offset x", "y", "z", "order", "channels"
    );
    format!("{header}\n{text}")
}

/// The channels, three positions or rotations in one word.
fn channels(joint: &Joint) -> String {
    let mut words: Vec<String> = Vec::new();
    for part in joint.channels.chunk_by(|a, b| is_position(*a) == is_position(*b)) {
        let axes: String = part.iter().map(|channel| channel.word().chars().next().unwrap_or(' ')).collect();
        words.push(format!("{axes} {}", if is_position(part[0]) { "position" } else { "rotation" }));
    }
    if joint.is_end_site {
        words.push("(tip of the bone)".into());
    }
    words.join(", ")
}

fn is_position(channel: Channel) -> bool {
    matches!(channel, Channel::Position(_))
}

/// What there is to know about a motion, one fact per line.
pub fn summary(motion: &Motion) -> String {
    let skeleton = motion.skeleton();
    let joints = skeleton.joints();
    let end_sites = joints.iter().filter(|joint| joint.is_end_site).count();
    let roots = joints.iter().filter(|joint| joint.is_root()).count();
    let frames = motion.frame_count();
    let seconds = motion.playable_frame_time();
    let moved = joints.iter().filter(|joint| joint.channels.iter().any(|channel| is_position(*channel)));
    let (moved_roots, moved_others): (Vec<&Joint>, Vec<&Joint>) = moved.partition(|joint| joint.is_root());

    let counts = [
        count(joints.len() - end_sites, "joint", "joints").to_string(),
        format!("and {}", count(end_sites, "End Site", "End Sites")),
        if roots == 1 { String::new() } else { format!("({roots} roots)") },
    ];
    let numbering = match frames {
        0 if skeleton.channel_count() == 0 => {
            "none that move anything: only the rest pose can be shown".into()
        }
        frames => numbering(frames),
    };
    let frame_time = match is_plain(motion.frame_time()) {
        true => motion.frame_time().to_string(),
        false => scientific(motion.frame_time()),
    };
    let speed = match motion.frame_time() == seconds {
        true => format!("{frame_time} s ({} frames per second)", number(1.0 / seconds, 2)),
        false => format!("{frame_time} s in the file, which cannot be played: shown at 30 frames per second"),
    };
    let positions = match (moved_roots.len(), moved_others.len()) {
        (0, 0) => "none: the figure stays in its place".into(),
        (_, 0) => "on the root".into(),
        (0, others) => format!("on {}, not on the root", count(others, "joint", "joints")),
        (_, others) => format!("on the root and {}", count(others, "other joint", "other joints")),
    };
    let facts = [
        ("skeleton", counts.join(" ").trim_end().to_owned()),
        ("rotation orders", orders(joints)),
        ("positions", positions),
        ("channels", format!("{} per frame", count(skeleton.channel_count(), "number", "numbers"))),
        ("frames", format!("{frames} ({numbering})")),
        ("frame time", speed),
        ("duration", format!("{} s", number(frames as f64 * seconds, 2))),
        ("extent", extent_of(skeleton)),
    ];
    lines(&facts)
}

/// How many joints have which rotation order, the most frequent first.
fn orders(joints: &[Joint]) -> String {
    let all = RotationOrder::ROTATING.into_iter().chain([RotationOrder::None]);
    let mut counts: Vec<(usize, RotationOrder)> = all
        .map(|order| (joints.iter().filter(|joint| joint.rotation_order == order).count(), order))
        .filter(|(count, _)| *count > 0)
        .collect();
    counts.sort_by_key(|(count, order)| (*order == RotationOrder::None, std::cmp::Reverse(*count)));
    let words: Vec<String> = counts.iter().map(|(count, order)| format!("{count} {order}")).collect();
    words.join(", ")
}

/// How large a skeleton is, in words.
pub fn extent_of(skeleton: &Skeleton) -> String {
    format!("{} in the file's unit (diagonal of the box around the rest pose)", number(extent(skeleton), 3))
}

/// [`Skeleton::extent`] in double precision, and counted from the first root: the squares of large lengths do not fit
/// into single precision, and a small skeleton may stand far away.
pub fn extent(skeleton: &Skeleton) -> f64 {
    let joints = skeleton.joints();
    let Some(first) = joints.first() else { return 0.0 };
    let along = |axis: usize| {
        let mut places: Vec<f64> = Vec::with_capacity(joints.len());
        for joint in joints {
            let start = joint.parent.map_or(-f64::from(first.offset[axis]), |parent| places[parent.0]);
            places.push(start + f64::from(joint.offset[axis]));
        }
        let low = places.iter().copied().fold(f64::INFINITY, f64::min);
        places.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    (0..3).map(|axis| along(axis).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn a_very_deep_skeleton_stays_readable_and_small() {
        let mut skeleton = Skeleton::new();
        let mut parent = None;
        for i in 0..5000 {
            parent = Some(skeleton.add_joint(parent, format!("j{i}"), Vec3::X, []).unwrap());
        }
        let text = tree(&skeleton);
        assert!(text.contains("… depth 4999: j4999"));
        assert!(text.lines().all(|line| line.chars().count() < 160));
    }

    #[test]
    fn no_name_can_command_the_terminal() {
        for bad in ['\u{1b}', '\u{7}', '\u{202e}', '\u{200b}', '\u{2066}', '\u{feff}'] {
            let mut skeleton = Skeleton::new();
            skeleton.add_joint(None, format!("a{bad}[31m"), Vec3::ZERO, []).unwrap();
            assert!(!tree(&skeleton).contains(bad), "{bad:?}");
        }
    }

    #[test]
    fn a_summary_of_odd_numbers_is_true_and_short() {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "r", Vec3::ZERO, []).unwrap();
        let position = vec![Channel::from_word("Xposition").unwrap()];
        skeleton.add_joint(Some(root), "j", Vec3::new(3e38, 0.0, 0.0), position).unwrap();
        let text = summary(&Motion::new(skeleton.clone(), 1, 1e-300, vec![0.0]).unwrap());
        for expected in
            ["1e-300 s", "extent           3e38 in", "on 1 joint, not on the root", "1 number per frame"]
        {
            assert!(text.contains(expected), "{expected} is missing in: {text}");
        }
        let text = summary(&Motion::new(skeleton, 1, 1e6, vec![0.0]).unwrap());
        assert!(text.contains("1000000 s (1e-6 frames per second)"), "{text}");

        let mut far = Skeleton::new();
        let root = far.add_joint(None, "r", Vec3::splat(3e38), []).unwrap();
        let arm = far.add_joint(Some(root), "j", Vec3::Y, []).unwrap();
        assert_eq!(extent(&far), 1.0);
        far.add_end_site(arm, "End Site", Vec3::Y * 3e38).unwrap();
        assert_eq!(number(extent(&far), 3), "3e38");
        assert_eq!(extent(&Skeleton::new()), 0.0);

        let mut rigid = Skeleton::new();
        rigid.add_joint(None, "r", Vec3::ZERO, []).unwrap();
        let text = summary(&Motion::new(rigid, 0, 0.1, Vec::new()).unwrap());
        assert!(text.contains("0 (none that move anything: only the rest pose can be shown)"), "{text}");
    }
}
