//! The skeleton and a summary of a motion, as text for the terminal.

use std::fmt::Write;

use skeleton::{Channel, Joint, Motion, RotationOrder, Skeleton};

/// Joints deeper than this are printed with their depth as a number instead of more indentation.
const DEEPEST: usize = 24;

/// Names are given at most this many columns before the offsets follow.
const WIDEST: usize = 48;

/// The skeleton as a tree: one line per joint with its name, offset (in the file's unit), rotation order and channels.
pub fn tree(skeleton: &Skeleton) -> String {
    let branches = branches(skeleton);
    let width = branches.iter().map(|branch| branch.chars().count()).max().unwrap_or(0).min(WIDEST);
    let mut text = String::new();
    for (joint, branch) in skeleton.joints().iter().zip(&branches) {
        // Adding zero makes a plain zero of a negative one.
        let [x, y, z] =
            joint.offset.to_array().map(|number| format!("{:.3}", (number * 1e3).round() / 1e3 + 0.0));
        let order = joint.rotation_order.to_string();
        let channels = channels(joint);
        let line = format!("{branch:width$}  {x:>9} {y:>9} {z:>9}  {order:<5}  {channels}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let header = format!(
        "{:width$}  {:>9} {:>9} {:>9}  {:<5}  {}",
        "joint", "offset x", "y", "z", "order", "channels"
    );
    format!("{header}\n{text}")
}

/// Each joint's name behind the lines that connect it to its parent.
fn branches(skeleton: &Skeleton) -> Vec<String> {
    let joints = skeleton.joints();
    let depths = skeleton.depths();
    // Whether a joint has a younger sibling, found from the back: the last child met first is the last one.
    let mut has_next = vec![false; joints.len()];
    let mut seen = vec![false; joints.len()];
    for (i, joint) in joints.iter().enumerate().rev() {
        if let Some(parent) = joint.parent {
            has_next[i] = std::mem::replace(&mut seen[parent.0], true);
        }
    }
    let mut stems: Vec<String> = Vec::with_capacity(joints.len());
    let mut branches = Vec::with_capacity(joints.len());
    for (i, joint) in joints.iter().enumerate() {
        let name = printable(&joint.name);
        let (branch, stem) = match joint.parent {
            None => (name, String::new()),
            Some(_) if depths[i] > DEEPEST => (format!("… depth {}: {name}", depths[i]), String::new()),
            Some(parent) => {
                let stem = &stems[parent.0];
                let (fork, line) = if has_next[i] { ("├─ ", "│  ") } else { ("└─ ", "   ") };
                (format!("{stem}{fork}{name}"), format!("{stem}{line}"))
            }
        };
        branches.push(branch);
        stems.push(stem);
    }
    branches
}

/// A name without characters that would do something to the terminal, and not longer than a line.
fn printable(name: &str) -> String {
    let mut name: String =
        name.chars().map(|c| if c.is_control() { '\u{FFFD}' } else { c }).take(WIDEST).collect();
    if name.is_empty() {
        name.push_str("(no name)");
    }
    name
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
        count(joints.len() - end_sites, "joint", "joints"),
        format!("and {}", count(end_sites, "End Site", "End Sites")),
        if roots == 1 { String::new() } else { format!("({roots} roots)") },
    ];
    let numbering = match frames {
        0 => "the file holds no frames: only the rest pose can be shown".into(),
        1 => "a single pose, frame 0".into(),
        _ => format!("numbered 0 to {}", frames - 1),
    };
    let speed = match motion.frame_time() == seconds {
        true => format!("{} s ({:.2} frames per second)", motion.frame_time(), 1.0 / seconds),
        false => format!(
            "{} s in the file, which cannot be played: shown at 30 frames per second",
            motion.frame_time()
        ),
    };
    let positions = match (moved_roots.len(), moved_others.len()) {
        (0, 0) => "none: the figure stays in its place".into(),
        (_, 0) => "on the root".into(),
        (_, others) => format!("on the root and {}", count(others, "other joint", "other joints")),
    };
    let facts = [
        ("skeleton", counts.join(" ").trim_end().to_owned()),
        ("rotation orders", orders(joints)),
        ("positions", positions),
        ("channels", format!("{} numbers per frame", skeleton.channel_count())),
        ("frames", format!("{frames} ({numbering})")),
        ("frame time", speed),
        ("duration", format!("{:.2} s", frames as f64 * seconds)),
        (
            "extent",
            format!("{:.3} in the file's unit (diagonal of the box around the rest pose)", skeleton.extent()),
        ),
    ];
    facts.iter().map(|(name, fact)| format!("{name:<16} {fact}\n")).collect()
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

fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
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
        let mut skeleton = Skeleton::new();
        skeleton.add_joint(None, "a\u{1b}[31m\u{7}", Vec3::ZERO, []).unwrap();
        assert!(!tree(&skeleton).contains('\u{1b}'));
    }
}
