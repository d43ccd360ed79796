//! A picture with everything in it.

use std::path::Path;

use viewer::motion::stage::Stage;
use viewer::scene::{Corner, Line, Look, Off, ScaleBar, Scene, Style, Timeline, Tint};

/// How many frames a trail goes back.
const TRAIL: usize = 120;

/// The runner on a stage.
pub fn stage() -> Stage {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/running.bvh");
    let motion = parser::bvh::read_file(path).unwrap().motion;
    Stage::new(motion, skeleton::PositionChannels::Replace)
}

/// The runner with a goal a little ahead of it, axes, squares, trails of all End Sites, texts, timeline and ruler.
pub fn everything(stage: &Stage, frame: usize, style: Style, size: (usize, usize)) -> Scene {
    let mut scene = Scene {
        camera: stage.camera(stage.anchor(frame), &[], size),
        ground: stage.ground(),
        style,
        size: stage.size(),
        text_scale: 1.0,
        timeline: Some(Timeline { frame, count: stage.frame_count(), range: (100, 900), playing: true }),
        scale_bar: Some(ScaleBar { length: 50.0, label: "50 units".into() }),
        ..Scene::default()
    };
    *scene.figures.add() = stage.figure(&stage.reference(frame + 6), Look::Ghost, false);
    let mut figure = stage.figure(&stage.reference(frame), Look::Solid, true);
    figure.joints[3].off = Off::Some;
    figure.joints[4].selected = true;
    *scene.figures.add() = figure;

    let ends = stage.motion().skeleton().joints().iter().filter(|joint| joint.is_end_site);
    for (index, end) in ends.enumerate() {
        let trail = scene.trails.add();
        trail.index = index;
        let frames = frame.saturating_sub(TRAIL - 1)..=frame;
        trail.points.extend(frames.map(|frame| stage.reference(frame)[end.id].position));
    }
    let panel = scene.panels.add();
    panel.begin(Corner::TopLeft);
    panel.add(Line::Heading, "running.bvh");
    panel.add(Line::Text, format_args!("frame {frame} / {}", stage.frame_count()));
    panel.add(
        Line::Trouble,
        "part 1 takes 42 angles of this frame, which holds 69: each joint takes its own three",
    );
    for key in ["w", "Space", "Home", "f", "g", "a", "h", "t", "Esc"] {
        panel.add(Line::Key(key), "does something to the figure or to what is to be seen of it");
    }
    let legend = scene.panels.add();
    legend.begin(Corner::BottomLeft);
    for tint in [Tint::Joint, Tint::Off(Off::Little), Tint::Off(Off::Some), Tint::Off(Off::Much), Tint::Ghost]
    {
        legend.add(Line::Legend(tint), "what this colour stands for");
    }
    scene
}
