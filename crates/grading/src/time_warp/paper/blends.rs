//! Part 2: two postures, and what is between them.

use exam::time_warp::Question as TimeWarpQuestion;
use exam::{Answer, Functions};
use skeleton::Axis;
use skeleton::acclaim::Posture;

use super::{Compare, case, input, until};
use crate::Case;
use crate::compare::{angle_between, vector};
use crate::dice::{Dice, two_decimals};
use crate::time_warp::compare::{self, in_degrees};
use crate::time_warp::misconceptions::misconceptions;
use crate::time_warp::throws;
use crate::time_warp::variants::quaternion;

/// The angles of one bone in the two postures.
type Pair = [[f32; 3]; 2];

/// What of a posture counts.
#[derive(Clone, Copy)]
enum Compared {
    Rotations,
    Translations,
}

/// Values for `t` where not all wrong ways are right, as some are half-way.
const TIMES: [f32; 6] = [0.25, 0.1, 0.7, 0.3, 0.9, 0.6];

/// How many bones the last question of each check is about.
const BONES: usize = 7;

/// Each answer that is wrong differs by at least so many degrees from the right one.
const APART: f64 = 0.05;

pub(super) fn cases(dice: &mut Dice, check: &str) -> Vec<Case> {
    match check {
        "translations" => translations(dice),
        "one_axis" => rotations(dice, small_change),
        "all_axes" => all_axes(dice),
        "wrap" => rotations(dice, across),
        _ => Vec::new(),
    }
}

/// Of one bone and of several, between the postures and at them.
fn translations(dice: &mut Dice) -> Vec<Case> {
    let cases = [(1, 0.5), (1, 0.25), (4, 0.7), (BONES, 0.1), (4, 0.0), (BONES, 1.0)];
    cases
        .map(|(bones, t)| {
            let pairs = of_bones(dice, bones, all_change);
            ask(dice, &pairs, t, Compared::Translations, None)
        })
        .into()
}

/// One angle changes: first with the others zero, then with others that stay, and then so for several bones.
fn rotations(dice: &mut Dice, throw: fn(&mut Dice, Axis, bool) -> Pair) -> Vec<Case> {
    let axes = [Axis::Z, Axis::X, Axis::Y];
    let single = axes.into_iter().cycle().zip(TIMES).enumerate().map(|(number, (axis, t))| {
        let pair = throw(dice, axis, number >= axes.len());
        ask(dice, &[pair], t, Compared::Rotations, Some(format!("about {axis}")))
    });
    let mut cases: Vec<Case> = single.collect();
    let pairs: Vec<Pair> = axes.into_iter().cycle().take(BONES).map(|axis| throw(dice, axis, true)).collect();
    cases.push(ask(dice, &pairs, 0.2, Compared::Rotations, Some("several bones".to_owned())));
    cases
}

/// All three angles change.
fn all_axes(dice: &mut Dice) -> Vec<Case> {
    let single = |t| {
        let throw = || {
            let pair = all_change(dice);
            ask(dice, &[pair], t, Compared::Rotations, None)
        };
        until(throw, |case| is_apart("all_axes", case))
    };
    let mut cases: Vec<Case> = TIMES.map(single).into();
    let pairs = of_bones(dice, BONES, all_change);
    cases.push(ask(dice, &pairs, 0.2, Compared::Rotations, None));
    cases
}

/// Whether every misconception that is to cost this check is clearly wrong about the only bone.
fn is_apart(check: &str, case: &Case) -> bool {
    let rotation = |functions| match case.question.ask(functions) {
        Answer::TimeWarp(exam::time_warp::Answer::Blend(posture)) => quaternion(posture.angles[0]),
        _ => glam::Quat::NAN,
    };
    let right = rotation(&Functions::TimeWarp(solutions::TIME_WARP));
    let all = misconceptions("part2");
    let wrong = all.iter().filter(|one| one.costs.contains(&check)).flat_map(|one| &one.variants);
    wrong.into_iter().all(|variant| angle_between(right, rotation(variant)) > APART)
}

fn of_bones(dice: &mut Dice, bones: usize, throw: fn(&mut Dice) -> Pair) -> Vec<Pair> {
    (0..bones).map(|_| throw(dice)).collect()
}

/// By less than a right angle: about Z on one side of zero, and about X and Y from one side to the other.
fn small_change(dice: &mut Dice, axis: Axis, others: bool) -> Pair {
    let from = dice.angle(10.0, 30.0);
    let way = match axis {
        Axis::Z => dice.between(25.0, 45.0),
        Axis::X | Axis::Y => -dice.between(60.0, 95.0),
    };
    one_changes(dice, axis, others, [from, from + from.signum() * way])
}

/// Over ±180 degrees.
fn across(dice: &mut Dice, axis: Axis, others: bool) -> Pair {
    let from = dice.angle(120.0, 175.0);
    let to = -from.signum() * dice.between(120.0, 175.0);
    one_changes(dice, axis, others, [from, to])
}

fn one_changes(dice: &mut Dice, axis: Axis, others: bool, values: [f32; 2]) -> Pair {
    let rest = [dice.angle(20.0, 60.0), dice.angle(20.0, 50.0), dice.angle(20.0, 60.0)];
    values.map(|value| {
        let mut angles = if others { rest } else { [0.0; 3] };
        angles[axis.index()] = two_decimals(value);
        angles
    })
}

/// All three, and none of them over ±180 degrees.
fn all_change(dice: &mut Dice) -> Pair {
    let throw = || {
        let from = throws::angles(dice);
        [from, throws::next_angles(dice, from)]
    };
    let is_short = |[from, to]: &Pair| {
        let is_near = |axis: usize| (to[axis] - from[axis]).abs() < 90.0;
        (0..3).all(is_near) && quaternion(*from).dot(quaternion(*to)) > 0.0
    };
    until(throw, is_short)
}

fn ask(dice: &mut Dice, pairs: &[Pair], t: f32, compared: Compared, group: Option<String>) -> Case {
    let [from, to] = [0, 1].map(|end| Posture {
        angles: pairs.iter().map(|pair| pair[end]).collect(),
        translations: pairs.iter().map(|_| dice.vector(2.0, 40.0)).collect(),
    });
    let mut inputs = if pairs.len() == 1 {
        let shown =
            |end, posture| input(format!("{}, {end}", compared.name()), compared.of_first_bone(posture));
        vec![shown("from", &from), shown("to", &to)]
    } else {
        vec![input("bones", pairs.len().to_string())]
    };
    inputs.push(input("t", t.to_string()));
    case(TimeWarpQuestion::Blend { from, to, t }, compared.compare(), inputs, group)
}

impl Compared {
    fn compare(self) -> Compare {
        match self {
            Compared::Rotations => compare::rotations,
            Compared::Translations => compare::translations,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Compared::Rotations => "angles",
            Compared::Translations => "translation",
        }
    }

    fn of_first_bone(self, posture: &Posture) -> String {
        match self {
            Compared::Rotations => in_degrees(&posture.angles[0]),
            Compared::Translations => vector(posture.translations[0]),
        }
    }
}
