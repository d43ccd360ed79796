//! Part 1: places between the frames of short and long motions.

use exam::Answer;
use exam::time_warp::Question as TimeWarpQuestion;

use super::{case, input, tell, until};
use crate::compare::counted;
use crate::dice::Dice;
use crate::time_warp::compare;
use crate::time_warp::misconceptions::misconceptions;
use crate::{Case, Misconception};

/// A frame of a new motion.
struct Asked {
    new_frame: usize,
    old_count: usize,
    new_count: usize,
}

pub(super) fn cases(dice: &mut Dice, check: &str) -> Vec<Case> {
    match check {
        "slower" => slower(dice),
        "faster" => faster(dice),
        "last" => last(dice),
        "long" => (0..4).map(|_| until(|| telling(dice, check, Asked::of_millions), tells_digits)).collect(),
        _ => Vec::new(),
    }
}

/// From twice as many frames, where every place is a frame or half-way, to any number. There is a frame after.
fn slower(dice: &mut Dice) -> Vec<Case> {
    let old_count = 4 + dice.below(6);
    let frame = 1 + dice.below(old_count - 2);
    let easy = [
        Asked { new_frame: 2 * frame + 1, old_count, new_count: 2 * old_count },
        Asked { new_frame: 2 * frame, old_count, new_count: 2 * old_count },
        Asked { new_frame: 3 * frame + 1, old_count, new_count: 3 * old_count },
    ];
    let any = (0..3).map(|_| telling(dice, "slower", |dice| Asked::of_longer(dice, 12, 80)));
    easy.iter().map(|asked| asked.case(None)).chain(any).collect()
}

/// From half as many frames to any number.
fn faster(dice: &mut Dice) -> Vec<Case> {
    let half = 4 + dice.below(6);
    let frame = 1 + dice.below(half - 2);
    let easy = [
        Asked { new_frame: frame, old_count: 2 * half, new_count: half },
        Asked { new_frame: 2 * (frame / 2) + 1, old_count: 3 * half, new_count: 2 * half },
    ];
    let any = (0..3).map(|_| telling(dice, "faster", |dice| Asked::of_shorter(dice, 12, 80)));
    easy.iter().map(|asked| asked.case(None)).chain(any).collect()
}

/// After the last frame, exactly at it, and just before it.
fn last(dice: &mut Dice) -> Vec<Case> {
    let count = 4 + dice.below(6);
    let times = 3 + dice.below(4);
    let longer = 30 + dice.below(40);
    let shorter = |dice: &mut Dice| {
        let asked = Asked::of_shorter(dice, 12, 30);
        Asked { new_frame: asked.new_count - 1, ..asked }
    };
    let ends_before_last = |asked: &Asked| asked.is_clear() && asked.before() + 2 == asked.old_count;
    let after = "after the last frame";
    let cases = [
        (Asked { new_frame: 2 * count - 1, old_count: count, new_count: 2 * count }, after),
        (Asked { new_frame: 3 * count - 2, old_count: count, new_count: 3 * count }, after),
        (Asked { new_frame: longer - 1, old_count: 20, new_count: longer }, after),
        (Asked { new_frame: count - 1, old_count: count, new_count: count }, "exactly at the last frame"),
        (Asked { new_frame: times - 1, old_count: 1, new_count: times }, "an old motion of one frame"),
        (until(|| shorter(dice), ends_before_last), "just before the last frame"),
        (until(|| shorter(dice), ends_before_last), "just before the last frame"),
    ];
    cases.iter().map(|(asked, group)| asked.case(Some(group))).collect()
}

/// A place that is clearly between two frames, where every misconception that is to cost this check gives another one.
fn telling(dice: &mut Dice, check: &str, throw: impl Fn(&mut Dice) -> Asked) -> Case {
    let clear = |dice: &mut Dice| until(|| throw(dice), Asked::is_clear);
    until(|| clear(dice).case(None), |case| tell("part1", check, std::slice::from_ref(case)))
}

/// Whether too few digits lead to another place than any other misconception: not to a whole frame, as they may.
fn tells_digits(case: &Case) -> bool {
    let all = misconceptions("part1");
    let is_digits = |misconception: &&Misconception| misconception.id == "few_digits";
    let (digits, others): (Vec<_>, Vec<_>) = all.iter().partition(is_digits);
    let answers = |of: Vec<&Misconception>| -> Vec<Answer> {
        of.iter().flat_map(|one| &one.variants).map(|variant| case.question.ask(variant)).collect()
    };
    let others = answers(others);
    let is_other =
        |answer: &Answer| others.iter().all(|other| compare::places(case, other, answer).is_some());
    answers(digits).iter().all(is_other)
}

impl Asked {
    /// Some frame of a motion that becomes 1.2 to 3.5 times as long.
    fn of_longer(dice: &mut Dice, low: usize, high: usize) -> Asked {
        let old_count = low + dice.below(high - low);
        let new_count = (old_count as f32 * dice.between(1.2, 3.5)) as usize;
        Asked { new_frame: 1 + dice.below(new_count - 1), old_count, new_count }
    }

    /// The same the other way round.
    fn of_shorter(dice: &mut Dice, low: usize, high: usize) -> Asked {
        let longer = Asked::of_longer(dice, low, high);
        let new_count = longer.old_count;
        Asked { new_frame: 1 + dice.below(new_count - 1), old_count: longer.new_count, new_count }
    }

    /// Counts and frames that an `f32` can hold. Of places between the frames it can hold every fourth part there, from the
    /// two millionth frame to the four millionth.
    fn of_millions(dice: &mut Dice) -> Asked {
        let mut millions = |low, high| (dice.between(low, high) * 1e6) as usize;
        let (old_count, new_count) = (millions(4.0, 6.0), millions(4.0, 9.0));
        let part = dice.between(0.55, 0.68);
        Asked { new_frame: (new_count as f32 * part) as usize, old_count, new_count }
    }

    fn before(&self) -> usize {
        self.new_frame * self.old_count / self.new_count
    }

    /// Between two frames, and neither close to one nor half-way.
    fn is_clear(&self) -> bool {
        let rest = self.new_frame * self.old_count % self.new_count;
        let t = rest as f64 / self.new_count as f64;
        let is_clear = (0.08..0.42).contains(&t) || (0.58..0.92).contains(&t);
        is_clear && self.before() + 1 < self.old_count
    }

    fn case(&self, group: Option<&str>) -> Case {
        let Asked { new_frame, old_count, new_count } = *self;
        let frames = |count| counted(count, "frame");
        let inputs = vec![
            input("new frame", format!("{new_frame}, counted from 0")),
            input("old motion", frames(old_count)),
            input("new motion", frames(new_count)),
        ];
        let question = TimeWarpQuestion::Position { new_frame, old_count, new_count };
        case(question, compare::places, inputs, group.map(str::to_owned))
    }
}
