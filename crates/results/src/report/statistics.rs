//! What is counted over all students.

use std::collections::{BTreeMap, HashMap};

use crate::book::{Book, Entry};
use crate::{CheckState, Error, Flag, Points, Standing, Verdict};

pub(super) struct Statistics {
    /// How many there are of each status, by its code.
    pub statuses: BTreeMap<&'static str, usize>,
    /// The points of all who have any, from few to many. A student's second submission is left out where it does not count.
    pub points: Vec<Points>,
    /// By part and check: in how many graded submissions it is right.
    pub right: Vec<Vec<usize>>,
    pub graded: usize,
    /// In which groups each id is, from 1.
    pub groups: HashMap<String, Vec<usize>>,
    /// The misconceptions in the order of the parts, the most frequent first.
    pub misconceptions: Vec<Misconception>,
}

pub(super) struct Misconception {
    pub id: String,
    pub title: String,
    /// The index of its part.
    pub part: usize,
    /// Whose it is: indices of entries.
    pub who: Vec<usize>,
}

impl Statistics {
    pub fn of(book: &Book<'_>) -> Result<Statistics, Error> {
        let parts = &book.run.parts;
        let mut all = Statistics {
            statuses: BTreeMap::new(),
            points: book.entries.iter().filter_map(points_of_student).collect(),
            right: parts.iter().map(|part| vec![0; part.checks.len()]).collect(),
            graded: 0,
            groups: HashMap::new(),
            misconceptions: Vec::new(),
        };
        all.points.sort_unstable();
        for (index, group) in book.groups.iter().enumerate() {
            for id in &group.ids {
                all.groups.entry(id.clone()).or_default().push(index + 1);
            }
        }
        let mut found: BTreeMap<(usize, String), Misconception> = BTreeMap::new();
        let mut index = 0;
        book.each(|entry, record| -> Result<(), Error> {
            *all.statuses.entry(entry.code).or_default() += 1;
            if let Verdict::Graded { parts: results, .. } = &record.verdict {
                all.graded += 1;
                for result in results {
                    let Some(part) = parts.iter().position(|part| part.id == result.id) else { continue };
                    for check in result.checks.iter().filter(|check| check.state == CheckState::Right) {
                        let place = parts[part].checks.iter().position(|known| known.id == check.id);
                        if let Some(right) = place.and_then(|place| all.right[part].get_mut(place)) {
                            *right += 1;
                        }
                    }
                    for named in &result.named {
                        let new = || Misconception {
                            id: named.id.clone(),
                            title: named.title.clone(),
                            part,
                            who: Vec::new(),
                        };
                        found.entry((part, named.id.clone())).or_insert_with(new).who.push(index);
                    }
                }
            }
            index += 1;
            Ok(())
        })?;
        all.misconceptions = found.into_values().collect();
        all.misconceptions.sort_by_key(|one| (one.part, usize::MAX - one.who.len()));
        Ok(all)
    }

    /// The middle one, or the mean of the middle two, with one decimal.
    pub fn median(&self) -> Option<f64> {
        let middle = self.points.len() / 2;
        let high = self.points.get(middle)?.as_f64();
        let low = if self.points.len().is_multiple_of(2) { self.points[middle - 1].as_f64() } else { high };
        Some(((low + high) * 5.0).round() / 10.0)
    }
}

fn points_of_student(entry: &Entry) -> Option<Points> {
    let undecided =
        |flag: &Flag| matches!(flag, Flag::OtherSubmissions { standing: Standing::Undecided, .. });
    entry.mark.points.filter(|_| entry.mark.counts || entry.mark.flags.iter().any(undecided))
}
