//! A warped motion that part 3 makes at once: how often it is asked, and for how long.

use skeleton::acclaim::{Posture, TimeWarpFunctions};

use super::warp::{student, whole};
use super::*;

const RIGHT: TimeWarpFunctions = solutions::TIME_WARP;

#[test]
fn after_a_save_the_whole_motion_is_asked_for_once() {
    static CALLS: AtomicUsize = AtomicUsize::new(0);
    fn warp(old: &[Posture], new: usize) -> Vec<Posture> {
        // The checks are about shorter motions.
        CALLS.fetch_add(usize::from(old.len() == 480), Ordering::SeqCst);
        (RIGHT.warp)(old, new)
    }
    let mut student = student(TimeWarpFunctions { warp, ..RIGHT }, whole(960));
    for saves in 1..=3 {
        update_until(&mut student, &[0, 7], |student| {
            let standing = student.standing(1, 7);
            standing.current && standing.board.is_some() && student.desk.plan().next(false).is_none()
        });
        assert!([0, 6, 8, 959].into_iter().all(|frame| student.standing(1, frame).current));
        assert_eq!(CALLS.load(Ordering::SeqCst), saves);
        student.rebuild();
    }
}

/// The solution, but that the whole motion takes nearly as long as there is patience, and that part 2 by itself panics.
struct Slow {
    /// The next answer is lost.
    loses: bool,
}

impl Subject for Slow {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        use exam::time_warp::Question::{Blend, Motion};
        match question {
            Question::TimeWarp(Motion { .. }) if std::mem::take(&mut self.loses) || limit < PATIENCE => {
                Err(Failure::TimedOut { limit })
            }
            Question::TimeWarp(Blend { .. }) => {
                Err(Failure::Panicked { message: "no".into(), location: None })
            }
            _ => InProcess(Functions::TimeWarp(RIGHT)).ask(question, limit),
        }
    }
}

#[test]
fn a_part_3_that_is_slow_is_waited_for_also_when_it_is_asked_again() {
    for (loses, new) in [(false, 960), (true, 960), (false, 1), (true, 1)] {
        let open = move |_: &Version| Ok(Slow { loses });
        let mut student = Student::start(Mover::TimeWarp, warp::pair(whole(new)), open, quiet);
        update_until(&mut student, &[0, 0], is_current(1, 0));
        assert!(student.standing(1, new - 1).current);
    }
}
