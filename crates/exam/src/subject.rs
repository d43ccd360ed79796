//! Whom to ask, what to ask, and what may come back.

use std::fmt;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use skeleton::acclaim::{AcclaimFunctions, TimeWarpFunctions};
use skeleton::{FkFunctions, InterpolationFunctions, KeyframesFunctions, MakeClip};

use crate::{acclaim, fk, interpolation, keyframes, time_warp};

/// The functions of one exercise, as a student wrote them.
#[derive(Clone, Copy, Debug)]
pub enum Functions {
    /// Forward kinematics.
    Fk(FkFunctions),
    /// Interpolation.
    Interpolation(InterpolationFunctions),
    /// Keyframes.
    Keyframes {
        /// The student's functions.
        functions: KeyframesFunctions,
        /// What poses whole motions for them, where they are asked about any.
        make_clip: Option<MakeClip>,
    },
    /// Acclaim forward kinematics.
    Acclaim(AcclaimFunctions),
    /// Time warping.
    TimeWarp(TimeWarpFunctions),
}

impl Functions {
    /// The functions of the exercise on keyframes.
    pub const fn keyframes(functions: KeyframesFunctions) -> Functions {
        Functions::Keyframes { functions, make_clip: None }
    }

    /// The same functions, which can also be asked about whole motions ([`keyframes::Question::Motion`]).
    pub const fn with_clips(self, make_clip: MakeClip) -> Functions {
        match self {
            Functions::Keyframes { functions, .. } => {
                Functions::Keyframes { functions, make_clip: Some(make_clip) }
            }
            Functions::Fk(_)
            | Functions::Interpolation(_)
            | Functions::Acclaim(_)
            | Functions::TimeWarp(_) => self,
        }
    }
}

/// A question of any exercise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Forward kinematics.
    Fk(fk::Question),
    /// Interpolation.
    Interpolation(interpolation::Question),
    /// Keyframes.
    Keyframes(keyframes::Question),
    /// Acclaim forward kinematics.
    Acclaim(acclaim::Question),
    /// Time warping.
    TimeWarp(time_warp::Question),
}

/// The answer to a [`Question`] of the same exercise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// Forward kinematics.
    Fk(fk::Answer),
    /// Interpolation.
    Interpolation(interpolation::Answer),
    /// Keyframes.
    Keyframes(keyframes::Answer),
    /// Acclaim forward kinematics.
    Acclaim(acclaim::Answer),
    /// Time warping.
    TimeWarp(time_warp::Answer),
    /// These functions are of another exercise.
    NotMine,
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &Functions) -> Answer {
        match (self, functions) {
            (Question::Fk(question), Functions::Fk(functions)) => Answer::Fk(question.ask(functions)),
            (Question::Interpolation(question), Functions::Interpolation(functions)) => {
                Answer::Interpolation(question.ask(functions))
            }
            (Question::Keyframes(question), Functions::Keyframes { functions, make_clip }) => {
                Answer::Keyframes(question.ask(functions, *make_clip))
            }
            (Question::Acclaim(question), Functions::Acclaim(functions)) => {
                Answer::Acclaim(question.ask(functions))
            }
            (Question::TimeWarp(question), Functions::TimeWarp(functions)) => {
                Answer::TimeWarp(question.ask(functions))
            }
            (
                Question::Fk(_)
                | Question::Interpolation(_)
                | Question::Keyframes(_)
                | Question::Acclaim(_)
                | Question::TimeWarp(_),
                _,
            ) => Answer::NotMine,
        }
    }

    pub(crate) fn answer_limit(&self) -> usize {
        match self {
            Question::Fk(question) => question.answer_limit(),
            Question::Interpolation(question) => question.answer_limit(),
            Question::Keyframes(question) => question.answer_limit(),
            Question::Acclaim(question) => question.answer_limit(),
            Question::TimeWarp(question) => question.answer_limit(),
        }
    }
}

/// A question and an answer of one exercise are those of any exercise, and back where the answer is of this one.
macro_rules! of_exercise {
    ($($exercise:ident: $module:ident),*) => {$(
        impl From<$module::Question> for Question {
            fn from(question: $module::Question) -> Question {
                Question::$exercise(question)
            }
        }

        impl TryFrom<Answer> for $module::Answer {
            /// The answer, which is another exercise's.
            type Error = Answer;

            fn try_from(answer: Answer) -> Result<$module::Answer, Answer> {
                match answer {
                    Answer::$exercise(answer) => Ok(answer),
                    other => Err(other),
                }
            }
        }
    )*};
}

of_exercise!(
    Fk: fk,
    Interpolation: interpolation,
    Keyframes: keyframes,
    Acclaim: acclaim,
    TimeWarp: time_warp
);

/// Something that answers questions.
pub trait Subject {
    /// Asks one question. `limit` is how long the answer may take, where that can be enforced.
    ///
    /// # Errors
    ///
    /// When no answer came, with the reason. The next question may be asked all the same.
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure>;

    /// Asks several questions one after the other, until one is not answered. `limit` is for all of them together.
    ///
    /// Gives the answers in order, and why there is no further one.
    fn ask_all(&mut self, questions: &[&Question], limit: Duration) -> (Vec<Answer>, Option<Failure>) {
        let start = Instant::now();
        let mut answers = Vec::new();
        for question in questions {
            match self.ask(question, limit.saturating_sub(start.elapsed())) {
                Ok(answer) => answers.push(answer),
                Err(failure) => return (answers, Some(failure)),
            }
        }
        (answers, None)
    }

    /// Lets the functions forget what they may have kept, where that can be done: the next question meets them as if
    /// it were the first.
    fn restart(&mut self) {}
}

/// Why a question has no answer. `Display` says it in words for the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The functions panicked.
    Panicked {
        /// The panic's own message.
        message: String,
        /// `file:line:column`, as the compiler knows it.
        location: Option<String>,
    },
    /// The functions did not come back in time.
    TimedOut {
        /// The time they had.
        limit: Duration,
    },
    /// The process that ran the functions ended.
    Crashed {
        /// How it ended, in the system's words.
        how: String,
    },
    /// What came back is no answer: something else was written among the replies.
    Unreadable {
        /// What is wrong with it.
        why: String,
    },
    /// The question could not be put. Not the fault of the functions.
    NoAnswer {
        /// What went wrong.
        why: String,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Panicked { message, location: Some(location) } => {
                write!(f, "your code panicked at {location}: {message}")
            }
            Failure::Panicked { message, location: None } => write!(f, "your code panicked: {message}"),
            Failure::TimedOut { limit } => write!(
                f,
                "your code did not finish within {}: look for a loop that never ends",
                seconds(*limit)
            ),
            Failure::Crashed { how } => write!(
                f,
                "your code ended the program ({how}): look for a function that calls itself without end, or \
                 for `std::process::exit`"
            ),
            Failure::Unreadable { why } => {
                write!(f, "the answer of your code could not be read: {why}")
            }
            Failure::NoAnswer { why } => write!(f, "no answer came back: {why}"),
        }
    }
}

fn seconds(limit: Duration) -> String {
    match limit.as_secs_f32() {
        1.0 => "1 second".to_owned(),
        other => format!("{other} seconds"),
    }
}

impl std::error::Error for Failure {}
