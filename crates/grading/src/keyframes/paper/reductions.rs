//! Part 3: reductions by tables of costs.

use exam::Answer;
use exam::keyframes::{Question as KeyframesQuestion, Triples};

use super::{Draft, input, until, ways};
use crate::Misconception;
use crate::dice::Dice;
use crate::keyframes::compare::list;
use crate::keyframes::misconceptions::BELOW_ZERO;
use crate::keyframes::wander::{costs, wander};

/// In every step the second-best removal costs more than the best one by more than this, times their size: which one is
/// right does not depend on how sums are rounded, nor on the type that costs are kept in.
const MARGIN: f64 = 0.005;

/// Where the costs come from.
#[derive(Clone, Copy)]
enum Table {
    /// Every one is thrown by itself, and no two are the same.
    Numbers,
    /// The same, and some are below 0 where there are other frames between the neighbours.
    BelowZero,
    /// From the errors of something that moves.
    Wandering,
    /// Small whole numbers, many of them the same, whatever the neighbours are.
    Whole,
    /// As where a motion stands still.
    Zeros,
}

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    use Table::{BelowZero, Numbers, Wandering, Whole, Zeros};
    let cases: &[(Table, usize, usize)] = match check {
        "one" => &[(Numbers, 6, 5), (Wandering, 9, 8), (Numbers, 12, 11), (Wandering, 20, 19)],
        "many" => &[
            (Numbers, 10, 6),
            (Wandering, 12, 5),
            (Numbers, 16, 5),
            (Wandering, 20, 7),
            (BelowZero, 25, 10),
            (Wandering, 30, 8),
        ],
        "ties" => &[(Whole, 9, 5), (Whole, 15, 8), (Whole, 24, 10), (Zeros, 12, 5)],
        "few" => return few(dice),
        _ => &[],
    };
    let throw = |&(table, frames, count): &(Table, usize, usize)| {
        let throw = || table.throw(dice, frames);
        let shows = |wrong: &Misconception| wrong.id != BELOW_ZERO || matches!(table, BelowZero);
        let tells = |costs: &Triples| match table {
            Numbers | BelowZero | Wandering => {
                let cost = |before, frame, after| costs.get(before, frame, after);
                let size = |before, frame, after| costs.get(before, frame, after).abs();
                is_clear(frames, count, cost, size)
                    && all_differ_at_first(frames, costs)
                    && tells(check, frames, count, costs, shows)
            }
            Whole => tells(check, frames, count, costs, shows),
            Zeros => true,
        };
        draft(frames, count, until(throw, tells), None)
    };
    cases.iter().map(throw).collect()
}

/// What is right whatever the costs are, and needs care.
fn few(dice: &mut Dice) -> Vec<Draft> {
    const BELOW_TWO: &str = "fewer than two keyframes wanted";
    const ENOUGH: &str = "no more frames than keyframes wanted";
    let cases = [
        ("three frames", 3, 2),
        (ENOUGH, 3, 3),
        (ENOUGH, 7, 7),
        (ENOUGH, 7, 20),
        (BELOW_TWO, 7, 1),
        (BELOW_TWO, 7, 0),
        ("two frames", 2, 2),
        ("two frames", 2, 0),
        ("one frame", 1, 5),
        ("one frame", 1, 0),
        ("no frame", 0, 0),
        ("no frame", 0, 3),
    ];
    let throw =
        |(group, frames, count)| draft(frames, count, Table::Numbers.throw(dice, frames), Some(group));
    cases.into_iter().map(throw).collect()
}

impl Table {
    fn throw(self, dice: &mut Dice, frames: usize) -> Triples {
        match self {
            Table::Numbers | Table::BelowZero => {
                let mut numbers = Vec::new();
                Triples::new(frames, |_, _, _| {
                    numbers.push(numbers.len() + 1);
                    0.0
                });
                dice.shuffle(&mut numbers);
                let mut next = numbers.into_iter();
                Triples::new(frames, |before, _, after| {
                    let number = next.next().unwrap_or(0) as f64 / 10.0;
                    // With all frames as keyframes no frame has an error that could become smaller.
                    let can_be_less = matches!(self, Table::BelowZero) && after - before > 2;
                    if can_be_less && dice.below(4) == 0 { -number } else { number }
                })
            }
            Table::Wandering => costs(&wander(dice, frames)),
            Table::Whole => {
                let whole: Vec<usize> = (0..frames).map(|_| 1 + dice.below(4)).collect();
                Triples::new(frames, |_, frame, _| whole[frame] as f64)
            }
            Table::Zeros => Triples::new(frames, |_, _, _| 0.0),
        }
    }
}

/// Whether no two removals cost the same as long as all frames are keyframes: otherwise who never finds new costs would
/// need the rule for those that cost the same, and could not be told from others.
fn all_differ_at_first(frames: usize, costs: &Triples) -> bool {
    let mut first: Vec<f64> = (2..frames).map(|after| costs.get(after - 2, after - 1, after)).collect();
    first.sort_by(f64::total_cmp);
    first.windows(2).all(|pair| pair[0] < pair[1])
}

/// Whether all misconceptions that this check is to cost, and that can show here, give another answer than the right one. Where many keyframes are
/// removed, they give different answers from one another too.
fn tells(
    check: &str,
    frame_count: usize,
    count: usize,
    costs: &Triples,
    shows: impl Fn(&Misconception) -> bool,
) -> bool {
    let question = KeyframesQuestion::Reduce { frame_count, count, costs: costs.clone() };
    let ways = ways("part3", check, question, shows);
    let others = |index: usize| &ways[..if check == "many" { index } else { index.min(1) }];
    let are_apart = |way: &[Answer], other: &[Answer]| way.iter().all(|answer| !other.contains(answer));
    ways.iter().enumerate().all(|(index, way)| others(index).iter().all(|other| are_apart(way, other)))
}

/// Whether the best removal is better than the second-best one in every step of a reduction, by more than [`MARGIN`]
/// times what `scale` says of the two (before, frame, after), whichever is more.
pub(in crate::keyframes) fn is_clear(
    frame_count: usize,
    count: usize,
    cost: impl Fn(usize, usize, usize) -> f64,
    scale: impl Fn(usize, usize, usize) -> f64,
) -> bool {
    let mut keyframes: Vec<usize> = (0..frame_count).collect();
    while keyframes.len() > count.max(2) {
        let three = |place: usize| (keyframes[place - 1], keyframes[place], keyframes[place + 1]);
        let at = |place: usize| {
            let (before, frame, after) = three(place);
            cost(before, frame, after)
        };
        let mut places: Vec<usize> = (1..keyframes.len() - 1).collect();
        places.sort_by(|a, b| at(*a).total_cmp(&at(*b)));
        if let [best, second, ..] = places[..] {
            let scale = [best, second].map(|place| {
                let (before, frame, after) = three(place);
                scale(before, frame, after)
            });
            if at(second) - at(best) <= MARGIN * scale[0].max(scale[1]) {
                return false;
            }
        }
        keyframes.remove(places[0]);
    }
    true
}

fn draft(frame_count: usize, count: usize, costs: Triples, group: Option<&str>) -> Draft {
    let mut inputs =
        vec![input("frames", frame_count.to_string()), input("keyframes wanted", count.to_string())];
    if frame_count > 2 {
        let shown = |frame: usize| format!("{frame}: {}", costs.get(frame - 1, frame, frame + 1));
        let shown: Vec<String> = (1..frame_count - 1).map(shown).collect();
        inputs.push(input("costs at first", list(&shown, 0)));
    }
    let question = KeyframesQuestion::Reduce { frame_count, count, costs };
    Draft { question, inputs, group: group.map(ToOwned::to_owned), size: 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_costs_close_together_are_not_clear_in_any_step_that_is_taken() {
        let clear = |count, costs: [f64; 4]| {
            is_clear(6, count, |_, frame, _| costs[frame - 1], |_, frame, _| costs[frame - 1])
        };
        assert!(clear(2, [1.0, 4.0, 2.0, 3.0]));
        assert!(!clear(5, [1.0, 1.004, 2.0, 3.0]));
        assert!(!clear(5, [0.0, 0.0, 2.0, 3.0]));
        assert!(!clear(4, [1.0, 2.0, 2.009, 3.0]));
        assert!(clear(5, [1.0, 2.0, 2.009, 3.0]), "the second removal is not wanted");
    }
}
