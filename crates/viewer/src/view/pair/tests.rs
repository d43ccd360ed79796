//! A motion and the same one warped, in one window.

use std::path::Path;

use proptest::prelude::*;
use skeleton::PositionChannels;

use super::*;
use crate::motion::source::Source;
use crate::motion::time_map::TimeMap;
use crate::samples;
use crate::scene::{Line, Scene, Stroke};
use crate::view::app::Shown;

mod picture;

const SIZE: (usize, usize) = (1280, 720);

fn stage(frames: usize) -> Arc<Stage> {
    Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace))
}

fn app(stage: Arc<Stage>) -> App {
    App::new(stage, "walk.amc".into(), Vec::new(), (640, 720))
}

fn pair_of(map: TimeMap) -> Vec<App> {
    let original = stage(map.old_count());
    let warped = Arc::new(original.warped(map));
    vec![app(original), app(warped)]
}

/// A pair of `old` and `new` frames.
fn pair(old: usize, new: usize) -> Gallery {
    Gallery::new(pair_of(TimeMap::Whole { old, new }))
}

fn frames(gallery: &Gallery) -> Vec<usize> {
    gallery.apps().iter().map(App::frame).collect()
}

fn map(gallery: &Gallery) -> TimeMap {
    gallery.apps()[1].time_map().unwrap()
}

fn scenes(gallery: &mut Gallery) -> Vec<Scene> {
    scenes_in(gallery, SIZE)
}

fn scenes_in(gallery: &mut Gallery, size: (usize, usize)) -> Vec<Scene> {
    let tiles: Vec<_> = gallery.tiles(size).collect();
    let mut scene = |tile: &crate::view::gallery::Tile| {
        gallery.apps_mut()[tile.motion].scene(Shown::Reference, tile.size)
    };
    tiles.iter().map(&mut scene).collect()
}

fn words(scene: &Scene) -> String {
    let lines = scene.panels.iter().flat_map(|panel| panel.lines());
    lines.map(|(_, text)| text.to_owned()).collect::<Vec<_>>().join("\n")
}

mod time {
    use super::*;

    #[test]
    fn both_are_at_the_same_time_and_the_shorter_one_waits() {
        for (old, new) in [(10, 20), (20, 10)] {
            let mut gallery = pair(old, new);
            gallery.act(Action::Play);
            gallery.advance(0.65);
            assert_eq!(frames(&gallery), [6, 6]);
            gallery.advance(0.9);
            assert_eq!(frames(&gallery), [15.min(old - 1), 15.min(new - 1)]);
            assert!(gallery.apps().iter().all(|app| app.player().is_playing()));
            gallery.advance(0.5);
            assert_eq!(frames(&gallery), [0, 0], "both begin again together");
            gallery.act(Action::Last);
            assert_eq!(frames(&gallery), [old - 1, new - 1]);
            gallery.act(Action::Step(-2));
            assert_eq!(frames(&gallery), [17.min(old - 1), 17.min(new - 1)]);
            gallery.act(Action::Reverse);
            gallery.act(Action::Play);
            gallery.advance(0.9);
            assert_eq!(frames(&gallery), [8, 8]);
        }
    }

    #[test]
    fn each_bar_goes_to_the_same_time_in_both() {
        let mut gallery = pair(10, 20);
        gallery.go_to(0, 9);
        assert_eq!(frames(&gallery), [9, 9]);
        gallery.go_to(1, 15);
        assert_eq!(frames(&gallery), [9, 15]);
        let place = |gallery: &Gallery, tile: usize, share: f32| {
            let tile = gallery.tiles(SIZE).nth(tile).unwrap();
            (tile.corner.0 as f32 + 26.0 + share * (tile.size.0 as f32 - 52.0), 715.0)
        };
        let end = place(&gallery, 1, 1.0);
        assert!(gallery.on_bar(end, SIZE));
        gallery.scrub(end, end, SIZE);
        assert_eq!(frames(&gallery), [9, 19]);
        let begin = place(&gallery, 0, 0.0);
        gallery.scrub(begin, begin, SIZE);
        assert_eq!(frames(&gallery), [0, 0]);
    }

    #[test]
    fn without_a_loop_both_stop_at_the_end_of_the_longer_one() {
        let mut gallery = pair(10, 20);
        gallery.act(Action::Loop);
        gallery.act(Action::Play);
        gallery.advance(1.5);
        assert!(gallery.apps()[0].player().is_waiting());
        gallery.advance(9.0);
        assert_eq!(frames(&gallery), [9, 19]);
        assert!(gallery.apps().iter().all(|app| !app.player().is_playing()));
        gallery.act(Action::Play);
        assert_eq!(frames(&gallery), [0, 0]);
    }

    #[test]
    fn pairs_stand_beside_each_other_and_each_is_in_step() {
        let mut apps = pair_of(TimeMap::Whole { old: 10, new: 20 });
        apps.extend(pair_of(TimeMap::Whole { old: 40, new: 30 }));
        let mut gallery = Gallery::new(apps);
        gallery.go_to(0, 15);
        assert_eq!(frames(&gallery), [9, 15, 15, 15]);
        gallery.act(Action::Play);
        gallery.advance(2.0);
        assert_eq!(frames(&gallery)[..2], [9, 15], "the first pair has begun again");
        assert_eq!(frames(&gallery)[2..], [35, 29]);
        let tiles: Vec<_> = gallery.tiles(SIZE).collect();
        assert!(tiles[0].corner.1 == tiles[1].corner.1 && tiles[2].corner.1 == tiles[3].corner.1);
        assert!(tiles[0].corner.0 < tiles[1].corner.0 && tiles[2].corner.0 < tiles[3].corner.0);
    }
}

mod keys {
    use super::*;

    #[test]
    fn arrows_change_the_number_of_frames() {
        let mut gallery = pair(40, 80);
        let mut after = |by: isize| {
            gallery.act(Action::Keyframes(by));
            map(&gallery).frame_count()
        };
        assert_eq!([1, 1, -1, 10, 1, -10].map(&mut after), [84, 88, 84, 85, 88, 87]);
        assert_eq!(gallery.apps()[1].player().count(), 87);
        assert_eq!(gallery.apps()[1].title(), "walk.amc, 40 → 87 frames");
        for _ in 0..99 {
            gallery.act(Action::Keyframes(-1));
        }
        assert_eq!(map(&gallery).frame_count(), 1);
        assert_eq!(gallery.window_title(), "walk.amc, 40 → 1 frame · frame 0 / 1");
        assert_eq!(gallery.apps()[0].stage().moving_frames(), 40);
    }

    #[test]
    fn brackets_set_the_stretch_at_the_frame_of_the_original() {
        let mut gallery = pair(40, 80);
        gallery.go_to(0, 10);
        gallery.act(Action::RangeStart);
        gallery.go_to(0, 20);
        gallery.act(Action::RangeEnd);
        assert_eq!(map(&gallery), TimeMap::Stretch { old: 40, first: 10, last: 20, new: 20 });
        assert_eq!(gallery.window_title(), "walk.amc, frames 10–20: 10 → 20 · frame 20 / 50");
        assert!(gallery.apps().iter().all(|app| !app.player().has_range()), "all is played");
        gallery.act(Action::Keyframes(1));
        assert_eq!(map(&gallery).frame_count(), 51);
        // The original's end, while the warped one goes on.
        gallery.go_to(1, 50);
        gallery.act(Action::RangeStart);
        assert_eq!(map(&gallery), TimeMap::Whole { old: 40, new: 84 });
        gallery.act(Action::RangeEnd);
        assert_eq!(map(&gallery), TimeMap::Whole { old: 40, new: 84 });
    }

    #[test]
    fn only_the_original_is_interpolated_in_the_stretch_that_is_warped() {
        let mut gallery = pair(40, 80);
        gallery.go_to(0, 10);
        gallery.act(Action::RangeStart);
        gallery.act(Action::Interpolate);
        let wishes = |gallery: &Gallery| gallery.apps().iter().map(App::wish).collect::<Vec<_>>();
        let ends = crate::edit::Keys::Ends(10, 39);
        assert_eq!(wishes(&gallery)[0].as_ref().map(|wish| wish.keys), Some(ends));
        assert_eq!(wishes(&gallery)[1], None);
        gallery.act(Action::Automatic);
        let before = map(&gallery);
        gallery.act(Action::Keyframes(1));
        assert_eq!(gallery.apps()[0].keyframe_count(), 21);
        assert_eq!(map(&gallery), before, "arrows count keyframes while these are chosen");
        assert!(gallery.apps()[1].editing().is_none());
        gallery.act(Action::Automatic);
        gallery.act(Action::Keyframes(1));
        assert_ne!(map(&gallery), before);
    }

    #[test]
    fn the_curve_is_there_from_the_beginning_and_p_hides_it() {
        let mut gallery = pair(40, 80);
        let plots = |gallery: &mut Gallery| {
            scenes(gallery).iter().map(|scene| scene.plot.is_some()).collect::<Vec<_>>()
        };
        assert_eq!(plots(&mut gallery), [false, true]);
        gallery.act(Action::Plot);
        assert_eq!(plots(&mut gallery), [false, false]);
        gallery.act(Action::Plot);
        assert_eq!(plots(&mut gallery), [false, true]);
        assert!(!words(&scenes(&mut gallery)[0]).contains("press i or k"));
    }
}

mod files {
    use super::*;

    #[test]
    fn a_file_that_is_saved_anew_keeps_the_warp() {
        let mut gallery = pair(40, 80);
        gallery.act(Action::Keyframes(1));
        gallery.go_to(1, 60);
        gallery.replace(0, &stage(50), vec!["odd".into()], None);
        assert_eq!(map(&gallery), TimeMap::Whole { old: 50, new: 84 });
        assert_eq!(frames(&gallery), [49, 60]);
        assert_eq!((gallery.apps()[0].warnings().len(), gallery.apps()[1].warnings().len()), (1, 0));
        gallery.go_to(0, 30);
        gallery.act(Action::RangeStart);
        gallery.replace(0, &stage(20), Vec::new(), None);
        assert_eq!(map(&gallery).old_count(), 20);
        assert_eq!(map(&gallery).keyframes(), None, "the new file ends before the stretch");
        gallery.replace(0, &stage(50), Vec::new(), None);
        assert_eq!(map(&gallery).keyframes().map(|[(first, _), _]| first), Some(30));
    }

    #[test]
    fn a_pair_that_could_not_be_read_becomes_one_when_it_can() {
        let nothing = || app(crate::motion::source::nothing());
        let mut gallery = Gallery::new(vec![nothing(), nothing()]);
        assert_eq!(gallery.apps()[1].title(), "walk.amc");
        let warp = Warp::new(TimeMap::Whole { old: 0, new: 30 });
        gallery.replace(0, &stage(20), Vec::new(), Some(warp));
        assert_eq!(map(&gallery), TimeMap::Whole { old: 20, new: 30 });
        assert_eq!(gallery.apps()[1].title(), "walk.amc, 20 → 30 frames");
        gallery.act(Action::Last);
        assert_eq!(frames(&gallery), [19, 29]);
    }
}

/// Everything that can happen to a pair.
fn happenings() -> impl Strategy<Value = Vec<(u8, usize)>> {
    prop::collection::vec((0u8..16, 0usize..70), 0..60)
}

proptest! {
    #[test]
    fn whatever_keys_are_pressed_both_show_the_same_time_or_the_shorter_one_its_end(
        (old, new) in (1usize..40, 1usize..60), happenings in happenings(),
    ) {
        let mut gallery = pair(old, new);
        for (what, number) in happenings {
            match what {
                0 => gallery.act(Action::Play),
                1 => gallery.act(Action::Reverse),
                2 => gallery.act(Action::Loop),
                3 => gallery.act(Action::Step(number as isize - 35)),
                4 => gallery.act(Action::First),
                5 => gallery.act(Action::Last),
                6 => gallery.act(Action::Faster),
                7 => gallery.act(Action::Slower),
                8 => gallery.act(Action::Keyframes(if number % 2 == 0 { 1 } else { 10 })),
                9 => gallery.act(Action::Keyframes(if number % 2 == 0 { -1 } else { -10 })),
                10 => gallery.act(Action::RangeStart),
                11 => gallery.act(Action::RangeEnd),
                12 => gallery.go_to(number % 2, number),
                13 => gallery.act(Action::NextMotion),
                14 => gallery.replace(0, &stage(1 + number / 2), Vec::new(), None),
                _ => gallery.advance(number as f64 * 0.03),
            }
            let [original, warped] = gallery.apps() else { unreachable!() };
            let (a, b) = (original.player(), warped.player());
            let counts = [original, warped].map(|app| app.stage().frame_count());
            prop_assert_eq!((a.count(), b.count()), (counts[0], counts[1]));
            prop_assert_eq!(a.time(), b.time());
            prop_assert!(a.time() < counts[0].max(counts[1]));
            prop_assert_eq!(a.frame(), a.time().min(counts[0] - 1));
            prop_assert_eq!(b.frame(), a.time().min(counts[1] - 1));
            prop_assert_eq!((a.is_playing(), a.is_backwards()), (b.is_playing(), b.is_backwards()));
            prop_assert_eq!(warped.time_map().map(|map| map.old_count()), Some(counts[0]));
        }
    }
}
