//! The process that runs a student's functions.

use std::io::{self, Read, Write};
use std::process;
use std::sync::mpsc;
use std::thread;

use crate::in_process::ask_caught;
use crate::wire::{self, Marker, Reply};
use crate::{Failure, Functions, Question};

/// Answers questions from standard input on standard output until the input ends, and then ends the process.
///
/// It ends too when the asker goes away while the functions run without end: no worker stays behind.
pub fn serve(functions: Functions) -> ! {
    let (marker, questions) = match listen() {
        Ok(both) => both,
        Err(error) => give_up(&error),
    };
    for question in questions {
        let reply = match ask_caught(&question, &functions) {
            Ok(answer) => Reply::Answered(answer),
            Err(Failure::Panicked { message, location }) => Reply::Panicked { message, location },
            Err(other) => Reply::Panicked { message: other.to_string(), location: None },
        };
        // The student's own output goes through the same buffer, so that it cannot fall into the middle of a reply.
        if let Err(error) = wire::write_reply(&mut io::stdout().lock(), &marker, &reply) {
            give_up(&error);
        }
    }
    process::exit(0)
}

/// Reads the marker, and then questions on a thread of their own: the asker never waits for the functions to come
/// back before it can write, and its end is noticed at once.
fn listen() -> io::Result<(Marker, mpsc::Receiver<Question>)> {
    let mut marker = Marker::default();
    io::stdin().lock().read_exact(&mut marker)?;
    let (sender, receiver) = mpsc::channel();
    thread::Builder::new().name("questions".into()).spawn(move || {
        let mut input = io::stdin().lock();
        loop {
            match wire::read_message(&mut input)
                .and_then(|bytes| bytes.map(|b| wire::from_bytes(&b)).transpose())
            {
                Ok(Some(question)) => {
                    if sender.send(question).is_err() {
                        return;
                    }
                }
                Ok(None) => process::exit(0),
                Err(error) => give_up(&error),
            }
        }
    })?;
    Ok((marker, receiver))
}

fn give_up(error: &io::Error) -> ! {
    // There is nobody left to tell when this fails too.
    let _ = writeln!(
        io::stderr(),
        "This program only answers questions: run `cargo view` or `cargo test` instead. ({error})"
    );
    process::exit(2)
}
