//! The section `:hierarchy`: which bone hangs on which.

use skeleton::acclaim::{BoneData, BoneId, Root, Skeleton, SkeletonError};

use super::bones::{Bones, not_closed};
use super::near::near;
use super::sections::at_section;
use super::{Error, ErrorKind, Warning, words};
use crate::error::is_conflict_mark;
use crate::snippet::printable_start;
use crate::source::{Place, Source};
use crate::words::take;

/// Reads everything behind `:hierarchy`, and hangs the bones together.
pub(super) fn read(
    source: &mut Source,
    root: Root,
    bones: Bones,
    warnings: &mut Vec<Warning>,
) -> Result<Skeleton, Error> {
    let mut hierarchy = Hierarchy { above: vec![None; bones.data.len()], bones };
    hierarchy.read(source, warnings)?;
    hierarchy.build(source, root)
}

/// The root, or a bone by its place in the list.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Node {
    Root,
    Bone(usize),
}

struct Hierarchy {
    bones: Bones,
    /// What each bone hangs on, and where that is said.
    above: Vec<Option<(Node, Place)>>,
}

impl Hierarchy {
    fn read(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        source.peek();
        let line = source.place().line;
        take(source, "begin", "`begin`")?;
        while !source.take_word("end") {
            if at_section(source) || source.is_word("begin") {
                return Err(not_closed(source, String::from("the hierarchy"), line));
            }
            let parent = self.node(source)?;
            words::name(source, warnings)?;
            while !source.line_ends() {
                self.hang(source, parent)?;
                words::name(source, warnings)?;
            }
        }
        Ok(())
    }

    /// The bone that comes next hangs on `parent`.
    fn hang(&mut self, source: &mut Source, parent: Node) -> Result<(), Error> {
        let Node::Bone(bone) = self.node(source)? else {
            let kind = ErrorKind::RootAsChild { parent: self.label(parent) };
            return Err(Error::here(source, kind));
        };
        if let Some((first, Place { line, .. })) = self.above[bone] {
            let (bone, parent) = (self.label(Node::Bone(bone)), self.label(first));
            return Err(Error::here(source, ErrorKind::SecondParent { bone, parent, line }));
        }
        self.above[bone] = Some((parent, source.place()));
        Ok(())
    }

    /// What the next word names, without taking it.
    fn node(&self, source: &mut Source) -> Result<Node, Error> {
        let word = source.peek();
        if word.eq_ignore_ascii_case(b"root") {
            return Ok(Node::Root);
        }
        let name = String::from_utf8_lossy(word);
        if let Some(bone) = self.bones.find(&name) {
            return Ok(Node::Bone(bone));
        }
        if is_conflict_mark(word) {
            return Err(Error::unexpected(source, "a bone"));
        }
        let names = self.bones.data.iter().map(|bone| bone.name.as_str());
        let near = near(&name, ["root"].into_iter().chain(names));
        let found = printable_start(word);
        Err(Error::here(source, ErrorKind::UnknownBone { found, near }))
    }

    /// Adds all bones, each behind those that it hangs on, otherwise in the order of the file.
    fn build(mut self, source: &mut Source, root: Root) -> Result<Skeleton, Error> {
        let refused = |source: &mut Source, place: Place, error: SkeletonError| {
            Error::before(place, None, source, ErrorKind::Skeleton(error))
        };
        let mut skeleton = Skeleton::new(root).map_err(|error| refused(source, source.place(), error))?;
        let mut ids: Vec<Option<BoneId>> = vec![None; self.above.len()];
        // A bone met again on the way up, before it was added, means going round in a circle.
        let mut met = vec![false; self.above.len()];
        let mut waiting: Vec<usize> = Vec::new();
        for bone in 0..self.above.len() {
            let mut at = Node::Bone(bone);
            let mut parent = loop {
                let Node::Bone(next) = at else { break BoneId::ROOT };
                if let Some(id) = ids[next] {
                    break id;
                }
                if std::mem::replace(&mut met[next], true) {
                    return Err(self.cycle(source, next));
                }
                waiting.push(next);
                let Some((above, _)) = self.above[next] else { return Err(self.unattached(source, next)) };
                at = above;
            };
            while let Some(next) = waiting.pop() {
                let data = std::mem::take(&mut self.bones.data[next]);
                let added = skeleton.add_bone(parent, data);
                parent = added.map_err(|error| refused(source, self.bones.places[next], error))?;
                ids[next] = Some(parent);
            }
        }
        Ok(skeleton)
    }

    fn unattached(&self, source: &mut Source, bone: usize) -> Error {
        let kind = ErrorKind::Unattached { bone: self.label(Node::Bone(bone)) };
        Error::before(self.bones.places[bone], None, source, kind)
    }

    /// `bone` hangs on itself in the end.
    fn cycle(&self, source: &mut Source, bone: usize) -> Error {
        const MOST_NAMES: usize = 6;
        let above = |bone: &usize| match self.above[*bone] {
            Some((Node::Bone(above), _)) => Some(above),
            _ => None,
        };
        let mut around: Vec<usize> = std::iter::successors(above(&bone), above).take(MOST_NAMES).collect();
        let whole = around.iter().position(|&other| other == bone);
        around.truncate(whole.map_or(MOST_NAMES, |end| end + 1));
        let mut names = vec![self.label(Node::Bone(bone))];
        names.extend(around.into_iter().map(|bone| self.label(Node::Bone(bone))));
        if whole.is_none() {
            names.push(String::from("…"));
        }
        let place = self.above[bone].map_or(self.bones.places[bone], |(_, place)| place);
        Error::before(place, None, source, ErrorKind::Cycle { bones: names.join(" on ") })
    }

    fn label(&self, node: Node) -> String {
        match node {
            Node::Root => String::from("root"),
            Node::Bone(bone) => {
                let BoneData { name, .. } = &self.bones.data[bone];
                printable_start(name.as_bytes())
            }
        }
    }
}
