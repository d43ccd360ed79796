//! Asking functions in this very process.

use std::cell::{Cell, RefCell};
use std::mem;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;
use std::time::Duration;

use crate::{Answer, Failure, Functions, Question, Subject};

/// Calls the functions directly. A panic is caught; an endless loop is not.
#[derive(Clone, Copy, Debug)]
pub struct InProcess(pub Functions);

impl Subject for InProcess {
    fn ask(&mut self, question: &Question, _limit: Duration) -> Result<Answer, Failure> {
        ask_caught(question, &self.0)
    }
}

/// Asks, and turns a panic into a failure with its message and place instead of printing it.
pub(crate) fn ask_caught(question: &Question, functions: &Functions) -> Result<Answer, Failure> {
    keep_panics_of_guarded_threads();
    GUARDED.set(true);
    let result = panic::catch_unwind(AssertUnwindSafe(|| question.ask(functions)));
    GUARDED.set(false);
    result.map_err(|payload| {
        // The payload can be anything, and dropping it can panic again.
        mem::forget(payload);
        // Functions that set a hook of their own leave nothing here.
        let (message, location) = LAST_PANIC.take().unwrap_or_else(|| ("(no message)".to_owned(), None));
        Failure::Panicked { message, location }
    })
}

thread_local! {
    static GUARDED: Cell<bool> = const { Cell::new(false) };
    static LAST_PANIC: RefCell<Option<(String, Option<String>)>> = const { RefCell::new(None) };
}

/// The hook is the process's own: other threads keep the one that was there before.
fn keep_panics_of_guarded_threads() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !GUARDED.get() {
                return before(info);
            }
            let payload = info.payload();
            let text = payload.downcast_ref::<&str>().copied();
            let message = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
            let location = info.location().map(ToString::to_string);
            LAST_PANIC.set(Some((message.unwrap_or("(no message)").to_owned(), location)));
        }));
    });
}
