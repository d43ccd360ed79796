//! Several motions in one window: side by side, or each by itself.

use crate::draw::timeline::Bar;
use crate::live::mover::Mover;
use crate::live::student::Points;
use crate::view::app::App;
use crate::window::keys::Action;

/// One motion or several. Keys and mouse act on all of them, so that they stay in step and are seen from the same side. A motion
/// and the same one warped, which stands behind it, share one time: the shorter one waits at its end.
#[derive(Clone, Debug)]
pub struct Gallery {
    apps: Vec<App>,
    /// The one that is shown by itself; `None` when all are.
    alone: Option<usize>,
}

/// A part of the window, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// The motion that is shown in it, counted from 0.
    pub motion: usize,
    /// Its left and its upper border.
    pub corner: (usize, usize),
    /// Its width and its height.
    pub size: (usize, usize),
}

impl Tile {
    /// A place in the window, counted from the tile's corner; `None` outside of the tile.
    pub fn inside(&self, (x, y): (f32, f32)) -> Option<(f32, f32)> {
        let (x, y) = (x - self.corner.0 as f32, y - self.corner.1 as f32);
        let fits = (0.0..self.size.0 as f32).contains(&x) && (0.0..self.size.1 as f32).contains(&y);
        fits.then_some((x, y))
    }
}

impl Gallery {
    /// Shows all of these side by side.
    pub fn new(apps: Vec<App>) -> Gallery {
        let mut gallery = Gallery { apps, alone: None };
        gallery.keep_in_step();
        gallery
    }

    /// The motions, in the order in which they were given.
    pub fn apps(&self) -> &[App] {
        &self.apps
    }

    /// The same, to be changed.
    pub fn apps_mut(&mut self) -> &mut [App] {
        &mut self.apps
    }

    /// How many motions share the window at first, as columns and rows.
    pub fn grid(count: usize, (width, height): (usize, usize)) -> (usize, usize) {
        let count = count.max(1);
        // Tiles that are about as wide as they are high show most of a figure.
        let squareness = |columns: usize| {
            let (w, h) = (width as f32 / columns as f32, height as f32 / count.div_ceil(columns) as f32);
            w.min(h)
        };
        let columns = (1..=count).max_by(|a, b| squareness(*a).total_cmp(&squareness(*b))).unwrap_or(1);
        (columns, count.div_ceil(columns))
    }

    /// Which motions are shown now, and where in a window of `size` pixels.
    pub fn tiles(&self, size: (usize, usize)) -> impl Iterator<Item = Tile> + use<> {
        let shown = match self.alone {
            Some(motion) => motion..motion + 1,
            None => 0..self.apps.len(),
        };
        let (columns, rows) = match self.is_pairs() && shown.len() > 1 {
            true => {
                // Both of a pair stand beside each other.
                let (pairs, rows) = Gallery::grid(shown.len() / 2, (size.0 / 2, size.1));
                (2 * pairs, rows)
            }
            false => Gallery::grid(shown.len(), size),
        };
        let first = shown.start;
        shown.map(move |motion| {
            let (column, row) = ((motion - first) % columns, (motion - first) / columns);
            let edge = |index: usize, count: usize, length: usize| length * index / count;
            let corner = (edge(column, columns, size.0), edge(row, rows, size.1));
            let end = (edge(column + 1, columns, size.0), edge(row + 1, rows, size.1));
            Tile { motion, corner, size: (end.0 - corner.0, end.1 - corner.1) }
        })
    }

    /// Does what a key asks for. [`Action::Quit`] is up to the window.
    pub fn act(&mut self, action: Action) {
        match action {
            Action::NextMotion if self.apps.len() > 1 => {
                let next = self.alone.map_or(0, |motion| motion + 1);
                self.alone = (next < self.apps.len()).then_some(next);
            }
            // All play, or none: a short one may have come to its end.
            Action::Play => {
                let play = !self.apps.iter().any(|app| app.player().is_playing());
                self.apps.iter_mut().for_each(|app| app.set_playing(play));
            }
            action => self.act_in_all(action),
        }
        self.keep_in_step();
    }

    /// Shows the points of a student's functions, which are of the exercise `mover`, also with the motions that these do not
    /// move: beside the original of a warped motion there is more room than with the warped one.
    pub fn show_points(&mut self, mover: Mover, points: &Points) {
        for app in &mut self.apps {
            app.show_points_of_other((!mover.moves(app.stage())).then(|| points.clone()));
        }
    }

    /// Whether a place in a window of `size` pixels is on a scrub bar.
    pub fn on_bar(&self, place: (f32, f32), size: (usize, usize)) -> bool {
        self.tiles(size).any(|tile| {
            let bar = self.bar(tile);
            bar.zip(tile.inside(place)).is_some_and(|(bar, (x, y))| bar.contains(x, y))
        })
    }

    /// The scrub bar of a tile.
    fn bar(&self, tile: Tile) -> Option<Bar> {
        let app = &self.apps[tile.motion];
        Bar::new(&app.timeline()?, tile.size, app.settings.text_scale)
    }

    /// Goes to the frame at `now` on the bar on which `pressed` is; both are places in a window of `size` pixels.
    pub fn scrub(&mut self, pressed: (f32, f32), now: (f32, f32), size: (usize, usize)) {
        let Some(tile) = self.tiles(size).find(|tile| tile.inside(pressed).is_some()) else { return };
        if let Some(bar) = self.bar(tile) {
            let frame = bar.frame_at(now.0 - tile.corner.0 as f32);
            self.go_to(tile.motion, frame);
        }
    }

    /// Goes to `frame` of `motion`, and to the same time in all others.
    pub fn go_to(&mut self, motion: usize, frame: usize) {
        for other in 0..self.apps.len() {
            let frame = self.same_time(motion, frame, other);
            self.apps[other].go_to(frame);
        }
        self.keep_in_step();
    }

    /// The frame of the motion `other` that is shown together with `frame` of `motion`: that of the same time.
    pub fn frame_at_the_time_of(&self, motion: usize, frame: usize, other: usize) -> usize {
        self.same_time(motion, frame, other).min(self.apps[other].stage().frame_count() - 1)
    }

    /// The same, though the motion `other` may have ended by then.
    fn same_time(&self, motion: usize, frame: usize, other: usize) -> usize {
        let seconds = |motion: usize| self.apps[motion].stage().motion().playable_frame_time();
        (frame as f64 * seconds(motion) / seconds(other)).round() as usize
    }

    /// Lets `seconds` pass.
    pub fn advance(&mut self, seconds: f64) {
        self.apps.iter_mut().for_each(|app| app.advance(seconds));
        self.keep_in_step();
    }

    /// A line for the window's title bar.
    pub fn window_title(&self) -> String {
        match (self.alone, &self.apps[..]) {
            (None, [_, _, ..]) if self.only_pair().is_none() => {
                let titles: Vec<&str> = self.apps.iter().map(App::title).collect();
                titles.join(" · ")
            }
            (None, _) => self.only_pair().or(self.apps.first()).map(App::window_title).unwrap_or_default(),
            (Some(alone), apps) => apps.get(alone).map(App::window_title).unwrap_or_default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use proptest::prelude::*;
    use skeleton::PositionChannels;

    use super::*;
    use crate::motion::stage::Stage;
    use crate::motion::time_map::TimeMap;
    use crate::samples;

    fn gallery(count: usize) -> Gallery {
        let stage = Arc::new(Stage::new(samples::chain(9, 1.0), PositionChannels::Replace));
        let app = |i: usize| App::new(stage.clone(), format!("{i}.bvh"), Vec::new(), (640, 480));
        Gallery::new((0..count).map(app).collect())
    }

    #[test]
    fn a_key_goes_from_all_to_each_and_back() {
        let mut gallery = gallery(3);
        let shown = |gallery: &Gallery| gallery.tiles((900, 300)).map(|tile| tile.motion).collect::<Vec<_>>();
        assert_eq!(shown(&gallery), [0, 1, 2]);
        assert_eq!(gallery.window_title(), "0.bvh · 1.bvh · 2.bvh");
        for motion in 0..3 {
            gallery.act(Action::NextMotion);
            assert_eq!(shown(&gallery), [motion]);
            assert!(gallery.window_title().starts_with(&format!("{motion}.bvh · frame 0 / 9")));
        }
        gallery.act(Action::NextMotion);
        assert_eq!(shown(&gallery).len(), 3);
    }

    #[test]
    fn one_motion_has_the_window_for_itself_and_keys_move_all() {
        let mut one = gallery(1);
        one.act(Action::NextMotion);
        let tile = Tile { motion: 0, corner: (0, 0), size: (33, 7) };
        assert_eq!(one.tiles((33, 7)).collect::<Vec<_>>(), [tile]);
        let mut gallery = gallery(2);
        gallery.act(Action::NextMotion);
        gallery.act(Action::Step(4));
        assert!(gallery.apps().iter().all(|app| app.frame() == 4));
    }

    #[test]
    fn whatever_one_does_they_stay_at_the_same_time() {
        let motion = |frames, time| {
            let chain = samples::chain(frames, 1.0);
            skeleton::Motion::new(chain.skeleton().clone(), frames, time, chain.values().to_vec()).unwrap()
        };
        let app = |motion| {
            let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
            App::new(stage, "a".into(), Vec::new(), (640, 480))
        };
        let mut gallery =
            Gallery::new(vec![app(motion(40, 0.01)), app(motion(11, 0.04)), app(motion(3, 0.1))]);
        gallery.act(Action::Play);
        gallery.go_to(0, 20);
        let frames = |gallery: &Gallery| gallery.apps().iter().map(App::frame).collect::<Vec<_>>();
        assert_eq!(frames(&gallery), [20, 5, 2]);
        assert!(gallery.apps().iter().all(|app| !app.player().is_playing()));
        gallery.go_to(1, 10);
        assert_eq!(frames(&gallery), [39, 10, 2]);

        gallery.act(Action::Loop);
        gallery.go_to(0, 0);
        gallery.act(Action::Play);
        gallery.advance(0.35);
        let playing =
            |gallery: &Gallery| gallery.apps().iter().filter(|app| app.player().is_playing()).count();
        assert_eq!(playing(&gallery), 2, "the short one has ended");
        gallery.act(Action::Play);
        assert_eq!(playing(&gallery), 0);
    }

    #[test]
    fn points_are_shown_with_the_motions_that_the_functions_do_not_move() {
        let stage = Stage::new(samples::chain(9, 1.0), PositionChannels::Replace);
        let warped = stage.warped(TimeMap::Whole { old: 9, new: 18 });
        let app = |stage| App::new(Arc::new(stage), "a.bvh".into(), Vec::new(), (640, 480));
        let mut gallery = Gallery::new(vec![app(stage), app(warped)]);
        for (mover, expected) in [(Mover::TimeWarp, [true, false]), (Mover::Fk, [false; 2])] {
            gallery.show_points(mover, &Points { grading: true, ..Points::default() });
            let shown: Vec<bool> = gallery.apps().iter().map(|app| app.points_of_other().is_some()).collect();
            assert_eq!(shown, expected, "{mover:?}");
        }
    }

    proptest! {
        #[test]
        fn tiles_fill_the_window_and_share_no_pixel(count in 1usize..9, width in 16usize..200, height in 16usize..200) {
            let mut covered = vec![0; width * height];
            let (columns, rows) = Gallery::grid(count, (width, height));
            for tile in gallery(count).tiles((width, height)) {
                for y in tile.corner.1..tile.corner.1 + tile.size.1 {
                    for x in tile.corner.0..tile.corner.0 + tile.size.0 {
                        covered[y * width + x] += 1;
                        prop_assert!(tile.inside((x as f32, y as f32)).is_some());
                    }
                }
            }
            prop_assert!(covered.iter().all(|times| *times <= 1));
            prop_assert!(columns * rows > count || covered.iter().all(|times| *times == 1));
        }
    }
}
