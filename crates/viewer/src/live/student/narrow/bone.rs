//! Acclaim forward kinematics: the bone.
//!
//! Part 3 is asked by itself first: which bones it visits has nothing to do with how they are turned. Where it answers, parts
//! 1 and 2 are asked about one bone after the other, as they are while a frame is posed.

use exam::acclaim::{Answer as AcclaimAnswer, Given, Question as AcclaimQuestion};
use exam::{Failure, Subject};
use skeleton::acclaim::{Bone, BoneId, BonePlace, Posture};

use super::super::ask::{self, PIECE_LIMIT};
use super::{Place, same_kind, short};
use crate::motion::bones::Bones;
use crate::motion::stage::Stage;

/// A question about one bone holds the whole skeleton. With more bones than this nobody would wait for all of them.
const MOST_BONES: usize = 500;

/// Of questions that end in a loop or a crash, each of which takes long, so many are enough for the depth of a body.
const MOST_COSTLY: usize = 12;

pub(super) fn find(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Place {
    let Some(bones) = stage.bones() else { return Place::default() };
    let mut search = Search { subject, bones, failure };
    match search.visits(BoneId::ROOT) {
        Ok(visits) => search.turned_or_placed(&visits, &stage.posture(index)),
        Err(true) => {
            Place { at: search.visited().map(|bone| search.name(bone)), part: Some(2), ..Place::default() }
        }
        Err(false) => Place::default(),
    }
}

struct Search<'a, S> {
    subject: &'a mut S,
    bones: &'a Bones,
    failure: &'a Failure,
}

impl<S: Subject> Search<'_, S> {
    fn name(&self, bone: BoneId) -> String {
        let bone = self.bones.motion().skeleton().get(bone);
        format!("bone {}", short(bone.map_or("", |bone| &bone.name)))
    }

    /// Puts a question. Without an answer it gives whether that is the failure whose place is looked for.
    fn put(&mut self, question: AcclaimQuestion) -> Result<AcclaimAnswer, bool> {
        let answer = ask::warm_up(self.subject).and_then(|()| ask::put(self.subject, question, PIECE_LIMIT));
        answer.map_err(|other| same_kind(&other, self.failure))
    }

    fn visits(&mut self, bone: BoneId) -> Result<Vec<BoneId>, bool> {
        let skeleton = self.bones.motion().skeleton().clone();
        match self.put(AcclaimQuestion::Visits { skeleton, bone })? {
            AcclaimAnswer::Visits(visits) => Ok(visits),
            _ => Err(false),
        }
    }

    /// The bone at which part 3 fails: it does so when it begins with this bone, and not when it begins with one that hangs on
    /// it. Who fails at other bones like it, too, may have done so at any of them: then none is told, and neither is one that
    /// takes too long to find.
    fn visited(&mut self) -> Option<BoneId> {
        let skeleton = self.bones.motion().skeleton();
        if skeleton.len() > MOST_BONES {
            return None;
        }
        let most = if matches!(self.failure, Failure::Panicked { .. }) { MOST_BONES } else { MOST_COSTLY };
        let mut above = vec![BoneId::ROOT];
        while let Some(at) = above.last() {
            let mut failing = None;
            for child in skeleton.children(*at) {
                match self.visits(child.id) {
                    Ok(_) => {}
                    Err(true) => {
                        failing = Some(child.id);
                        break;
                    }
                    Err(false) => return None,
                }
            }
            match failing {
                Some(_) if above.len() >= most => return None,
                Some(child) => above.push(child),
                None => break,
            }
        }
        let found = skeleton.get(*above.last()?)?;
        let is_like_it = |bone: &&Bone| bone.child.is_some() == found.child.is_some();
        let like_it = skeleton.bones().iter().filter(is_like_it).find(|bone| !above.contains(&bone.id))?;
        self.visits(like_it.id).is_ok().then_some(found.id)
    }

    /// The first bone at which part 1 or part 2 fails, in the order of the visits.
    fn turned_or_placed(&mut self, visits: &[BoneId], posture: &Posture) -> Place {
        let skeleton = self.bones.motion().skeleton();
        if skeleton.len() > MOST_BONES {
            return Place::default();
        }
        let mut places: Vec<Option<BonePlace>> = vec![None; skeleton.len()];
        for bone in visits.iter().take(MOST_BONES).filter_map(|id| skeleton.get(*id)) {
            let parent = bone.parent.and_then(|parent| places[parent.0]);
            match self.place(bone, Given::new(bone, posture, parent)) {
                Ok(place) => places[bone.id.0] = Some(place),
                Err(Some(part)) => {
                    return Place { at: Some(self.name(bone.id)), part: Some(part), ..Place::default() };
                }
                Err(None) => return Place::default(),
            }
        }
        Place::default()
    }

    /// Where a bone is, by parts 1 and 2, or the part that fails as it is looked for; nothing when it fails otherwise.
    fn place(&mut self, bone: &Bone, given: Given) -> Result<BonePlace, Option<usize>> {
        let skeleton = || self.bones.motion().skeleton().clone();
        let Given { angles, parent, parent_end, translation } = given;
        let question = AcclaimQuestion::Rotation { skeleton: skeleton(), bone: bone.id, angles, parent };
        let rotation = match self.put(question) {
            Ok(AcclaimAnswer::Rotation(rotation)) => rotation,
            Err(true) => return Err(Some(0)),
            _ => return Err(None),
        };
        let (skeleton, bone) = (skeleton(), bone.id);
        let question = AcclaimQuestion::Ends { skeleton, bone, rotation, parent_end, translation };
        match self.put(question) {
            Ok(AcclaimAnswer::Ends(start, end)) => Ok(BonePlace { rotation, start, end }),
            Err(true) => Err(Some(1)),
            _ => Err(None),
        }
    }
}
