//! The rubric and the misconceptions as tables in Markdown, for handouts.

use std::fmt::Write;

use crate::{Misconception, PartRubric, Rubric};

/// What each check is worth.
pub fn rubric_table(rubric: &Rubric) -> String {
    let mut table = String::from("| part | check | points |\n|---|---|---|\n");
    for part in rubric.parts {
        for check in part.checks {
            row(&mut table, [part.title, check.title, &check.points.to_string()]);
        }
    }
    row(&mut table, ["", "**together**", &format!("**{}**", rubric.points())]);
    table
}

/// The same for those who mark: with the names by which checks are spoken of in results and in overrides.
pub fn checks_table(rubric: &Rubric) -> String {
    let mut table = String::from("| name | part | check | points |\n|---|---|---|---|\n");
    for part in rubric.parts {
        for check in part.checks {
            let name = format!("`{}/{}`", part.id, check.id);
            row(&mut table, [&name, part.title, check.title, &check.points.to_string()]);
        }
    }
    table
}

/// What each misconception costs, and what the student is told first.
pub fn misconceptions_table<'a>(
    parts: impl IntoIterator<Item = (&'a PartRubric, Vec<Misconception>)>,
) -> String {
    let mut table = String::from("| part | name | the student reads | points lost |\n|---|---|---|---|\n");
    for (part, misconceptions) in parts {
        for Misconception { id, title, costs, .. } in misconceptions {
            let lost = part.checks.iter().filter(|check| costs.contains(&check.id)).map(|check| check.points);
            row(&mut table, [part.title, &format!("`{id}`"), title, &lost.sum::<u32>().to_string()]);
        }
    }
    table
}

fn row<const N: usize>(table: &mut String, cells: [&str; N]) {
    // Writing to a string cannot fail.
    let _ = writeln!(table, "| {} |", cells.join(" | "));
}
