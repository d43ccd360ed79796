//! Of the answers to a question about bones, what counts.

use exam::acclaim::{Answer as AcclaimAnswer, Question as AcclaimQuestion};
use exam::{Answer, Question};
use skeleton::acclaim::{Bone, BoneId, Skeleton};

use crate::compare::{between_positions, between_rotations, not_comparable};
use crate::{Case, Difference};

/// So many columns of a list of bones are shown.
const LIST_WIDTH: usize = 56;

/// Part 1's answer.
pub(super) fn rotation(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (
            Answer::Acclaim(AcclaimAnswer::Rotation(expected)),
            Answer::Acclaim(AcclaimAnswer::Rotation(got)),
        ) => between_rotations(*expected, *got),
        _ => not_comparable(),
    }
}

/// Of part 2's answer, the start.
pub(super) fn start(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (Answer::Acclaim(AcclaimAnswer::Ends(expected, _)), Answer::Acclaim(AcclaimAnswer::Ends(got, _))) => {
            between_positions(*expected, *got, case.size)
        }
        _ => not_comparable(),
    }
}

/// Of part 2's answer, the end.
pub(super) fn end(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (Answer::Acclaim(AcclaimAnswer::Ends(_, expected)), Answer::Acclaim(AcclaimAnswer::Ends(_, got))) => {
            between_positions(*expected, *got, case.size)
        }
        _ => not_comparable(),
    }
}

/// Part 3's answer: how often each bone is visited, and which ones too early. In which order bones come that do not hang
/// on one another is the same to everyone.
pub(super) fn visits(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (
        Question::Acclaim(AcclaimQuestion::Visits { skeleton, bone }),
        Answer::Acclaim(AcclaimAnswer::Visits(expected)),
        Answer::Acclaim(AcclaimAnswer::Visits(got)),
    ) = (&case.question, expected, got)
    else {
        return not_comparable();
    };
    let [wanted, seen] = [expected, got].map(|visits| Seen::of(skeleton, visits));
    (wanted != seen).then(|| Difference {
        got: names(skeleton, got),
        expected: format!("for example {}", names(skeleton, expected)),
        between: in_words(skeleton, *bone, &wanted, &seen),
    })
}

/// What counts of a list of visits.
#[derive(PartialEq)]
struct Seen {
    /// How often each bone of the skeleton is visited.
    counts: Vec<usize>,
    /// How many visits are of bones that are not in the skeleton.
    strangers: usize,
    /// Whether each bone is visited before its parent, which is visited later.
    early: Vec<bool>,
}

impl Seen {
    fn of(skeleton: &Skeleton, visits: &[BoneId]) -> Seen {
        let mut counts = vec![0; skeleton.len()];
        let mut early = vec![false; skeleton.len()];
        let mut strangers = 0;
        for id in visits {
            let Some(bone) = skeleton.get(*id) else {
                strangers += 1;
                continue;
            };
            counts[id.0] += 1;
            // It is the parent's first visit: whoever was there before was too early.
            if counts[id.0] == 1 {
                for child in skeleton.children(bone.id).filter(|child| counts[child.id.0] > 0) {
                    early[child.id.0] = true;
                }
            }
        }
        Seen { counts, strangers, early }
    }
}

/// What is wrong with visits that begin with `start`, when `wanted` was wanted: of several kinds of mistakes the first,
/// with the first bone that has it, and how many more have.
fn in_words(skeleton: &Skeleton, start: BoneId, wanted: &Seen, seen: &Seen) -> String {
    let bones = |is_wrong: &dyn Fn(usize) -> bool| -> Option<(&Bone, String)> {
        let mut wrong = skeleton.bones().iter().filter(|bone| is_wrong(bone.id.0));
        let first = wrong.next()?;
        let others = match wrong.count() {
            0 => String::new(),
            1 => " (and 1 other)".to_owned(),
            others => format!(" (and {others} others)"),
        };
        Some((first, others))
    };
    let (counts, wants) = (&seen.counts, &wanted.counts);
    if let Some((bone, others)) = bones(&|id| wants[id] > 0 && counts[id] == 0) {
        format!("{} is never visited{others}", bone.name)
    } else if let Some((bone, others)) = bones(&|id| wants[id] == 0 && counts[id] > 0) {
        let start = skeleton.get(start).map_or("it", |start| &start.name);
        format!("{} does not hang on {start}, and is visited{others}", bone.name)
    } else if let Some((bone, others)) = bones(&|id| counts[id] > wants[id]) {
        format!("{} is visited {}{others}", bone.name, times(counts[bone.id.0]))
    } else if let Some((bone, others)) = bones(&|id| seen.early[id] && !wanted.early[id]) {
        let parent = bone.parent.map_or("", |parent| &skeleton[parent].name);
        format!("{} is visited before its parent {parent}{others}", bone.name)
    } else if seen.strangers > 0 {
        "a bone is visited that is not in the skeleton".to_owned()
    } else {
        "the visits are others".to_owned()
    }
}

fn times(count: usize) -> String {
    if count == 2 { "twice".to_owned() } else { format!("{count} times") }
}

/// The names of the visited bones, as many as fit into one line.
fn names(skeleton: &Skeleton, visits: &[BoneId]) -> String {
    if visits.is_empty() {
        return "none".to_owned();
    }
    let mut text = String::new();
    for (index, id) in visits.iter().enumerate() {
        let name = skeleton.get(*id).map_or("(not in the skeleton)", |bone| &bone.name);
        if index > 0 && text.chars().count() + 2 + name.chars().count() > LIST_WIDTH {
            return format!("{text}, … ({} in all)", visits.len());
        }
        let comma = if index > 0 { ", " } else { "" };
        text.push_str(comma);
        text.push_str(name);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::acclaim::figure::{hang_letter, root};
    use crate::dice::Dice;

    /// root (a (b, c (d)), e)
    fn small() -> Skeleton {
        let dice = &mut Dice::new(1, "small");
        let mut skeleton = root(dice);
        for parent in [0, 1, 1, 3, 0] {
            hang_letter(&mut skeleton, dice, BoneId(parent));
        }
        skeleton
    }

    /// What is said of these visits, where those of `wanted` are right.
    fn said(wanted: &[usize], visits: &[usize]) -> Option<String> {
        let skeleton = small();
        let start = wanted[0];
        let [wanted, seen] = [wanted, visits]
            .map(|visits| Seen::of(&skeleton, &visits.iter().copied().map(BoneId).collect::<Vec<_>>()));
        (wanted != seen).then(|| in_words(&skeleton, BoneId(start), &wanted, &seen))
    }

    #[test]
    fn siblings_may_come_in_any_order() {
        let all = &[0, 1, 2, 3, 4, 5];
        for visits in [[0, 1, 2, 3, 4, 5], [0, 5, 1, 3, 4, 2], [0, 5, 1, 2, 3, 4], [0, 1, 5, 3, 2, 4]] {
            assert_eq!(said(all, &visits), None, "{visits:?}");
        }
        assert_eq!(said(&[1, 2, 3, 4], &[1, 3, 2, 4]), None);
    }

    #[test]
    fn what_is_wrong_is_said_in_words() {
        let all = |visits| said(&[0, 1, 2, 3, 4, 5], visits).unwrap();
        assert_eq!(all(&[0, 1, 2, 3, 4]), "e is never visited");
        assert_eq!(all(&[0, 1, 5, 5, 2]), "c is never visited (and 1 other)");
        assert_eq!(all(&[]), "root is never visited (and 5 others)");
        assert_eq!(all(&[0, 1, 2, 3, 4, 5, 3]), "c is visited twice");
        assert_eq!(all(&[0, 1, 2, 3, 4, 5, 5, 5]), "e is visited 3 times");
        assert_eq!(all(&[0, 1, 2, 4, 3, 5]), "d is visited before its parent c");
        assert_eq!(all(&[1, 2, 3, 4, 5, 0]), "a is visited before its parent root (and 1 other)");
        assert_eq!(all(&[0, 1, 2, 3, 4, 5, 6]), "a bone is visited that is not in the skeleton");
        let middle = said(&[1, 2, 3, 4], &[1, 2, 3, 4, 5]).unwrap();
        assert_eq!(middle, "e does not hang on a, and is visited");
        let root_later = said(&[1, 2, 3, 4], &[1, 2, 3, 4, 0]).unwrap();
        assert_eq!(root_later, "root does not hang on a, and is visited");
    }

    #[test]
    fn a_long_list_is_cut_off() {
        let skeleton = small();
        let visits = |count: usize| (0..count).map(|id| BoneId(id % 6)).collect::<Vec<_>>();
        assert_eq!(names(&skeleton, &visits(0)), "none");
        assert_eq!(names(&skeleton, &visits(6)), "root, a, b, c, d, e");
        let long = names(&skeleton, &visits(1000));
        assert!(long.ends_with(", … (1000 in all)") && long.chars().count() < 80, "{long}");
        assert_eq!(names(&skeleton, &[BoneId(usize::MAX)]), "(not in the skeleton)");
    }
}
