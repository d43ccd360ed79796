//! From a solution to the file that a student starts with.
//!
//! In a solution, the lines between `// solution-begin` and `// solution-end` are what the student is to find. Behind
//! `// solution-else` stands, in comments, what the student's file holds in their place:
//!
//! ```
//! use solutions::template::strip;
//!
//! let solution = "\
//! fn three() -> u8 {
//!     // solution-begin
//!     1 + 2
//!     // solution-else
//!     // 0
//!     // solution-end
//! }
//! ";
//! assert_eq!(strip(solution).as_deref(), Ok("fn three() -> u8 {\n    0\n}\n"));
//! ```

use std::fmt;

/// Takes the solution blocks out of a solution's source.
///
/// # Errors
///
/// When a marker stands where it cannot, with its line.
pub fn strip(solution: &str) -> Result<String, TemplateError> {
    let mut place = Place::Outside;
    let mut template = String::with_capacity(solution.len());
    for (index, line) in solution.lines().enumerate() {
        let wrong = Err(TemplateError { line: index + 1 });
        place = match (line.trim(), place) {
            ("// solution-begin", Place::Outside) => Place::Solution,
            ("// solution-else", Place::Solution) => Place::Instead,
            ("// solution-end", Place::Solution | Place::Instead) => Place::Outside,
            ("// solution-begin" | "// solution-else" | "// solution-end", _) => return wrong,
            (_, Place::Outside) => {
                template.push_str(line);
                template.push('\n');
                Place::Outside
            }
            (_, Place::Solution) => Place::Solution,
            (_, Place::Instead) => {
                let Some((indent, code)) = line.split_once("// ") else { return wrong };
                template.extend([indent, code, "\n"]);
                Place::Instead
            }
        };
    }
    match place {
        Place::Outside => Ok(template),
        Place::Solution | Place::Instead => Err(TemplateError { line: solution.lines().count() }),
    }
}

#[derive(Clone, Copy)]
enum Place {
    Outside,
    Solution,
    Instead,
}

/// A solution marker stands where it cannot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TemplateError {
    /// The line, from 1.
    pub line: usize,
}

impl fmt::Display for TemplateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "line {}: the markers must come in the order solution-begin, solution-else (if at all), solution-end, \
             and what follows solution-else must be in comments",
            self.line
        )
    }
}

impl std::error::Error for TemplateError {}
