//! Which frame is shown: one step at a time, or played at the motion's own speed.

/// Goes through the frames of a motion, again and again.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    frame: usize,
    count: usize,
    /// Seconds from one frame to the next.
    frame_time: f64,
    playing: bool,
    /// Seconds for which the frame has been shown already.
    shown_for: f64,
}

impl Player {
    /// Stands at frame 0 of `count` (at least 1), which follow each other after `frame_time` seconds (positive).
    pub fn new(count: usize, frame_time: f64) -> Player {
        Player { frame: 0, count: count.max(1), frame_time, playing: false, shown_for: 0.0 }
    }

    /// The frame to show, from 0.
    pub fn frame(&self) -> usize {
        self.frame
    }

    /// Whether it is playing.
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// Plays, or pauses. A single frame cannot be played.
    pub fn toggle(&mut self) {
        self.playing = !self.playing && self.count > 1;
        self.shown_for = 0.0;
    }

    /// Pauses and goes to `frame`, or to the last one.
    pub fn go_to(&mut self, frame: usize) {
        *self = Player { frame: frame.min(self.count - 1), ..Player::new(self.count, self.frame_time) };
    }

    /// Pauses and goes to the next frame; the first one follows the last.
    pub fn next(&mut self) {
        self.go_to((self.frame + 1) % self.count);
    }

    /// Pauses and goes to the frame before; the last one is before the first.
    pub fn previous(&mut self) {
        self.go_to((self.frame + self.count - 1) % self.count);
    }

    /// Lets `seconds` pass. Frames that do not fit between two pictures are left out, so that the motion keeps its
    /// speed on every display.
    pub fn advance(&mut self, seconds: f64) {
        if !self.playing {
            return;
        }
        self.shown_for += seconds.max(0.0);
        let steps = (self.shown_for / self.frame_time).floor();
        self.shown_for -= steps * self.frame_time;
        self.frame = (self.frame + (steps % self.count as f64) as usize) % self.count;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use skeleton::{Motion, Skeleton};

    use super::*;

    #[test]
    fn steps_go_around_and_pause() {
        let mut player = Player::new(3, 0.1);
        player.toggle();
        player.next();
        assert!(!player.is_playing());
        player.next();
        assert_eq!(player.frame(), 2);
        player.next();
        assert_eq!(player.frame(), 0);
        player.previous();
        assert_eq!(player.frame(), 2);
        player.go_to(99);
        assert_eq!(player.frame(), 2);
    }

    #[test]
    fn a_single_frame_does_not_play() {
        let mut player = Player::new(0, 0.1);
        player.toggle();
        player.advance(1.0);
        assert_eq!((player.frame(), player.is_playing()), (0, false));
    }

    proptest! {
        #[test]
        fn it_plays_at_the_motions_own_speed_whatever_the_display(
            frame_time in 0.001f64..0.2,
            display in 0.001f64..0.2,
            pictures in 1usize..500,
        ) {
            let mut player = Player::new(1_000_000, frame_time);
            player.toggle();
            for _ in 0..pictures {
                player.advance(display);
            }
            let expected = display * pictures as f64 / frame_time;
            prop_assert!((player.frame() as f64 - expected).abs() <= 1.01, "{} and {expected}", player.frame());
        }

        #[test]
        fn whatever_the_file_says_it_plays_and_stays_within_the_motion(
            frame_time in prop_oneof![any::<f64>(), (0u64..1 << 52).prop_map(f64::from_bits), Just(1e-6), Just(1e6)],
            seconds in prop::collection::vec(prop_oneof![any::<f64>(), 0.0..0.1], 1..20),
        ) {
            let motion = Motion::new(Skeleton::new(), 7, frame_time, Vec::new()).unwrap();
            let playable = motion.playable_frame_time();
            let mut player = Player::new(7, playable);
            player.toggle();
            for seconds in seconds {
                player.advance(seconds);
                prop_assert!(player.frame() < 7);
            }
            player.go_to(0);
            player.toggle();
            player.advance(2.5 * playable);
            prop_assert_eq!(player.frame(), 2);
        }
    }
}
