//! Who shares which telling passages.

use std::collections::{BTreeMap, HashMap};

use super::{Class, FEWEST, Group, Likeness};

/// Which classes have which telling passages.
pub(super) struct Index {
    /// The classes with a passage, for each telling passage that several have.
    shared: Vec<Vec<usize>>,
    /// The entries of `shared` in which a class is.
    of_class: Vec<Vec<usize>>,
    /// How many telling passages each class has.
    pub(super) telling: Vec<usize>,
}

impl Index {
    pub(super) fn new(classes: &[Class<'_>]) -> Self {
        let few = (classes.len() / 20).clamp(3, 30);
        let mut with_passage: HashMap<u64, Vec<usize>> = HashMap::new();
        for (class, passage) in
            classes.iter().enumerate().flat_map(|(i, class)| class.own.iter().map(move |p| (i, *p)))
        {
            let known = with_passage.entry(passage).or_default();
            // One more than few shows that it is too many.
            if known.len() <= few {
                known.push(class);
            }
        }
        let mut index = Self {
            shared: Vec::new(),
            of_class: vec![Vec::new(); classes.len()],
            telling: vec![0; classes.len()],
        };
        for class_list in with_passage.into_values().filter(|list| list.len() <= few) {
            for class in &class_list {
                index.telling[*class] += 1;
                if class_list.len() > 1 {
                    index.of_class[*class].push(index.shared.len());
                }
            }
            if class_list.len() > 1 {
                index.shared.push(class_list);
            }
        }
        index
    }

    pub(super) fn partly(&self, classes: &[Class<'_>], threshold: u8) -> Vec<Group> {
        let mut sets = Sets::new(classes.len());
        let mut links: Vec<Link> = Vec::new();
        let mut count = vec![0; classes.len()];
        for (class, shared) in self.of_class.iter().enumerate() {
            let mut met = Vec::new();
            for other in shared.iter().flat_map(|i| &self.shared[*i]).copied().filter(|other| *other > class)
            {
                if count[other] == 0 {
                    met.push(other);
                }
                count[other] += 1;
            }
            for other in met {
                let common = std::mem::take(&mut count[other]);
                let percent = 100 * common / self.telling[class].min(self.telling[other]).max(1);
                if common >= FEWEST && percent >= usize::from(threshold) {
                    sets.join(class, other);
                    links.push(Link { class, percent, common });
                }
            }
        }
        let mut groups: BTreeMap<usize, Group> = BTreeMap::new();
        for link in links {
            let group = groups.entry(sets.find(link.class)).or_insert_with(|| Group {
                likeness: Likeness::Partly,
                ids: Vec::new(),
                percent: 100,
                telling: usize::MAX,
            });
            group.percent = group.percent.min(u8::try_from(link.percent).unwrap_or(100));
            group.telling = group.telling.min(link.common);
        }
        for (i, class) in classes.iter().enumerate() {
            if let Some(group) = groups.get_mut(&sets.find(i)) {
                group.ids.extend(class.ids());
            }
        }
        groups.into_values().collect()
    }
}

/// Two classes that are partly alike.
struct Link {
    class: usize,
    percent: usize,
    common: usize,
}

/// Disjoint sets of `0..n`.
struct Sets {
    parent: Vec<usize>,
}

impl Sets {
    fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    fn find(&mut self, mut i: usize) -> usize {
        while self.parent[i] != i {
            self.parent[i] = self.parent[self.parent[i]];
            i = self.parent[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b)] = a.min(b);
    }
}
