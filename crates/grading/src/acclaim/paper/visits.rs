//! Part 3: trees of bones.

use exam::acclaim::Question as AcclaimQuestion;
use skeleton::acclaim::{BoneId, Skeleton};

use super::{Draft, input};
use crate::acclaim::compare;
use crate::acclaim::figure::{figure, hang_letter, root};
use crate::dice::Dice;

/// So many columns of a tree are shown.
const TREE_WIDTH: usize = 60;

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    match check {
        "chain" => [2, 4, 9].map(|bones| chain(dice, bones)).into(),
        "siblings" => vec![star(dice, 0), star(dice, 2), two_stars(dice)],
        "subtree" => {
            let mut drafts = vec![branch(dice, 4), branch(dice, 6), branch(dice, 7)];
            let figure = figure(dice);
            drafts.extend(["lowerback", "lhipjoint"].map(|name| draft(&figure, id(&figure, name))));
            drafts
        }
        "all" => {
            let trees = [6, 9, 12].map(|bones| {
                let mut skeleton = root(dice);
                hang_tree(&mut skeleton, dice, BoneId::ROOT, bones);
                draft(&skeleton, BoneId::ROOT)
            });
            trees.into_iter().chain([draft(&figure(dice), BoneId::ROOT)]).collect()
        }
        _ => Vec::new(),
    }
}

fn id(skeleton: &Skeleton, name: &str) -> BoneId {
    skeleton.find(name).map_or(BoneId::ROOT, |bone| bone.id)
}

/// Each bone hangs on the one before it.
fn chain(dice: &mut Dice, bones: usize) -> Draft {
    let mut skeleton = root(dice);
    hang_chain(&mut skeleton, dice, bones);
    draft(&skeleton, BoneId::ROOT)
}

/// Several bones, on which nothing hangs, at the end of a chain.
fn star(dice: &mut Dice, chain: usize) -> Draft {
    let mut skeleton = root(dice);
    let centre = hang_chain(&mut skeleton, dice, chain);
    hang_star(&mut skeleton, dice, centre);
    draft(&skeleton, BoneId::ROOT)
}

/// Several bones on the root, and several more on the first of them.
fn two_stars(dice: &mut Dice) -> Draft {
    let mut skeleton = root(dice);
    let first = hang_star(&mut skeleton, dice, BoneId::ROOT);
    hang_star(&mut skeleton, dice, first);
    draft(&skeleton, BoneId::ROOT)
}

/// The bone in question has `bones` below it, and siblings on both sides that have some too.
fn branch(dice: &mut Dice, bones: usize) -> Draft {
    let mut skeleton = root(dice);
    hang_tree(&mut skeleton, dice, BoneId::ROOT, 2);
    let start = hang_letter(&mut skeleton, dice, BoneId::ROOT);
    hang_tree(&mut skeleton, dice, start, bones);
    let next = hang_letter(&mut skeleton, dice, BoneId::ROOT);
    hang_tree(&mut skeleton, dice, next, 1);
    draft(&skeleton, start)
}

/// Gives the last bone.
fn hang_chain(skeleton: &mut Skeleton, dice: &mut Dice, bones: usize) -> BoneId {
    (0..bones).fold(BoneId::ROOT, |parent, _| hang_letter(skeleton, dice, parent))
}

/// Hangs three to five bones on one, and gives the first.
fn hang_star(skeleton: &mut Skeleton, dice: &mut Dice, centre: BoneId) -> BoneId {
    let first = hang_letter(skeleton, dice, centre);
    for _ in 0..2 + dice.below(3) {
        hang_letter(skeleton, dice, centre);
    }
    first
}

/// Hangs bones on `top` and on one another, as the dice fall.
fn hang_tree(skeleton: &mut Skeleton, dice: &mut Dice, top: BoneId, bones: usize) {
    let mut ids = vec![top];
    for _ in 0..bones {
        let parent = ids[dice.below(ids.len())];
        ids.push(hang_letter(skeleton, dice, parent));
    }
}

fn draft(skeleton: &Skeleton, start: BoneId) -> Draft {
    let whole = tree(skeleton, BoneId::ROOT);
    let shown = if whole.chars().count() <= TREE_WIDTH { whole } else { format!("{} bones", skeleton.len()) };
    let name = skeleton.get(start).map_or("root", |bone| &bone.name);
    Draft {
        question: AcclaimQuestion::Visits { skeleton: skeleton.clone(), bone: start },
        inputs: vec![input("skeleton", shown), input("bone to begin with", name)],
        difference: compare::visits,
        group: None,
        size: skeleton.extent(),
    }
}

/// A bone and what hangs on it, in brackets: `root (a (b, c), d)`.
fn tree(skeleton: &Skeleton, top: BoneId) -> String {
    let name = skeleton.get(top).map_or("", |bone| &bone.name);
    let below: Vec<String> = skeleton.children(top).map(|child| tree(skeleton, child.id)).collect();
    if below.is_empty() { name.to_owned() } else { format!("{name} ({})", below.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tree_is_shown_in_brackets() {
        let dice = &mut Dice::new(1, "tree");
        let mut skeleton = root(dice);
        assert_eq!(tree(&skeleton, BoneId::ROOT), "root");
        for parent in [0, 1, 1, 0] {
            hang_letter(&mut skeleton, dice, BoneId(parent));
        }
        assert_eq!(tree(&skeleton, BoneId::ROOT), "root (a (b, c), d)");
    }
}
