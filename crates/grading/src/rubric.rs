//! What an exercise's parts and checks are worth. Every report and every handout takes its points from here.

/// All parts of one exercise.
#[derive(Debug)]
pub struct Rubric {
    /// The exercise's package, for example `fk`.
    pub exercise: &'static str,
    /// What the exercise is about.
    pub title: &'static str,
    /// What to do when all is right, for example "run `cargo view`".
    pub invitation: &'static str,
    /// The parts in order.
    pub parts: &'static [PartRubric],
}

/// One part: one function of the student's.
#[derive(Debug)]
pub struct PartRubric {
    /// The test's name without the function, for example `part1`.
    pub id: &'static str,
    /// The function that is asked.
    pub function: &'static str,
    /// What it computes.
    pub title: &'static str,
    /// What else to look at when a function that has been changed still answers like the template.
    pub like_template: &'static str,
    /// What is checked.
    pub checks: &'static [CheckRubric],
}

/// One check: passed as a whole or not.
#[derive(Debug)]
pub struct CheckRubric {
    /// A short name for tables, for example `rotation_orders`.
    pub id: &'static str,
    /// What the check is worth.
    pub points: u32,
    /// What it looks at, in a few words.
    pub title: &'static str,
}

impl CheckRubric {
    /// A check with its name, its points, and what it looks at.
    pub(crate) const fn new(id: &'static str, points: u32, title: &'static str) -> CheckRubric {
        CheckRubric { id, points, title }
    }
}

impl Rubric {
    /// The points of the whole exercise.
    pub fn points(&self) -> u32 {
        self.parts.iter().map(PartRubric::points).sum()
    }
}

impl PartRubric {
    /// The points of all checks.
    pub fn points(&self) -> u32 {
        self.checks.iter().map(|check| check.points).sum()
    }

    /// The test's name: `part1_local_quaternion`.
    pub fn test_name(&self) -> String {
        format!("{}_{}", self.id, self.function)
    }
}
