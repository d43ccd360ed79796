//! What is to be seen of a pair.

use super::*;

#[test]
fn the_curve_leads_from_new_frames_to_old_ones() {
    let mut gallery = Gallery::new(pair_of(TimeMap::stretch(41, (10, 20), 30).unwrap()));
    gallery.go_to(0, 25);
    let scenes = scenes(&mut gallery);
    let plot = scenes[1].plot.as_ref().unwrap();
    let curves: Vec<_> = plot.curves.iter().map(|curve| (curve.stroke, &curve.points[..])).collect();
    let straight = [(0.0, 0.0), (40.0 / 60.0, 1.0)];
    let warped = [(0.0, 0.0), (10.0 / 60.0, 0.25), (40.0 / 60.0, 0.5), (1.0, 1.0)];
    assert_eq!(curves, [(Stroke::Faint, &straight[..]), (Stroke::Solid, &warped[..])]);
    assert_eq!(plot.mark, Some((25.0 / 60.0, 15.0 / 40.0)));
    assert_eq!(plot.posts, [10.0 / 60.0, 40.0 / 60.0]);
    let labels =
        |ticks: &[crate::scene::Tick]| ticks.iter().map(|tick| tick.label.clone()).collect::<Vec<_>>();
    assert_eq!(labels(&plot.columns), ["0", "20", "40", "60"]);
    assert_eq!(labels(&plot.rows), ["0", "10", "20", "30", "40"]);
    assert_eq!([&scenes[0].keyframes[..], &scenes[1].keyframes[..]], [[10, 20], [10, 40]]);
}

#[test]
fn the_words_say_where_the_frame_is_in_the_original_and_how_fast_it_is() {
    let told = |gallery: &mut Gallery| words(&scenes(gallery)[1]);
    let mut whole = pair(10, 20);
    whole.go_to(1, 7);
    assert!(told(&mut whole).contains("= frame 3.50 of the original, 2× slower"), "{}", told(&mut whole));
    let mut half = pair(10, 5);
    half.go_to(0, 8);
    let text = told(&mut half);
    assert!(text.contains("frame 4 / 5") && text.contains("8.00 of the original, 2× faster"), "{text}");
    half.act(Action::Play);
    assert!(told(&mut half).contains("at the end"), "it waits");
    assert!(told(&mut pair(10, 10)).contains("of the original, as fast"));
    let mut stretch = Gallery::new(pair_of(TimeMap::stretch(41, (10, 16), 20).unwrap()));
    let text = told(&mut stretch);
    assert!(text.contains("3.33× slower between its frames 10 and 16"), "{text}");
    assert!(text.contains("walk.amc, frames 10–16: 6 → 20"), "{text}");
}

#[test]
fn motions_of_one_frame_and_none_are_told_and_survive_all_keys() {
    for (old, new) in [(1, 5), (5, 1), (1, 1), (0, 5), (2, 1)] {
        let mut gallery = pair(old, new);
        for action in [
            Action::Play,
            Action::Keyframes(1),
            Action::RangeStart,
            Action::RangeEnd,
            Action::Last,
            Action::Keyframes(-1),
            Action::Keyframes(10),
            Action::Step(1),
            Action::Reverse,
        ] {
            gallery.act(action);
            gallery.advance(0.25);
            assert!(!scenes(&mut gallery).is_empty());
        }
    }
    let none = words(&scenes(&mut pair(0, 5))[1]);
    assert!(none.contains("no frames to warp") && !none.contains("of the original"), "{none}");
    let one = words(&scenes(&mut pair(5, 1))[1]);
    assert!(
        one.contains("walk.amc, 5 → 1 frame\n") && one.contains("frame 0.00 of the original, 5× faster"),
        "{one}"
    );
}

/// The walk in the usual window and in smaller ones: the figure stays between the words above, the curve, and what is below.
#[test]
fn neither_words_nor_the_curve_cover_a_figure() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let source = Source { skeleton: Some(data.join("walk.asf")), ..Source::new(data.join("walk.amc")) };
    let original = source.read().unwrap().stage;
    let stretch = TimeMap::stretch(480, (100, 160), 200).unwrap();
    for (size, step) in
        [(SIZE, 9), ((900, 600), 9), ((640, 720), 29), ((640, 480), 29), ((640, 360), 29), ((480, 480), 29)]
    {
        for map in [TimeMap::Whole { old: 480, new: 700 }, stretch] {
            let warped = Arc::new(original.warped(map));
            let mut gallery = Gallery::new(vec![app(original.clone()), app(warped)]);
            let (width, height) = (0.5 * size.0 as f32, size.1 as f32);
            let fit = (width / 480.0).clamp(0.72, 1.0);
            for frame in (0..map.frame_count()).step_by(step) {
                gallery.go_to(1, frame);
                for scene in scenes_in(&mut gallery, size) {
                    let view = scene.camera.view((size.0 / 2, size.1));
                    // In the original's picture there is room for what i and k tell.
                    let words = (32.0 + 20.0 * scene.panels[0].lines().count() as f32).max(164.0) * fit;
                    // The curve is there where it has room, and the other figure stands as this one.
                    let has_curve = width > 440.0;
                    let curve = (width - 256.0 * fit, height - 298.0 * fit);
                    for dot in &scene.figures[0].joints {
                        let spot = view.project(dot.place).unwrap();
                        let told = format!("{size:?}, {frame}: {spot:?}");
                        assert!(spot.y > words && spot.y < height - 60.0 * fit, "{told}");
                        assert!(spot.x > 8.0 && spot.x < width - 8.0, "{told}");
                        assert!(!has_curve || spot.x < curve.0 || spot.y < curve.1, "{told}");
                    }
                }
            }
        }
    }
}

#[test]
fn of_the_help_each_shows_a_half() {
    let mut gallery = pair(10, 20);
    gallery.act(Action::Help);
    let scenes = scenes(&mut gallery);
    let keys = |scene: &Scene| {
        let lines = scene.panels.iter().flat_map(|panel| panel.lines());
        lines
            .filter(|(line, _)| matches!(line, Line::Key(_)))
            .map(|(_, text)| text.to_owned())
            .collect::<Vec<_>>()
    };
    let all: Vec<String> = scenes.iter().flat_map(keys).collect();
    let expected: Vec<&str> = crate::window::keys::help().map(|(_, help)| help).collect();
    assert_eq!(all, expected);
}
