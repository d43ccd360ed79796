//! How long each picture of a film is seen.

use super::Format;

/// Half of the last digit with which most files write their frame time: 0.008333 means 1/120.
const WRITTEN: f64 = 5e-7;

/// The seconds that can be meant: those that a motion's frames can be played with.
pub(super) fn playable(seconds: f64) -> f64 {
    if (1e-6..=1e6).contains(&seconds) { seconds } else { 1.0 / 30.0 }
}

impl Format {
    /// How many pictures a second a film of this kind should have at most, so that it is played at its speed
    /// everywhere. What is shown for less than 2 hundredths of a second in a GIF, or not more than 1 hundredth in an
    /// APNG, is shown for 10 by browsers.
    pub fn most_per_second(self) -> f64 {
        match self {
            Format::Gif => 30.0,
            Format::Apng => 60.0,
        }
    }

    /// Every how many-th frame of a motion becomes a picture, so that a film of it keeps its speed and has at most
    /// [`Format::most_per_second`] pictures a second (or some percent more, as many frames take 0.033 seconds).
    ///
    /// `seconds` is the time from one frame to the next, divided by how fast the film is to be. What can not be played
    /// counts as 1/30. The film's [`Frames::seconds`](super::Frames::seconds) is then this number times `seconds`.
    pub fn every(self, seconds: f64) -> usize {
        let wanted = 1.0 / (playable(seconds) * self.most_per_second());
        (wanted * 0.98).ceil().max(1.0) as usize
    }
}

/// How long picture `index` is shown in a GIF, in hundredths of a second, when each is to be shown for `seconds`. What
/// is cut off from one is given to a later one: the first pictures together are never off by more than half a
/// hundredth, as long as none takes more than the 655.35 seconds that can be written.
pub fn hundredths(index: usize, seconds: f64) -> u16 {
    let end = |index: f64| (index * playable(seconds) * 100.0).round();
    let (start, end) = (end(index as f64), end(index as f64 + 1.0));
    // A float cast keeps to the range of its type.
    (end - start) as u16
}

/// `seconds` as a fraction: exactly, where that is possible with numbers up to 65535, otherwise the simplest fraction that
/// a file with 6 decimals may have meant. At most 65535 seconds.
pub fn fraction(seconds: f64) -> (u16, u16) {
    let seconds = playable(seconds);
    let error = |(numerator, denominator): (f64, f64)| (numerator / denominator - seconds).abs();
    let exact = simplest(seconds, 1e-12 * seconds);
    let fraction = match error(exact) <= 1e-9 * seconds {
        true => exact,
        false => simplest(seconds, WRITTEN.min(1e-4 * seconds)),
    };
    match fraction {
        (_, 0.0) => (u16::MAX, 1),
        (0.0, _) => (1, u16::MAX),
        (numerator, denominator) => (numerator as u16, denominator as u16),
    }
}

/// Numerator and denominator of the first convergent of the continued fraction that is as near as `tolerance`, or of
/// the last whose numbers are small enough. Convergents are the best approximations with so small a denominator.
fn simplest(seconds: f64, tolerance: f64) -> (f64, f64) {
    let limit = f64::from(u16::MAX);
    let (mut before, mut last) = ((0.0, 1.0), (1.0, 0.0));
    let mut rest = seconds;
    loop {
        let whole = rest.floor();
        let next: (f64, f64) = (whole * last.0 + before.0, whole * last.1 + before.1);
        if next.0 > limit || next.1 > limit {
            return last;
        }
        (before, last) = (last, next);
        if (last.0 / last.1 - seconds).abs() <= tolerance || rest == whole {
            return last;
        }
        rest = 1.0 / (rest - whole);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_written_frame_time_is_the_fraction_that_was_meant() {
        for (seconds, wanted) in [
            (1.0 / 120.0, (1, 120)),
            (0.008333, (1, 120)),
            (0.0083333, (1, 120)),
            (0.033333, (1, 30)),
            (0.0333333, (1, 30)),
            (0.016667, (1, 60)),
            (0.004167, (1, 240)),
            (0.04, (1, 25)),
            (0.033, (33, 1000)),
            (2.5, (5, 2)),
            (1.0 / 120.0 * 4.0, (1, 30)),
            (1001.0 / 30000.0, (1001, 30000)),
            (1e6, (65535, 1)),
            (1e-6, (1, 65535)),
            (f64::NAN, (1, 30)),
            (0.0, (1, 30)),
            (-1.0, (1, 30)),
        ] {
            assert_eq!(fraction(seconds), wanted, "{seconds}");
        }
    }

    #[test]
    fn motions_are_thinned_to_what_is_played_at_its_speed() {
        let rates = [24.0, 25.0, 29.97, 30.0, 30.3, 50.0, 60.0, 100.0, 120.0, 240.0];
        assert_eq!(rates.map(|rate| Format::Gif.every(1.0 / rate)), [1, 1, 1, 1, 1, 2, 2, 4, 4, 8]);
        assert_eq!(rates.map(|rate| Format::Apng.every(1.0 / rate)), [1, 1, 1, 1, 1, 1, 1, 2, 2, 4]);
        assert_eq!(Format::Gif.every(0.008333), 4);
        assert_eq!(Format::Gif.every(f64::INFINITY), 1);
        assert_eq!(Format::Gif.every(1e-6), 32667);
    }

    #[test]
    fn thirty_pictures_take_a_second() {
        let delays: Vec<u16> = (0..6).map(|index| hundredths(index, 1.0 / 30.0)).collect();
        assert_eq!(delays, [3, 4, 3, 3, 4, 3]);
        assert_eq!(hundredths(usize::MAX, f64::NAN), 0);
        assert_eq!(hundredths(3, 1e6), u16::MAX);
    }

    proptest! {
        #[test]
        fn delays_never_drift(seconds in 1e-6..300.0f64, count in 1usize..400) {
            let mut shown = 0.0;
            for index in 0..count {
                shown += f64::from(hundredths(index, seconds));
                let exact = 100.0 * seconds * (index + 1) as f64;
                prop_assert!((shown - exact).abs() <= 0.5 + 1e-6, "{index}: {shown}, not {exact}");
            }
        }

        #[test]
        fn thinned_pictures_are_long_enough_for_every_player(seconds in 1e-6..10.0f64) {
            for format in [Format::Gif, Format::Apng] {
                let every = format.every(seconds) as f64;
                prop_assert!(every * seconds >= 0.979 / format.most_per_second());
                prop_assert!(every == 1.0 || (every - 1.0) * seconds <= 1.0 / format.most_per_second());
            }
            let film = Format::Gif.every(seconds) as f64 * seconds;
            prop_assert!((0..40).all(|index| hundredths(index, film) >= 3));
        }

        #[test]
        fn fractions_are_near(seconds in 2e-3..6e4f64) {
            let (numerator, denominator) = fraction(seconds);
            let error = (f64::from(numerator) / f64::from(denominator) - seconds).abs();
            prop_assert!(error <= 1e-4 * seconds + WRITTEN || seconds > 100.0 && error <= 0.5, "{error}");
        }

        #[test]
        fn no_numbers_make_it_panic(seconds in any::<f64>(), index in any::<usize>()) {
            let (numerator, denominator) = fraction(seconds);
            prop_assert!(numerator > 0 && denominator > 0);
            hundredths(index, seconds);
            prop_assert!(Format::Gif.every(seconds) > 0);
        }
    }
}
