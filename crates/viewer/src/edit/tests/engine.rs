//! The engine's thread, held still by a hand that waits for leave.

use std::sync::mpsc::{self, Receiver, Sender};

use super::*;

/// The reference's hand, which says what it is asked and waits until it may answer.
struct Gated {
    asked: Sender<(usize, usize)>,
    leave: Receiver<()>,
    hand: ReferenceHand,
}

/// The other end of its channels.
struct Gate {
    asked: Receiver<(usize, usize)>,
    leave: Sender<()>,
}

/// What is said when work was broken off.
const BROKEN_OFF: (usize, usize) = (usize::MAX, 0);

fn gated() -> (Box<dyn Hand>, Gate) {
    let (asked, hears) = mpsc::channel();
    let (leave, waits) = mpsc::channel();
    let hand = Gated { asked, leave: waits, hand: ReferenceHand::default() };
    (Box::new(hand), Gate { asked: hears, leave })
}

impl Hand for Gated {
    fn reduce(
        &mut self,
        stage: &Stage,
        representation: Representation,
        counts: &[usize],
        progress: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        self.hand.reduce(stage, representation, counts, progress)
    }

    fn between(
        &mut self,
        stage: &Stage,
        representation: Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        // Nobody holds the gate any more when a test is over.
        let _ = self.asked.send((start, end));
        let _ = self.leave.recv();
        self.hand.between(stage, representation, start, end, progress)
    }

    fn curves(&mut self, stage: &Stage, progress: Progress) -> Option<Curves> {
        let _ = self.asked.send((0, 0));
        let _ = self.leave.recv();
        let curves = self.hand.curves(stage, progress);
        if curves.is_none() {
            let _ = self.asked.send(BROKEN_OFF);
        }
        curves
    }
}

fn ends(start: usize, end: usize) -> Option<Wish> {
    Some(wish(Keys::Ends(start, end)))
}

fn shown(engine: &Engine) -> Option<Keys> {
    engine.state().edited.map(|edited| edited.wish.keys)
}

#[test]
fn only_the_newest_wish_is_worked_for_and_nothing_waits() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    assert!(engine.state().progress.is_none() && !engine.state().stale);
    engine.want(ends(0, 10));
    assert_eq!(gate.asked.recv(), Ok((0, 10)));
    // The hand stands still from here on.
    for end in 11..20 {
        engine.want(ends(0, end));
        assert!(!engine.update());
        assert!(engine.state().stale && engine.state().progress.is_some());
    }
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok((0, 19)), "those between are passed over");
    gate.leave.send(()).unwrap();
    engine.settle();
    assert_eq!(shown(&engine), Some(Keys::Ends(0, 19)));
    assert!(!engine.state().stale && engine.state().progress.is_none());
    engine.want(ends(0, 19));
    assert!(!engine.state().stale, "it is there already");
    assert!(gate.asked.try_recv().is_err());
}

#[test]
fn work_for_an_older_wish_is_broken_off() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    engine.want(Some(Wish { curves: true, ..wish(Keys::Ends(0, 10)) }));
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok((0, 10)));
    assert_eq!(gate.asked.recv(), Ok((0, 0)));
    engine.want(ends(0, 12));
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok(BROKEN_OFF));
    assert_eq!(gate.asked.recv(), Ok((0, 12)));
    gate.leave.send(()).unwrap();
    engine.settle();
    assert!(engine.state().failure.is_none() && shown(&engine) == Some(Keys::Ends(0, 12)));
}

#[test]
fn work_within_a_stretch_is_broken_off_too() {
    let stage = stage(30);
    let mut told = Vec::new();
    let mut stop = |done, of| {
        told.push((done, of));
        if done < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let wish = wish(Keys::Ends(5, 25));
    let result = perform(&mut ReferenceHand::default(), &stage, &wish, &mut stop);
    assert_eq!((result.unwrap_err(), told), (NotEdited::BrokenOff, vec![(1, 20), (2, 20), (3, 20)]));
}

#[test]
fn an_old_result_stays_until_the_new_one_is_there() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    engine.want(ends(0, 10));
    gate.leave.send(()).unwrap();
    engine.settle();
    engine.want(ends(3, 10));
    engine.update();
    assert_eq!((shown(&engine), engine.state().stale), (Some(Keys::Ends(0, 10)), true));
    gate.leave.send(()).unwrap();
    engine.settle();
    assert_eq!((shown(&engine), engine.state().stale), (Some(Keys::Ends(3, 10)), false));
    engine.want(None);
    assert_eq!((shown(&engine), engine.state().stale), (None, false));
}

#[test]
fn wishes_wait_for_a_hand_and_another_hand_does_the_work_anew() {
    let mut engine = Engine::start(stage(30), None);
    engine.want(ends(0, 10));
    assert!(!engine.update() && engine.state().stale);
    let (first, first_gate) = gated();
    engine.set_hand(first);
    assert_eq!(first_gate.asked.recv(), Ok((0, 10)));
    first_gate.leave.send(()).unwrap();
    engine.settle();
    let (second, second_gate) = gated();
    engine.set_hand(second);
    assert_eq!(second_gate.asked.recv(), Ok((0, 10)));
    engine.update();
    assert_eq!((shown(&engine), engine.state().stale), (Some(Keys::Ends(0, 10)), true));
    assert!(engine.state().by_former_hand);
    // The same hand for another wish.
    second_gate.leave.send(()).unwrap();
    engine.settle();
    assert!(!engine.state().stale && !engine.state().by_former_hand);
    engine.want(ends(0, 12));
    assert!(engine.state().stale && !engine.state().by_former_hand);
}

#[test]
fn a_result_that_was_on_its_way_when_the_motion_changed_is_not_shown() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    engine.want(Some(Wish { curves: true, ..wish(Keys::Ends(0, 10)) }));
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok((0, 10)));
    // The curves are asked for: the figure has been sent.
    assert_eq!(gate.asked.recv(), Ok((0, 0)));
    engine.replace_stage(stage(12));
    assert!(!engine.update() && shown(&engine).is_none());
}

#[test]
fn another_stage_takes_the_old_result_away() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    engine.want(ends(0, 29));
    gate.asked.recv().unwrap();
    engine.replace_stage(stage(12));
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok((0, 11)), "as far as the new motion goes");
    engine.update();
    assert!(shown(&engine).is_none(), "nothing of the old motion");
    gate.leave.send(()).unwrap();
    engine.settle();
    assert_eq!(engine.state().edited.unwrap().keyframes, [0, 11]);
    engine.replace_stage(stage(8));
    assert!(shown(&engine).is_none() && engine.state().stale);
}

#[test]
fn the_figure_comes_before_the_curves_and_is_not_made_twice() {
    let (hand, gate) = gated();
    let mut engine = Engine::start(stage(30), Some(hand));
    let keys = Keys::Ends(0, 10);
    engine.want(Some(Wish { curves: true, ..wish(keys) }));
    gate.leave.send(()).unwrap();
    assert_eq!(gate.asked.recv(), Ok((0, 10)));
    assert_eq!(gate.asked.recv(), Ok((0, 0)));
    // The curves are waited for: the figure has been sent.
    assert!(engine.update());
    let state = engine.state();
    assert!(!state.stale && state.progress.is_some() && state.edited.unwrap().curves.is_none());
    gate.leave.send(()).unwrap();
    engine.settle();
    assert!(engine.state().edited.unwrap().curves.is_some());
    for curves in [false, true] {
        engine.want(Some(Wish { curves, ..wish(keys) }));
        engine.settle();
        assert_eq!(engine.state().edited.unwrap().wish.curves, curves);
    }
    assert!(gate.asked.try_recv().is_err(), "all of it was there");
}

#[test]
fn what_goes_wrong_is_told_until_something_else_is_wanted() {
    let mut engine = Engine::start(stage(5), Some(Box::new(Says(Vec::new(), Vec::new()))));
    engine.want(ends(0, 4));
    engine.settle();
    let failure = engine.state().failure.unwrap().to_string();
    assert!(failure.contains("not today") && engine.state().progress.is_none(), "{failure}");
    engine.want(ends(0, 1));
    engine.settle();
    assert!(engine.state().failure.is_none() && !engine.state().stale);
}

/// Does not come back.
struct Panics;

impl Hand for Panics {
    fn reduce(
        &mut self,
        _: &Stage,
        _: Representation,
        _: &[usize],
        _: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        panic!("this one is meant to")
    }

    fn between(
        &mut self,
        _: &Stage,
        _: Representation,
        _: usize,
        _: usize,
        _: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        panic!("this one is meant to")
    }
}

#[test]
fn a_thread_that_has_ended_is_noticed() {
    let mut engine = Engine::start(stage(5), Some(Box::new(Panics)));
    engine.want(ends(0, 4));
    engine.settle();
    assert_eq!(engine.state().failure.map(|failure| (**failure).clone()), Some(NotEdited::Ended));
    engine.want(ends(0, 3));
    assert!(engine.update() && engine.state().failure.is_some());
    assert!(!engine.update(), "it is known by now");
}
