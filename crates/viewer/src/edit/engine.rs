//! The thread on which a motion is edited.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

use super::edited::Edited;
use super::hand::Hand;
use super::perform::{NotEdited, add_curves, interpolate};
use super::wish::Wish;
use crate::motion::stage::Stage;

/// Edits one motion as it is wished, on a thread of its own. Only the newest wish counts: work for an older one is broken
/// off. Nothing here waits.
pub struct Engine {
    shared: Arc<Shared>,
    outcomes: Receiver<Outcome>,
    /// Every wish, hand and stage has a number of its own; results come with it.
    ticket: u64,
    /// The first tickets of the present stage and of the present hand.
    stage_since: u64,
    hand_since: u64,
    /// The ticket that the newest result came with.
    made: u64,
    wish: Option<Wish>,
    edited: Option<Arc<Edited>>,
    failure: Option<Arc<NotEdited>>,
    /// Whether what there is, is what is wanted, and whether nothing more will come.
    current: bool,
    finished: bool,
}

/// How things stand.
#[derive(Clone, Copy, Debug)]
pub struct EngineState<'a> {
    /// The newest result.
    pub edited: Option<&'a Arc<Edited>>,
    /// Whether that was made for an older wish, or by an older hand.
    pub stale: bool,
    /// Whether it was made by an older hand.
    pub by_former_hand: bool,
    /// How much of the work is done and how much there is, while it is done.
    pub progress: Option<(usize, usize)>,
    /// Why there is no result for the present wish.
    pub failure: Option<&'a Arc<NotEdited>>,
}

#[derive(Default)]
struct Shared {
    mail: Mutex<Mail>,
    news: Condvar,
    /// The newest ticket.
    ticket: AtomicU64,
    progress: Mutex<(usize, usize)>,
}

/// What is to be done. New things take the place of old ones.
#[derive(Default)]
struct Mail {
    ticket: u64,
    stage: Option<Arc<Stage>>,
    hand: Option<Box<dyn Hand>>,
    wish: Option<Wish>,
    closed: bool,
}

struct Outcome {
    ticket: u64,
    result: Result<Arc<Edited>, NotEdited>,
    /// Whether nothing more comes.
    finished: bool,
}

impl Engine {
    /// Begins with the motion on `stage`. Without a hand nobody answers yet: wishes wait for one.
    pub fn start(stage: Arc<Stage>, hand: Option<Box<dyn Hand>>) -> Engine {
        let shared = Arc::new(Shared::default());
        let (sender, outcomes) = mpsc::channel();
        let worker = Worker { shared: shared.clone(), sender, hand: None, stage: None, last: None };
        // Without a thread the sender goes at once, which is noticed.
        let _ = thread::Builder::new().name("edit".into()).spawn(move || worker.run());
        let engine = Engine {
            shared,
            outcomes,
            ticket: 0,
            stage_since: 0,
            hand_since: 0,
            made: 0,
            wish: None,
            edited: None,
            failure: None,
            current: false,
            finished: true,
        };
        let mut mail = lock(&engine.shared.mail);
        (mail.stage, mail.hand) = (Some(stage), hand);
        drop(mail);
        engine
    }

    /// Lets another hand do the work. The present wish is performed anew; until that is done the old result stays, stale.
    pub fn set_hand(&mut self, hand: Box<dyn Hand>) {
        self.hand_since = self.ticket + 1;
        self.post(|mail| mail.hand = Some(hand));
    }

    /// The motion has changed. What was made of the old one is gone.
    pub fn replace_stage(&mut self, stage: Arc<Stage>) {
        self.edited = None;
        self.stage_since = self.ticket + 1;
        self.post(|mail| mail.stage = Some(stage));
    }

    /// Wishes for something, or for nothing any more. Nothing happens when it is the same as before.
    pub fn want(&mut self, wish: Option<Wish>) {
        if self.wish == wish {
            return;
        }
        if wish.is_none() {
            self.edited = None;
        }
        self.wish.clone_from(&wish);
        self.post(|mail| mail.wish = wish);
    }

    fn post(&mut self, change: impl FnOnce(&mut Mail)) {
        self.ticket += 1;
        (self.current, self.finished, self.failure) = (false, false, None);
        *lock(&self.shared.progress) = (0, 0);
        self.shared.ticket.store(self.ticket, Ordering::Relaxed);
        let mut mail = lock(&self.shared.mail);
        mail.ticket = self.ticket;
        change(&mut mail);
        drop(mail);
        self.shared.news.notify_all();
    }

    /// Takes what has come, and gives whether anything has. Never waits.
    pub fn update(&mut self) -> bool {
        let mut news = false;
        loop {
            match self.outcomes.try_recv() {
                Ok(outcome) => news |= self.take(outcome),
                Err(TryRecvError::Empty) => return news,
                Err(TryRecvError::Disconnected) => {
                    let known = self.failure.as_deref() == Some(&NotEdited::Ended);
                    (self.failure, self.finished) = (Some(Arc::new(NotEdited::Ended)), true);
                    return news || !known;
                }
            }
        }
    }

    fn take(&mut self, outcome: Outcome) -> bool {
        let newest = outcome.ticket == self.ticket;
        match outcome.result {
            // What was made for an older wish is nearer to the newest one than what was made before.
            Ok(edited) if self.wish.is_some() && outcome.ticket >= self.stage_since => {
                self.edited = Some(edited);
                (self.made, self.current) = (outcome.ticket, newest);
            }
            Err(failure) if newest => self.failure = Some(Arc::new(failure)),
            Ok(_) | Err(_) => return false,
        }
        self.finished = newest && outcome.finished;
        true
    }

    /// Waits until nothing more comes for the present wish, for tests.
    #[cfg(test)]
    pub(super) fn settle(&mut self) {
        while !self.finished {
            match self.outcomes.recv() {
                Ok(outcome) => drop(self.take(outcome)),
                Err(_) => drop(self.update()),
            }
        }
    }

    /// How things stand.
    pub fn state(&self) -> EngineState<'_> {
        let wanted = self.wish.is_some();
        EngineState {
            edited: self.edited.as_ref(),
            stale: wanted && !self.current,
            by_former_hand: self.edited.is_some() && self.made < self.hand_since,
            progress: (wanted && !self.finished).then(|| *lock(&self.shared.progress)),
            failure: self.failure.as_ref().filter(|_| wanted),
        }
    }
}

impl Drop for Engine {
    /// The thread ends by itself. Nobody waits for it: a student's functions may take their time.
    fn drop(&mut self) {
        self.post(|mail| mail.closed = true);
    }
}

/// What the thread does.
struct Worker {
    shared: Arc<Shared>,
    sender: Sender<Outcome>,
    hand: Option<Box<dyn Hand>>,
    stage: Option<Arc<Stage>>,
    /// What was made last, by this hand of this stage.
    last: Option<Arc<Edited>>,
}

impl Worker {
    fn run(mut self) {
        let mut done = 0;
        while let Some((ticket, wish)) = self.next(done) {
            done = ticket;
            let result = self.perform(ticket, &wish);
            if self.sender.send(Outcome { ticket, result, finished: true }).is_err() {
                return;
            }
        }
    }

    /// Waits for something to do that is newer than the ticket `done`; `None` when there will be nothing.
    fn next(&mut self, done: u64) -> Option<(u64, Wish)> {
        let shared = self.shared.clone();
        let mut mail = lock(&shared.mail);
        loop {
            if mail.closed {
                return None;
            }
            if mail.hand.is_some() {
                (self.hand, self.last) = (mail.hand.take(), None);
            }
            if let Some(stage) = mail.stage.take() {
                (self.stage, self.last) = (Some(stage), None);
            }
            match mail.wish.as_ref().filter(|_| self.hand.is_some() && mail.ticket != done) {
                Some(wish) => return Some((mail.ticket, wish.clone())),
                None => mail = shared.news.wait(mail).unwrap_or_else(PoisonError::into_inner),
            }
        }
    }

    fn perform(&mut self, ticket: u64, wish: &Wish) -> Result<Arc<Edited>, NotEdited> {
        let (Some(hand), Some(stage)) = (&mut self.hand, &self.stage) else { return Err(NotEdited::Ended) };
        let shared = &self.shared;
        let mut progress = |done: usize, of: usize| {
            if shared.ticket.load(Ordering::Relaxed) != ticket {
                return ControlFlow::Break(());
            }
            *lock(&shared.progress) = (done, of);
            ControlFlow::Continue(())
        };
        let is_same = |last: &&Arc<Edited>| {
            last.wish.representation == wish.representation && last.wish.keys == wish.keys
        };
        // Where only the curves are new, they are added to what there is.
        let mut edited = match self.last.as_ref().filter(is_same) {
            Some(last) => Edited { wish: wish.clone(), ..Edited::clone(last) },
            None => interpolate(hand.as_mut(), stage, wish, &mut progress)?,
        };
        if wish.curves && edited.curves.is_none() {
            let figure = Arc::new(edited.clone());
            self.last = Some(figure.clone());
            // When nobody listens any more, the next answer tells.
            let _ = self.sender.send(Outcome { ticket, result: Ok(figure), finished: false });
            add_curves(hand.as_mut(), stage, &mut edited, &mut progress)?;
        }
        let edited = Arc::new(edited);
        self.last = Some(edited.clone());
        Ok(edited)
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
