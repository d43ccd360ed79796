//! Which frame is shown when.

use proptest::prelude::*;
use skeleton::{Motion, Skeleton};

use super::*;

#[test]
fn steps_go_around_and_pause() {
    let mut player = Player::new(3, 0.1);
    player.toggle();
    player.step(1);
    assert!(!player.is_playing());
    player.step(1);
    assert_eq!(player.frame(), 2);
    player.step(1);
    assert_eq!(player.frame(), 0);
    player.step(-1);
    assert_eq!(player.frame(), 2);
    player.step(isize::MIN);
    player.step(isize::MAX);
    player.go_to(99);
    assert_eq!(player.frame(), 2);
}

#[test]
fn a_single_frame_does_not_play() {
    let mut player = Player::new(0, 0.1);
    player.toggle();
    player.advance(1.0);
    assert_eq!((player.frame(), player.is_playing()), (0, false));
    player.step(1);
    player.begin_range();
    player.end_range();
    assert_eq!((player.frame(), player.range()), (0, (0, 0)));
}

#[test]
fn a_range_is_played_and_goes_away_by_the_key_that_made_it() {
    let mut player = Player::new(10, 1.0);
    player.go_to(3);
    player.begin_range();
    player.go_to(6);
    player.end_range();
    assert_eq!((player.range(), player.has_range()), ((3, 6), true));
    player.toggle();
    player.advance(1.0);
    assert_eq!(player.frame(), 3, "the first one follows the last");
    player.go_to(0);
    player.toggle();
    assert_eq!(player.frame(), 3, "from outside of the range to its beginning");
    player.begin_range();
    player.go_to(6);
    player.end_range();
    assert!(!player.has_range());
    player.go_to(8);
    player.begin_range();
    player.go_to(2);
    player.end_range();
    assert_eq!(player.range(), (0, 2), "an end before the beginning begins anew");
}

#[test]
fn without_a_loop_it_stops_at_the_end_and_begins_anew() {
    let mut player = Player::new(5, 1.0);
    player.toggle_loop();
    player.toggle();
    player.advance(100.0);
    assert_eq!((player.frame(), player.is_playing()), (4, false));
    player.toggle();
    assert_eq!((player.frame(), player.is_playing()), (0, true));
    player.reverse();
    player.advance(1.0);
    assert_eq!((player.frame(), player.is_playing()), (0, false));
}

#[test]
fn traces_begin_at_a_wrap_and_at_a_reversal() {
    let traced = |player: &Player| player.traced(4).collect::<Vec<_>>();
    let mut player = Player::new(10, 1.0);
    player.go_to(7);
    assert_eq!(traced(&player), [4, 5, 6, 7]);
    player.toggle();
    player.advance(4.0);
    assert_eq!(traced(&player), [0, 1]);
    player.reverse();
    assert_eq!(traced(&player), [1]);
    player.advance(1.0);
    assert_eq!(traced(&player), [1, 0]);
    player.advance(2.0);
    assert_eq!(traced(&player), [9, 8]);
    player.go_to(6);
    assert_eq!(traced(&player), [9, 8, 7, 6], "from where it would have come");
}

#[test]
fn a_shorter_motion_waits_at_its_end_until_the_longer_one_begins_again() {
    let mut player = Player::new(3, 1.0).waiting(3, 5);
    player.toggle();
    let seen = [0.0, 1.0, 1.0, 1.0, 1.0, 1.0].map(|seconds| {
        player.advance(seconds);
        (player.frame(), player.time(), player.is_waiting())
    });
    let waiting = [(2, 3, true), (2, 4, true)];
    assert_eq!(seen[..3], [(0, 0, false), (1, 1, false), (2, 2, false)]);
    assert_eq!(seen[3..5], waiting);
    assert_eq!(seen[5], (0, 0, false));
    player.go_to(4);
    assert_eq!(player.traced(9).collect::<Vec<_>>(), [0, 1, 2], "traces end where it stays");
    player.reverse();
    player.toggle();
    player.advance(1.0);
    assert_eq!(player.traced(9).collect::<Vec<_>>(), [2]);
    player.advance(2.0);
    assert_eq!((player.frame(), player.traced(9).collect::<Vec<_>>()), (1, vec![2, 1]));
    assert_eq!((player.range(), player.has_range()), ((0, 2), false));
    let one = Player::new(1, 1.0).waiting(1, 4);
    assert_eq!((one.waiting(1, 1).count(), one.count(), one.length()), (1, 1, 4));
}

#[test]
fn a_motion_that_got_shorter_keeps_what_can_be_kept() {
    let mut player = Player::new(10, 1.0);
    player.go_to(8);
    player.change_speed(true);
    let shorter = player.for_motion(4, 0.5);
    assert_eq!((shorter.frame(), shorter.range(), shorter.speed()), (3, (0, 3), 1.5));
    player.begin_range();
    assert_eq!(player.for_motion(0, 0.5).range(), (0, 0));
    assert_eq!(player.for_motion(20, 0.5).range(), (8, 9));
}

proptest! {
    #[test]
    fn it_plays_at_the_motions_own_speed_whatever_the_display(
        frame_time in 0.001f64..0.2,
        display in 0.001f64..0.2,
        pictures in 1usize..500,
        changes in 0usize..6,
        slower in any::<bool>(),
    ) {
        let mut player = Player::new(1_000_000, frame_time);
        (0..changes).for_each(|_| player.change_speed(!slower));
        player.toggle();
        for _ in 0..pictures {
            player.advance(display);
        }
        prop_assert!((0.1..=4.0).contains(&player.speed()));
        let expected = display * pictures as f64 / frame_time * player.speed();
        prop_assert!((player.frame() as f64 - expected).abs() <= 1.01, "{} and {expected}", player.frame());
    }

    #[test]
    fn backwards_is_the_mirror_of_forwards(steps in prop::collection::vec(0.0f64..9.0, 1..30)) {
        let (mut there, mut back) = (Player::new(7, 1.0), Player::new(7, 1.0));
        back.go_to(6);
        back.reverse();
        [&mut there, &mut back].into_iter().for_each(Player::toggle);
        for seconds in steps {
            there.advance(seconds);
            back.advance(seconds);
            prop_assert_eq!(there.frame(), 6 - back.frame());
        }
    }

    #[test]
    fn whatever_the_file_says_it_plays_and_stays_within_the_motion(
        frame_time in prop_oneof![any::<f64>(), (0u64..1 << 52).prop_map(f64::from_bits), Just(1e-6), Just(1e6)],
        seconds in prop::collection::vec(prop_oneof![any::<f64>(), 0.0..0.1], 1..20),
        backwards in any::<bool>(),
    ) {
        let motion = Motion::new(Skeleton::new(), 7, frame_time, Vec::new()).unwrap();
        let playable = motion.playable_frame_time();
        let mut player = Player::new(7, playable);
        player.toggle();
        if backwards {
            player.reverse();
        }
        for seconds in seconds {
            player.advance(seconds);
            prop_assert!(player.frame() < 7);
            prop_assert!(player.traced(5).all(|frame| frame < 7));
        }
        let mut player = Player::new(7, playable);
        player.toggle();
        player.advance(2.5 * playable);
        prop_assert_eq!(player.frame(), 2);
    }
}
