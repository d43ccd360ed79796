//! A warped motion that part 3 makes at once: how often it is asked, for how long, and where it fails.

use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

use super::warp::{student, whole};
use super::*;

const RIGHT: TimeWarpFunctions = solutions::TIME_WARP;

/// The warped motion, frame by frame by these parts 1 and 2.
fn warped(
    old_position: fn(usize, usize, usize) -> Between,
    blend: fn(&Posture, &Posture, f32) -> Posture,
    old: &[Posture],
    new: usize,
) -> Vec<Posture> {
    let frame = |index| {
        let Between { before, after, t } = old_position(index, old.len(), new);
        blend(&old[before], &old[after], t)
    };
    (0..new).map(frame).collect()
}

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

/// What is told of functions that panic while `new` frames are made.
fn told(functions: TimeWarpFunctions, new: usize) -> Arc<Trouble> {
    let mut student = student(functions, whole(new));
    let told = |student: &Student| trouble(student, 1, 7).filter(|trouble| trouble.details.len() > 1);
    update_until(&mut student, &[0, 7], |student| told(student).is_some());
    told(&student).unwrap()
}

#[test]
fn a_panic_in_part_1_is_told_as_its_own_at_whatever_frame_it_is() {
    fn old_position(new_frame: usize, old_count: usize, new_count: usize) -> Between {
        assert!(new_frame != 501, "not 501");
        (RIGHT.old_position)(new_frame, old_count, new_count)
    }
    let warp = |old: &[Posture], new| warped(old_position, RIGHT.blend, old, new);
    for new in [960, 2400] {
        let trouble = told(TimeWarpFunctions { old_position, warp, ..RIGHT }, new);
        assert!(trouble.headline.contains("not 501"), "{trouble:?}");
        let details = [format!("while all {new} frames were made"), "in part1, old_position".into()];
        assert_eq!(trouble.details, details);
    }
}

#[test]
fn a_panic_in_part_2_is_told_as_its_own_at_whatever_frame_it_is() {
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        let bad = samples::walk().bones().unwrap().motion().posture(250);
        assert!(*from != bad, "not 250");
        (RIGHT.blend)(from, to, t)
    }
    let warp = |old: &[Posture], new| warped(RIGHT.old_position, blend, old, new);
    let trouble = told(TimeWarpFunctions { blend, warp, ..RIGHT }, 960);
    assert!(trouble.headline.contains("not 250"), "{trouble:?}");
    assert_eq!(trouble.details, ["while all 960 frames were made", "in part2, blend"]);
}

#[test]
fn part_2_is_asked_about_the_places_that_part_1_names() {
    /// A frame that is always whole steps away.
    fn old_position(new_frame: usize, old_count: usize, _: usize) -> Between {
        let before = new_frame.min(old_count - 1);
        Between { before, after: before, t: 7.0 }
    }
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        assert!(t <= 1.0, "not so far");
        (RIGHT.blend)(from, to, t)
    }
    let warp = |old: &[Posture], new| warped(old_position, blend, old, new);
    let trouble = told(TimeWarpFunctions { old_position, blend, warp }, 960);
    assert_eq!(trouble.details, ["while all 960 frames were made", "in part2, blend"]);
}
