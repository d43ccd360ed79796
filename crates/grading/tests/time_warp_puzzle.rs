//! What the handout says about two programs: one makes honest quaternions and looks weird, one puts angles into them and
//! looks right. The angles of a run in `data/` are taken for a figure's angles about X, Y and Z.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::fs;

use glam::{EulerRot, Quat, Vec4};
use grading::fk::angle_between;
use skeleton::acclaim::Posture;
use solutions::time_warp::blend;

/// The run, with every so manieth frame.
fn run(every: usize) -> Vec<Posture> {
    let path = format!("{}/../../data/running.bvh", env!("CARGO_MANIFEST_DIR"));
    let motion = parser::bvh::read(&*fs::read(path).unwrap()).unwrap().motion;
    let posture = |frame| {
        let angles = motion.frame(frame).angles;
        let angles = angles.chunks_exact(3).map(|angles| [angles[0], angles[1], angles[2]]);
        Posture { angles: angles.collect(), translations: Vec::new() }
    };
    (0..motion.frame_count()).step_by(every).map(posture).collect()
}

fn turned(angles: [f32; 3]) -> Posture {
    Posture { angles: vec![angles], translations: Vec::new() }
}

fn quaternion([x, y, z]: [f32; 3]) -> Quat {
    Quat::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians())
}

/// How each bone is turned half-way between neighbouring frames, honestly, and how by this function.
fn half_way(
    postures: &[Posture],
    other: fn([f32; 3], [f32; 3], f32) -> [f32; 3],
) -> impl Iterator<Item = (Quat, Quat)> {
    postures.windows(2).flat_map(move |pair| {
        let right = blend(&pair[0], &pair[1], 0.5).angles;
        let ends = pair[0].angles.iter().zip(&pair[1].angles);
        let others = ends.map(move |(from, to)| other(*from, *to, 0.5));
        right.into_iter().zip(others).map(|(right, other)| (quaternion(right), quaternion(other)))
    })
}

/// By how many degrees they differ, from the least to the most.
fn off(postures: &[Posture], other: fn([f32; 3], [f32; 3], f32) -> [f32; 3]) -> Vec<f64> {
    let mut off: Vec<f64> =
        half_way(postures, other).map(|(right, other)| angle_between(right, other)).collect();
    off.sort_by(f64::total_cmp);
    off
}

/// What so many of a hundred are below.
fn percent(sorted: &[f64], percent: usize) -> f64 {
    sorted[(sorted.len() - 1) * percent / 100]
}

/// Three angles as x, y and z of a quaternion, a slerp as in Eigen (where the dot product is not below 1, a straight line of
/// any length), and x, y and z out again.
fn packed(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
    let [from, to] = [from, to].map(|[x, y, z]| Vec4::new(x, y, z, 0.0));
    let dot = from.dot(to);
    let (first, second) = if dot.abs() >= 1.0 - f32::EPSILON {
        (1.0 - t, t)
    } else {
        let angle = dot.abs().acos();
        (((1.0 - t) * angle).sin() / angle.sin(), (t * angle).sin() / angle.sin())
    };
    (from * first + to * if dot < 0.0 { -second } else { second }).truncate().to_array()
}

fn number_by_number(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
    [0, 1, 2].map(|axis| from[axis] + t * (to[axis] - from[axis]))
}

/// Honest quaternions, and x, y and z of the result for angles.
fn components(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
    quaternion(from).slerp(quaternion(to), t).xyz().to_array()
}

#[test]
fn angles_in_quaternions_look_right_from_frame_to_frame() {
    let run = run(1);
    let off = off(&run, packed);
    assert!(off.len() > 38_000 && percent(&off, 50) < 1e-4, "{} {}", off.len(), percent(&off, 50));
    assert!((0.01..0.015).contains(&percent(&off, 99)), "{}", percent(&off, 99));
    assert!((3.5..4.0).contains(&percent(&off, 100)), "{}", percent(&off, 100));
}

/// Because the dot product of such numbers is far above 1: what is called a slerp is a straight line from number to number.
#[test]
fn angles_in_quaternions_are_interpolated_number_by_number() {
    let run = run(1);
    let same = half_way(&run, packed).zip(half_way(&run, number_by_number));
    let (all, same) = same.fold((0, 0), |(all, same), ((_, packed), (_, line))| {
        (all + 1, same + usize::from(angle_between(packed, line) < 0.01))
    });
    assert!(same as f64 > 0.99 * f64::from(all), "{same} of {all}");
    let line = off(&run, number_by_number);
    assert!(percent(&line, 100) < 0.04, "{}", percent(&line, 100));
}

#[test]
fn angles_in_quaternions_look_wrong_where_more_happens_between_two_frames() {
    let every_4th = off(&run(4), packed);
    assert!((2.5..3.5).contains(&percent(&every_4th, 99)), "{}", percent(&every_4th, 99));
    let every_16th = off(&run(16), packed);
    assert!((30.0..32.0).contains(&percent(&every_16th, 99)), "{}", percent(&every_16th, 99));
    assert!((43.0..44.0).contains(&percent(&every_16th, 100)), "{}", percent(&every_16th, 100));
    // From frame to frame it does so only where the numbers are small or change sign.
    for pair in run(1).windows(2) {
        for (from, to) in pair[0].angles.iter().zip(&pair[1].angles) {
            let dot: f32 = (0..3).map(|axis| from[axis] * to[axis]).sum();
            let right = quaternion(blend(&turned(*from), &turned(*to), 0.5).angles[0]);
            let off = angle_between(right, quaternion(packed(*from, *to, 0.5)));
            assert!(off < 0.04 || dot < 1.0, "{from:?} {to:?}: {off}");
        }
    }
    // Where the three numbers change sign, the opposite ones are taken for the same rotation.
    let [x, ..] = packed([10.0, 0.0, 0.0], [-10.0, 0.0, 0.0], 0.5);
    assert_eq!(x, 10.0);
}

#[test]
fn components_taken_for_angles_hardly_turn_the_figure() {
    let run = run(1);
    let turned = |which: fn((Quat, Quat)) -> Quat| {
        let pairs = half_way(&run, components).map(which);
        let mut turned: Vec<f64> = pairs.map(|rotation| angle_between(Quat::IDENTITY, rotation)).collect();
        turned.sort_by(f64::total_cmp);
        turned
    };
    let (honest, components) = (turned(|(right, _)| right), turned(|(_, other)| other));
    assert!((27.0..28.5).contains(&percent(&honest, 50)) && percent(&honest, 100) > 179.0);
    assert!((0.23..0.25).contains(&percent(&components, 50)) && percent(&components, 100) < 1.001);
}

/// glam brings a straight line back to length 1. Here the puzzle could not have come up: both programs look weird.
#[test]
fn with_glam_angles_in_quaternions_hardly_turn_the_figure_either() {
    let packed = |from: [f32; 3], to: [f32; 3], t| {
        let [from, to] = [from, to].map(|[x, y, z]| Quat::from_xyzw(x, y, z, 0.0));
        from.slerp(to, t).xyz().to_array()
    };
    let run = run(1);
    let turned = half_way(&run, packed).map(|(_, other)| angle_between(Quat::IDENTITY, other));
    let largest = turned.max_by(f64::total_cmp).unwrap();
    assert!((1.0..3.0).contains(&largest), "{largest}");
}
