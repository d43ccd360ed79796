//! Part 3.

use skeleton::acclaim::{Bone, BoneId, Skeleton, Visitor};

/// The bone of a link, if there is one.
fn bone(skeleton: &Skeleton, link: Option<BoneId>) -> Option<&Bone> {
    link.and_then(|id| skeleton.get(id))
}

/// What hangs on the bone directly.
fn children<'a>(skeleton: &'a Skeleton, parent: &Bone) -> Vec<&'a Bone> {
    skeleton.children(parent.id).collect()
}

pub fn first_child_only(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    if let Some(child) = bone(skeleton, start.child) {
        first_child_only(skeleton, child, visitor);
    }
}

/// Goes down from the first child only.
pub fn siblings_not_entered(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    let children = children(skeleton, start);
    if let Some((first, others)) = children.split_first() {
        siblings_not_entered(skeleton, first, visitor);
        others.iter().for_each(|other| visitor.visit(other));
    }
}

/// Every bone visits the siblings that follow it.
pub fn own_siblings_not_entered(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    if let Some(child) = bone(skeleton, start.child) {
        own_siblings_not_entered(skeleton, child, visitor);
    }
    let mut next = bone(skeleton, start.sibling);
    while let Some(sibling) = next {
        visitor.visit(sibling);
        next = bone(skeleton, sibling.sibling);
    }
}

pub fn children_only(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    children(skeleton, start).into_iter().for_each(|child| visitor.visit(child));
}

/// Leaves out the first child of each bone, or the last one.
pub fn one_child_short<const FIRST: bool>(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    let children = children(skeleton, start);
    let rest = if FIRST { children.get(1..) } else { children.split_last().map(|(_, rest)| rest) };
    for child in rest.unwrap_or_default() {
        one_child_short::<FIRST>(skeleton, child, visitor);
    }
}

pub fn leaves_left_out(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    if start.child.is_none() {
        return;
    }
    visitor.visit(start);
    for child in children(skeleton, start) {
        leaves_left_out(skeleton, child, visitor);
    }
}

pub fn start_left_out(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    for child in children(skeleton, start) {
        visitor.visit(child);
        start_left_out(skeleton, child, visitor);
    }
}

/// Every child is visited by the bone that it hangs on, and the root by itself.
pub fn only_a_root_begins(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    if start.is_root() {
        visitor.visit(start);
    }
    for child in children(skeleton, start) {
        visitor.visit(child);
        only_a_root_begins(skeleton, child, visitor);
    }
}

pub fn sibling_where_no_child(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    if let Some(next) = bone(skeleton, start.child.or(start.sibling)) {
        sibling_where_no_child(skeleton, next, visitor);
    }
}

pub fn child_where_no_sibling(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    if let Some(next) = bone(skeleton, start.sibling.or(start.child)) {
        child_where_no_sibling(skeleton, next, visitor);
    }
}

pub fn children_first(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    for child in children(skeleton, start) {
        children_first(skeleton, child, visitor);
    }
    visitor.visit(start);
}

/// The same by two calls, one of them for the bone's own siblings.
pub fn child_first(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    if let Some(child) = bone(skeleton, start.child) {
        child_first(skeleton, child, visitor);
    }
    visitor.visit(start);
    if let Some(sibling) = bone(skeleton, start.sibling) {
        child_first(skeleton, sibling, visitor);
    }
}

/// Visits each child and then hands it on to a function that does so too.
pub fn children_twice(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    for child in children(skeleton, start) {
        visitor.visit(child);
        children_twice(skeleton, child, visitor);
    }
}

/// Comes back to the bone after each child.
pub fn parent_again(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    for child in children(skeleton, start) {
        parent_again(skeleton, child, visitor);
        visitor.visit(start);
    }
}

/// Before and after what hangs on it.
pub fn before_and_after(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    for child in children(skeleton, start) {
        before_and_after(skeleton, child, visitor);
    }
    visitor.visit(start);
}

/// Right when the root is asked for.
pub fn own_siblings(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    visitor.visit(start);
    for next in [start.child, start.sibling].into_iter().filter_map(|link| bone(skeleton, link)) {
        own_siblings(skeleton, next, visitor);
    }
}

pub fn all_bones(skeleton: &Skeleton, _: &Bone, visitor: &mut Visitor) {
    skeleton.bones().iter().for_each(|bone| visitor.visit(bone));
}

pub fn all_from_here(skeleton: &Skeleton, start: &Bone, visitor: &mut Visitor) {
    skeleton.bones().iter().skip(start.id.0).for_each(|bone| visitor.visit(bone));
}
