//! `cargo test -p fk`: the student's own scoreboard.

use std::env;
use std::process::{Command, ExitCode};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use exam::{Failure, Functions, Subject, WorkerProcess};
use libtest_mimic::{Arguments, Failed, Trial};

use crate::scoreboard::Scoreboard;
use crate::{
    Exam, Exercise, PUBLIC_SEED, PartReport, Solutions, WholeReport, grade_part, grade_whole_motion,
};

/// How long a check may take when students grade themselves.
pub const CHECK_LIMIT: Duration = Duration::from_secs(10);

/// What [`self_grade`] finds out, for programs that show it themselves.
#[derive(Clone, Debug)]
pub struct Graded {
    /// The parts in the rubric's order.
    pub parts: Vec<PartReport>,
    /// What they do together.
    pub whole: WholeReport,
}

impl Graded {
    /// Asks `subject` all questions of `exam`, and lets it forget what it keeps before every part, as [`self_grade`] does.
    /// `limit` is how long a check may take: there it is [`CHECK_LIMIT`].
    pub fn ask(subject: &mut dyn Subject, exam: &Exam, limit: Duration) -> Graded {
        let mut part = |part| {
            subject.restart();
            grade_part(subject, part, limit)
        };
        let parts = exam.parts.iter().map(&mut part).collect();
        subject.restart();
        Graded { parts, whole: grade_whole_motion(subject, &exam.whole_motion, limit) }
    }

    /// The text that [`self_grade`] prints.
    pub fn scoreboard(&self, exam: &Exam) -> Scoreboard<'_> {
        Scoreboard { rubric: exam.rubric, parts: &self.parts, whole: Some(&self.whole) }
    }
}

/// Tells this program, started once more, to answer questions instead of asking them.
const WORKER: &str = "FK_LAB_WORKER";

/// Runs the checks that the command line asks for and prints the scoreboard. The exit code is 0 when all is right.
///
/// The functions run in processes of their own, which are this program again: a panic, an endless loop or a crash of
/// theirs costs the check that it happens in, and no other.
pub fn self_grade(functions: Functions) -> ExitCode {
    if env::var_os(WORKER).is_some() {
        exam::worker::serve(functions);
    }
    let arguments = Arguments::from_args();
    let exam = Arc::new((Exercise::of(&functions).exam)(PUBLIC_SEED, &Solutions));
    let results = Arc::new(Results::default());
    let trials = trials(&exam, &results);
    let names: Vec<String> = trials.iter().map(|trial| trial.name().to_owned()).collect();
    let conclusion = libtest_mimic::run(&arguments, trials);
    if conclusion.num_filtered_out == names.len() as u64 {
        println!("Nothing here is called that. There is {}.", names.join(", "));
    } else if !arguments.list {
        results.print(&exam);
    }
    conclusion.exit_code()
}

fn trials(exam: &Arc<Exam>, results: &Arc<Results>) -> Vec<Trial> {
    let parts = (0..exam.parts.len()).map(|index| {
        let (exam, results) = (Arc::clone(exam), Arc::clone(results));
        Trial::test(exam.parts[index].rubric.test_name(), move || {
            let report = grade_part(&mut worker()?, &exam.parts[index], CHECK_LIMIT);
            let (points, of) = (report.points(), report.rubric.points());
            let verdict = format!("{points} of {of} points, {}: see below", report.state.name());
            lock(&results.parts).push((index, report));
            if points == of { Ok(()) } else { Err(verdict.into()) }
        })
    });
    let whole = {
        let (exam, results) = (Arc::clone(exam), Arc::clone(results));
        Trial::test("whole_motion", move || {
            let report = grade_whole_motion(&mut worker()?, &exam.whole_motion, CHECK_LIMIT);
            let is_right = report.trouble.is_none();
            *lock(&results.whole) = Some(report);
            if is_right { Ok(()) } else { Err("the three parts do not yet work together: see below".into()) }
        })
    };
    parts.chain([whole]).collect()
}

/// This program, once more.
fn worker() -> Result<impl Subject, Failed> {
    let program = env::current_exe().map_err(|error| Failure::NoAnswer { why: error.to_string() })?;
    let mut command = Command::new(program);
    command.env(WORKER, "1");
    Ok(WorkerProcess::new(command))
}

/// Checks run side by side and come in as they finish.
#[derive(Default)]
struct Results {
    parts: Mutex<Vec<(usize, PartReport)>>,
    whole: Mutex<Option<WholeReport>>,
}

impl Results {
    fn print(&self, exam: &Exam) {
        let mut parts = std::mem::take(&mut *lock(&self.parts));
        parts.sort_by_key(|(index, _)| *index);
        let parts: Vec<PartReport> = parts.into_iter().map(|(_, report)| report).collect();
        let whole = lock(&self.whole).take();
        // Colours only where they can be seen: anstream knows terminals and NO_COLOR.
        anstream::print!("{}", Scoreboard { rubric: exam.rubric, parts: &parts, whole: whole.as_ref() });
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
