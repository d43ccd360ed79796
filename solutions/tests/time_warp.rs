//! The reference solution of time warping: the examples of its own text, and what holds for any motion and any count.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use glam::{EulerRot, Quat, Vec3};
use proptest::prelude::*;
use skeleton::acclaim::{Between, Posture};
use solutions::time_warp::{blend, old_position, warp};

mod places {
    use super::*;

    #[test]
    fn of_the_examples_are_those_they_say() {
        assert_eq!(old_position(3, 4, 8), Between { before: 1, after: 2, t: 0.5 });
        let Between { before, after, .. } = old_position(7, 4, 8);
        assert_eq!((before, after), (3, 3));
    }

    /// The table of the handout, and the mapping that it compares with.
    #[test]
    fn of_four_frames_that_become_eight_are_those_of_the_table() {
        let expected = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.0];
        let places = std::array::from_fn(|frame| along(old_position(frame, 4, 8)));
        assert_eq!(places, expected);
        let both_ends: Vec<String> =
            (0..4).map(|frame| format!("{:.2}", f64::from(frame) * 3.0 / 7.0)).collect();
        assert_eq!(both_ends, ["0.00", "0.43", "0.86", "1.29"]);
    }

    #[test]
    fn of_millions_of_frames_would_be_inexact_in_single_precision() {
        let kept = [3_000_000.3_f64, 9_000_000.3].map(|place| f64::from(place as f32));
        assert_eq!(kept, [3_000_000.25, 9_000_000.0]);
    }

    #[test]
    fn of_millions_of_frames_are_exact() {
        // 7,654,321 × 8,000,001 / 9,000,003 = 6,803,839.471422...
        let Between { before, after, t } = old_position(7_654_321, 8_000_001, 9_000_003);
        assert_eq!((before, after), (6_803_839, 6_803_840));
        assert!((t - 0.471_422).abs() < 1e-6, "{t}");
    }

    /// Any count, and often the largest and the smallest ones.
    fn count() -> impl Strategy<Value = usize> {
        prop_oneof![any::<usize>(), 0_usize..20, (0_usize..20).prop_map(|less| usize::MAX - less)]
    }

    proptest! {
        #[test]
        fn bear_any_count(new_frame in count(), old_count in count(), new_count in count()) {
            let Between { before, after, t } = old_position(new_frame, old_count, new_count);
            let last = old_count.saturating_sub(1);
            prop_assert!(before <= after && after <= last && after - before <= 1, "{} {}", before, after);
            prop_assert!((0.0..=1.0).contains(&t), "{}", t);
        }

        #[test]
        fn are_new_frame_times_old_count_by_new_count(
            old_count in 1_usize..10_000,
            new_count in 1_usize..10_000,
            part in 0.0..1.0,
        ) {
            let new_frame = (part * new_count as f64) as usize;
            let place = new_frame as f64 * old_count as f64 / new_count as f64;
            let place = place.min((old_count - 1) as f64);
            prop_assert!((along(old_position(new_frame, old_count, new_count)) - place).abs() < 1e-6);
        }

        #[test]
        fn never_go_back(old_count in 1_usize..300, new_count in 1_usize..300) {
            let places: Vec<f64> =
                (0..new_count).map(|frame| along(old_position(frame, old_count, new_count))).collect();
            prop_assert_eq!(places[0], 0.0);
            prop_assert!(places.is_sorted());
        }
    }

    fn along(Between { before, after, t }: Between) -> f64 {
        before as f64 + f64::from(t) * (after - before) as f64
    }
}

mod blends {
    use super::*;

    #[test]
    fn of_the_example_are_those_it_says() {
        let turned = |z| Posture { angles: vec![[0.0, 0.0, z]], translations: vec![Vec3::ZERO] };
        let half_way = blend(&turned(0.0), &turned(90.0), 0.5);
        assert!(apart(half_way.angles[0], [0.0, 0.0, 45.0]) < 1e-3, "{half_way:?}");
    }

    #[test]
    fn go_over_180_where_that_is_shorter() {
        let turned = |x| Posture { angles: vec![[x, 0.0, 0.0]], translations: vec![Vec3::ZERO] };
        let half_way = blend(&turned(170.0), &turned(-170.0), 0.25);
        assert!(apart(half_way.angles[0], [175.0, 0.0, 0.0]) < 1e-3, "{half_way:?}");
    }

    proptest! {
        #[test]
        fn begin_at_the_one_and_end_at_the_other((from, to) in (posture(3), posture(3))) {
            prop_assert!(is_same(&blend(&from, &to, 0.0), &from));
            prop_assert!(is_same(&blend(&from, &to, 1.0), &to));
        }

        /// The way so far is a part of the whole way, and about the same axis.
        #[test]
        fn turn_evenly_about_one_axis((from, to) in (posture(1), posture(1)), t in 0.05_f32..0.95) {
            let [from, to] = [from, to].map(|posture| posture.angles[0]);
            let whole = apart(from, to);
            // Half a turn has two ways, and near a middle angle of ±90 degrees angles are inexact.
            prop_assume!(whole < 170.0);
            let between = angles_between(from, to, t);
            prop_assume!(middle_sine(between) < 0.99);
            prop_assert!((apart(from, between) - f64::from(t) * whole).abs() < 0.01);
            prop_assert!((apart(between, to) - f64::from(1.0 - t) * whole).abs() < 0.01);
        }

        #[test]
        fn move_along_a_straight_line((from, to) in (posture(4), posture(4)), t in 0.0_f32..1.0) {
            let between = blend(&from, &to, t);
            for (bone, at) in between.translations.iter().enumerate() {
                let (from, to) = (from.translations[bone], to.translations[bone]);
                prop_assert!(at.distance(from + (to - from) * t) < 1e-3);
            }
        }
    }

    fn angles_between(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        let [from, to] = [from, to].map(|angles| Posture { angles: vec![angles], translations: Vec::new() });
        blend(&from, &to, t).angles[0]
    }

    /// Of the angle about Y.
    fn middle_sine([_, y, _]: [f32; 3]) -> f32 {
        y.to_radians().sin().abs()
    }
}

mod motions {
    use super::*;

    #[test]
    fn of_the_example_are_those_it_says() {
        let old: Vec<Posture> = [0.0, 40.0, 100.0].map(turned).into();
        let new = warp(&old, 6);
        for (frame, z) in [0.0, 20.0, 40.0, 70.0, 100.0, 100.0].into_iter().enumerate() {
            assert!(is_same(&new[frame], &turned(z)), "{frame}: {:?}", new[frame]);
        }
        assert_eq!(new.len(), 6);
    }

    #[test]
    fn without_frames_stay_without() {
        for new_count in [0, 1, 1000, usize::MAX] {
            assert!(warp(&[], new_count).is_empty());
        }
    }

    #[test]
    fn of_one_frame_stand_still() {
        for new_count in [0, 1, 7] {
            let new = warp(&[turned(30.0)], new_count);
            assert_eq!(new.len(), new_count);
            assert!(new.iter().all(|posture| is_same(posture, &turned(30.0))));
        }
    }

    #[test]
    fn become_nothing_or_their_first_frame() {
        let old: Vec<Posture> = [10.0, 40.0, 100.0].map(turned).into();
        assert!(warp(&old, 0).is_empty());
        let one = warp(&old, 1);
        assert!(one.len() == 1 && is_same(&one[0], &old[0]));
    }

    fn turned(z: f32) -> Posture {
        Posture { angles: vec![[0.0, 0.0, z]], translations: vec![Vec3::new(z, 1.0, 0.0)] }
    }

    fn motion() -> impl Strategy<Value = Vec<Posture>> {
        prop::collection::vec(posture(3), 0..12)
    }

    proptest! {
        #[test]
        fn of_as_many_frames_are_what_they_were(old in motion()) {
            prop_assert!(are_same(&warp(&old, old.len()), &old));
        }

        #[test]
        fn come_back_from_so_many_times_as_many_frames(old in motion(), times in 1_usize..6) {
            let longer = warp(&old, times * old.len());
            prop_assert_eq!(longer.len(), times * old.len());
            for (frame, posture) in old.iter().enumerate() {
                prop_assert!(is_same(&longer[times * frame], posture), "frame {}", frame);
            }
            prop_assert!(are_same(&warp(&longer, old.len()), &old));
        }

        #[test]
        fn have_as_many_frames_as_are_asked_for(old in motion(), new_count in 0_usize..50) {
            let new = warp(&old, new_count);
            prop_assert_eq!(new.len(), if old.is_empty() { 0 } else { new_count });
            prop_assert!(new.iter().all(|posture| posture.angles.len() == 3 && posture.translations.len() == 3));
        }
    }
}

/// Any posture of so many bones, whose middle angles keep a degree away from ±90, where angles become inexact.
fn posture(bones: usize) -> impl Strategy<Value = Posture> {
    let middle = prop_oneof![-89.0_f32..89.0, 91.0_f32..269.0];
    let angles = (-400.0_f32..400.0, middle, -400.0_f32..400.0).prop_map(|(x, y, z)| [x, y, z]);
    let translation = prop::array::uniform3(-50.0_f32..50.0).prop_map(Vec3::from);
    let all = (prop::collection::vec(angles, bones), prop::collection::vec(translation, bones));
    all.prop_map(|(angles, translations)| Posture { angles, translations })
}

fn are_same(a: &[Posture], b: &[Posture]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
}

/// Rotations within a hundredth of a degree.
fn is_same(a: &Posture, b: &Posture) -> bool {
    let turned = a.angles.iter().zip(&b.angles).all(|(a, b)| apart(*a, *b) < 0.01);
    let moved = a.translations.iter().zip(&b.translations).all(|(a, b)| a.distance(*b) < 1e-3);
    a.angles.len() == b.angles.len() && a.translations.len() == b.translations.len() && turned && moved
}

/// The angle between two rotations, in degrees.
fn apart(a: [f32; 3], b: [f32; 3]) -> f64 {
    let [a, b] = [a, b]
        .map(|[x, y, z]| Quat::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians()));
    let turn = a.conjugate() * b;
    2.0 * f64::from(turn.xyz().length()).atan2(f64::from(turn.w.abs())).to_degrees()
}
