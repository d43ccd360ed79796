//! The file that a student starts with is the solution with its solution blocks taken out.
//!
//! After a change to a solution, `FK_LAB_BLESS=1 cargo test -p solutions template` writes the students' files again.

use std::path::Path;
use std::{env, fs};

use solutions::template::{TemplateError, strip};

/// The exercises, each with the solution's file and the student's.
const PAIRS: [(&str, &str); 1] = [("src/fk.rs", "../exercises/fk/src/fk.rs")];

#[test]
fn template_is_the_solution_without_its_blocks() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (solution, template) in PAIRS {
        let solution = fs::read_to_string(here.join(solution)).unwrap();
        let path = here.join(template);
        let expected = strip(&solution).unwrap();
        assert!(expected.len() < solution.len(), "{template}: nothing was taken out");
        if env::var_os("FK_LAB_BLESS").is_some() {
            fs::write(&path, &expected).unwrap();
        }
        let found = fs::read_to_string(&path).unwrap();
        assert!(
            found == expected,
            "{template} is not the untouched template. If you have solved the exercise in it, all is well: this test \
             is for those who change the course."
        );
    }
}

#[test]
fn markers_out_of_order_are_errors() {
    let error = |source: &str| strip(source).unwrap_err();
    assert_eq!(error("// solution-end\n"), TemplateError { line: 1 });
    assert_eq!(error("a\n// solution-begin\n// solution-begin\n"), TemplateError { line: 3 });
    assert_eq!(error("// solution-else\n"), TemplateError { line: 1 });
    assert_eq!(error("// solution-begin\nb\n"), TemplateError { line: 2 });
    assert_eq!(
        error("// solution-begin\n// solution-else\ncode\n// solution-end\n"),
        TemplateError { line: 3 }
    );
}
