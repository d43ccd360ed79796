//! What there is to say of all bones together.

use std::fmt;

use skeleton::acclaim::{Bone, BonePlace};

use super::Facts;
use crate::scene::{Line, Panel};

/// So many bones are named.
const MOST_NAMES: usize = 3;

/// How many bones part 3 visits. Before it is begun that is the root alone, and nothing is wrong with that.
pub fn visited(facts: &Facts, places: &[Option<BonePlace>], panel: &mut Panel) {
    let Some(bones) = facts.app.stage().bones() else { return };
    let (all, visited) = (places.len(), places.iter().flatten().count());
    let board = facts.standing.and_then(|standing| standing.board.as_ref());
    match () {
        () if visited == all => {}
        () if board.is_none() || !facts.is_begun(2) => {
            panel.add(Line::Text, format_args!("part 3 visits {visited} of {all} bones"));
        }
        () => {
            let skeleton = bones.motion().skeleton().bones().iter();
            let missing = skeleton.zip(places).filter(|(_, place)| place.is_none()).map(|(bone, _)| bone);
            let names = Names(missing);
            panel.add(Line::Trouble, format_args!("part 3 visits {visited} of {all} bones, and not {names}"));
        }
    }
}

/// Of the bones that have a place, how many are not where anything could be, and how many there are.
pub fn lost(places: &[Option<BonePlace>]) -> (usize, usize) {
    let visited = places.iter().flatten();
    let lost = visited.clone().filter(|place| !(place.start.is_finite() && place.end.is_finite()));
    (lost.count(), visited.count())
}

/// Warns where the file means other products than that of the exercise.
pub fn in_other_orders(facts: &Facts, panel: &mut Panel) {
    let Some(bones) = facts.app.stage().bones().filter(|_| facts.is_of_bones()) else { return };
    if bones.in_other_orders().next().is_some() {
        let names = Names(bones.in_other_orders());
        panel.add(
            Line::Trouble,
            format_args!(
                "{names}: not listed as rx ry rz in this file. The exercise turns them by Rz Ry Rx all the same, and so does the goal"
            ),
        );
    }
}

/// The names of some bones: the first few, and how many more there are.
struct Names<I>(I);

impl<'a, I: Iterator<Item = &'a Bone> + Clone> fmt::Display for Names<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, bone) in self.0.clone().take(MOST_NAMES).enumerate() {
            let comma = if index > 0 { ", " } else { "" };
            write!(f, "{comma}{}", bone.name)?;
        }
        match self.0.clone().skip(MOST_NAMES).count() {
            0 => Ok(()),
            more => write!(f, " and {more} more"),
        }
    }
}
