//! Reports as text for a terminal.
//!
//! What is said in colour is said in words too. Colours are taken out again where the text is printed without them.

use std::fmt::{self, Write};

use anstyle::{AnsiColor, Style};

use crate::{
    CheckReport, CheckState, FirstCase, Named, PartReport, PartState, Rubric, TreeLine, Trouble, WholeReport,
};

/// The reports of one run, for printing by `Display`.
pub struct Scoreboard<'a> {
    /// What the exercise is worth.
    pub rubric: &'a Rubric,
    /// The parts that were asked, in order.
    pub parts: &'a [PartReport],
    /// The whole motion, if it was asked.
    pub whole: Option<&'a WholeReport>,
}

/// Blue and yellow are told apart by nearly everyone.
const RIGHT: Style = AnsiColor::Cyan.on_default().bold();
const WRONG: Style = AnsiColor::Yellow.on_default().bold();
const STRONG: Style = Style::new().bold();
const FAINT: Style = Style::new().dimmed();

/// Columns of text.
const WIDTH: usize = 88;

impl fmt::Display for Scoreboard<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for part in self.parts {
            write_part(f, part)?;
        }
        if let Some(whole) = self.whole {
            write_whole(f, whole, self.parts)?;
        }
        self.write_points(f)
    }
}

impl Scoreboard<'_> {
    /// The points, part by part.
    pub fn rows(&self) -> Vec<Row> {
        self.parts.iter().map(Row::from).collect()
    }

    /// The points that were made, and those that could be, in the parts that were asked.
    pub fn points(&self) -> (u32, u32) {
        let points = self.parts.iter().map(PartReport::points).sum();
        (points, self.parts.iter().map(|part| part.rubric.points()).sum())
    }

    /// All points in one line: `Forward kinematics: 7 of 15 points.` Empty when no part was asked.
    pub fn verdict(&self) -> String {
        let (points, of) = self.points();
        let title = self.rubric.title;
        match self.parts.len() {
            0 => String::new(),
            all if all == self.rubric.parts.len() => format!("{title}: {points} of {of} points."),
            _ => format!("{title}: {points} of {of} points in the parts you checked."),
        }
    }

    /// Its end: the rows and the verdict, without what is said about each part.
    pub fn summary(&self) -> impl fmt::Display {
        struct Summary<'a>(&'a Scoreboard<'a>);
        impl fmt::Display for Summary<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.write_points(f)
            }
        }
        Summary(self)
    }

    /// What is said at the end when all is right.
    pub fn well_done(&self) -> String {
        format!(" Well done: {}.", self.rubric.invitation)
    }

    fn write_points(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f)?;
        self.rows().iter().try_for_each(|row| writeln!(f, "  {row}"))?;
        writeln!(f)?;
        if self.parts.is_empty() {
            return Ok(());
        }
        let (points, of) = self.points();
        let all_right = points == of && self.parts.len() == self.rubric.parts.len();
        let all = if all_right { self.well_done() } else { String::new() };
        writeln!(f, "{}{all}", Styled(STRONG, &self.verdict()))
    }
}

/// The points of one part. `Display` gives them as they stand on the scoreboard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The part's short name, for example `part1`.
    pub id: &'static str,
    /// What the part computes.
    pub title: &'static str,
    /// The points that were made.
    pub points: u32,
    /// The points that could be made.
    pub of: u32,
    /// How the part stands.
    pub state: PartState,
    /// The misconceptions that were recognised.
    pub named: Vec<Named>,
}

impl From<&PartReport> for Row {
    fn from(part: &PartReport) -> Row {
        Row {
            id: part.rubric.id,
            title: part.rubric.title,
            points: part.points(),
            of: part.rubric.points(),
            state: part.state,
            named: part.named.clone(),
        }
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row { id, title, points, of, state, .. } = self;
        write!(f, "{id}  {title:<20} {points:>2} of {of}  {}", Styled(style_of(*state), state.name()))
    }
}

fn style_of(state: PartState) -> Style {
    match state {
        PartState::Right => RIGHT,
        PartState::NotStarted => FAINT,
        _ => WRONG,
    }
}

fn write_part(f: &mut fmt::Formatter<'_>, part: &PartReport) -> fmt::Result {
    let (id, function) = (part.rubric.id, part.rubric.function);
    let (points, of) = (part.points(), part.rubric.points());
    writeln!(f)?;
    writeln!(
        f,
        "{}",
        Styled(STRONG, &format!("{id}: {function}, {points} of {of} points, {}", part.state.name()))
    )?;
    if part.state == PartState::NotStarted {
        let like = part.rubric.like_template;
        return wrapped(
            f,
            2,
            &format!(
                "Like the untouched template, your function returns {like}. Its comment says what it should do."
            ),
        );
    }
    write_checks(f, &part.checks)?;
    for named in &part.named {
        write_named(f, named)?;
        if let Some((title, first)) = first_wrong(part, |id| named.seen_in.contains(&id)) {
            write_first_case(f, title, first)?;
        }
    }
    let unexplained = |id: &'static str| !part.named.iter().any(|named| named.seen_in.contains(&id));
    if let Some((title, first)) = first_wrong(part, unexplained) {
        writeln!(f)?;
        wrapped(f, 2, "This matches none of the mistakes that we know. Compare the two answers:")?;
        write_first_case(f, title, first)?;
    }
    if let Some(remark) = part.remark {
        writeln!(f)?;
        wrapped(f, 2, remark)?;
    }
    Ok(())
}

/// The first wrong case of the first check that is wrong and whose name is `wanted`.
fn first_wrong(
    part: &PartReport,
    wanted: impl Fn(&'static str) -> bool,
) -> Option<(&'static str, &FirstCase)> {
    part.checks.iter().filter(|check| wanted(check.rubric.id)).find_map(|check| match &check.state {
        CheckState::Wrong(first) => Some((check.rubric.title, first)),
        CheckState::Right | CheckState::Failed { .. } => None,
    })
}

fn write_checks(f: &mut fmt::Formatter<'_>, checks: &[CheckReport]) -> fmt::Result {
    let mut said = None;
    for check in checks {
        let (of, title) = (check.rubric.points, check.rubric.title);
        match &check.state {
            CheckState::Right => writeln!(f, "  {}    {of} of {of}  {title}", Styled(RIGHT, "right"))?,
            CheckState::Wrong(first) => {
                writeln!(f, "  {}    0 of {of}  {title}", Styled(WRONG, "wrong"))?;
                if !first.groups.is_empty() {
                    wrapped(f, 19, &format!("only these are wrong: {}", first.groups.join(", ")))?;
                }
            }
            CheckState::Failed { failure, inputs } => {
                writeln!(f, "  {}  0 of {of}  {title}", Styled(WRONG, "stopped"))?;
                // One function often fails in the same way everywhere.
                if said.replace(failure) == Some(failure) {
                    wrapped(f, 19, "as above")?;
                } else {
                    wrapped(f, 19, &failure.to_string())?;
                    let inputs: Vec<String> =
                        inputs.iter().map(|(name, value)| format!("{name} {value}")).collect();
                    wrapped(f, 19, &format!("It was asked about: {}", inputs.join("; ")))?;
                }
            }
        }
    }
    Ok(())
}

fn write_named(f: &mut fmt::Formatter<'_>, named: &Named) -> fmt::Result {
    writeln!(f)?;
    writeln!(f, "  {}", Styled(STRONG, named.title))?;
    wrapped(f, 2, named.explanation)?;
    wrapped(f, 2, &format!("Hint: {}", named.hint))
}

fn write_first_case(f: &mut fmt::Formatter<'_>, title: &str, first: &FirstCase) -> fmt::Result {
    let FirstCase { inputs, difference, wrong, cases, .. } = first;
    writeln!(f)?;
    wrapped(f, 2, &format!("The first wrong case ({title}; {wrong} of {cases} wrong):"))?;
    for (name, value) in inputs {
        writeln!(f, "    {name:<32}  {value}")?;
    }
    writeln!(f, "    {:<32}  {}", "yours", Styled(WRONG, &difference.got))?;
    writeln!(f, "    {:<32}  {}", "expected", Styled(RIGHT, &difference.expected))?;
    writeln!(f, "    {:<32}  {}", "difference", difference.between)
}

fn write_whole(f: &mut fmt::Formatter<'_>, whole: &WholeReport, parts: &[PartReport]) -> fmt::Result {
    writeln!(f)?;
    let heading = |text: &str| Styled(STRONG, &format!("whole motion: {text}")).to_string();
    match &whole.trouble {
        None => {
            writeln!(f, "{}", heading("right"))?;
            wrapped(f, 2, &whole.praise)
        }
        Some(Trouble::Failed(failure)) => {
            writeln!(f, "{}", heading("could not be computed"))?;
            wrapped(f, 2, &failure.to_string())
        }
        // A tree full of joints that nobody has begun to place would only be in the way.
        Some(_) if parts.iter().any(|part| part.state == PartState::NotStarted) => {
            writeln!(f, "{}", heading("not yet"))?;
            wrapped(
                f,
                2,
                "When all three parts are begun, this shows what they do together. It gives no points.",
            )
        }
        Some(Trouble::Different { summary, details }) => {
            writeln!(f, "{}", heading("off"))?;
            wrapped(f, 2, summary)?;
            details.iter().try_for_each(|line| wrapped(f, 2, line))
        }
        Some(Trouble::Off { worst, first, frame, angles, tree }) => {
            writeln!(f, "{}", heading("off"))?;
            wrapped(f, 2, &format!("With your three functions together, {worst}."))?;
            if let Some(angles) = angles {
                wrapped(f, 2, angles)?;
            }
            wrapped(
                f,
                2,
                &format!("In frame {frame} the first wrong joint is {first}: look at what it does."),
            )?;
            writeln!(f)?;
            tree.iter().try_for_each(|line| write_tree_line(f, line))
        }
    }
}

fn write_tree_line(f: &mut fmt::Formatter<'_>, line: &TreeLine) -> fmt::Result {
    let indent = "  ".repeat(line.depth.min(20));
    let name = format!("{indent}{}", line.name);
    match (&line.off, line.first) {
        (None, _) => writeln!(f, "    {name:<34}  {}", Styled(RIGHT, "right")),
        (Some(off), false) => writeln!(f, "    {name:<34}  {off}"),
        (Some(off), true) => {
            writeln!(f, "  > {name:<34}  {}", Styled(WRONG, &format!("{off}, the first wrong joint")))
        }
    }
}

/// Writes text in lines of at most `WIDTH` columns, indented.
fn wrapped(f: &mut impl Write, indent: usize, text: &str) -> fmt::Result {
    let mut column = 0;
    for word in text.split_whitespace() {
        if column > 0 && column + 1 + word.chars().count() > WIDTH {
            writeln!(f)?;
            column = 0;
        }
        if column == 0 {
            write!(f, "{:indent$}", "")?;
            column = indent;
        } else {
            write!(f, " ")?;
            column += 1;
        }
        write!(f, "{word}")?;
        column += word.chars().count();
    }
    writeln!(f)
}

struct Styled<'a>(Style, &'a str);

impl fmt::Display for Styled<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{:#}", self.0, self.1, self.0)
    }
}
