//! The command line.

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use harness::doctor::DoctorArgs;
use harness::grade::GradeArgs;
use harness::gradescope::GradescopeArgs;
use harness::merge::MergeArgs;
use harness::submit::SubmitArgs;
use harness::{Ended, Error, doctor, finish, grade, gradescope, merge, submit};

/// Marks submissions, and hands them in
#[derive(Parser)]
#[command(name = "harness", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Grade(GradeArgs),
    Doctor(DoctorArgs),
    Submit(SubmitArgs),
    Merge(MergeArgs),
    Gradescope(GradescopeArgs),
}

fn main() -> ExitCode {
    // This program is started once more for everything that is confined.
    sandbox::enter_if_asked();
    match run(Arguments::parse().command) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Result<ExitCode, Error> {
    match command {
        Command::Grade(arguments) => {
            let stop = grade::stop_on_ctrl_c()?;
            grade::run(&arguments, &stop).map(|ended| tell(&ended, &arguments))
        }
        Command::Doctor(arguments) => doctor::run(&arguments),
        Command::Submit(arguments) => submit::run(&arguments),
        Command::Merge(arguments) => merge::run(&arguments),
        Command::Gradescope(arguments) => gradescope::run(&arguments),
    }
}

/// Says how it ended. The exit code is 0 when everything is marked, 3 when something could not be, and 130 after
/// Ctrl-C.
fn tell(ended: &Ended, arguments: &GradeArgs) -> ExitCode {
    match ended {
        Ended::Done(summary) => {
            print!("{}", finish::in_words(summary, &arguments.out));
            if summary.with_points < summary.submissions { ExitCode::from(3) } else { ExitCode::SUCCESS }
        }
        Ended::Stopped { done, of } => {
            println!("Stopped: {done} of {of} submissions are marked.");
            println!("Go on with the same command and `--resume`.");
            ExitCode::from(130)
        }
    }
}
