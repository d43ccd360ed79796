//! Figures in both styles: squares, hiding, the goal, and numbers that are none.

use super::*;
use crate::camera::View;
use crate::draw::canvas::Color;
use crate::scene::Off;

const SIZE: (usize, usize) = (320, 240);
const STYLES: [Style; 2] = [Style::Lit, Style::Lines];

/// Numbers from 0 to 1 that look like chance and are always the same.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1u64 << 24) as f32
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.roll()
    }

    fn place(&mut self) -> Vec3 {
        Vec3::from([0; 3].map(|_| self.between(-1.0, 1.0)))
    }
}

fn bone(from: Vec3, to: Vec3, side: Side) -> Bone {
    Bone { from, to, side, radius: 0.3, joints: (0, 1) }
}

fn bones(bones: Vec<Bone>) -> Figure {
    Figure { bones, ..figure(Vec::new()) }
}

/// A limp chain of three bones, its size about that of the scene.
fn chain(dice: &mut Dice) -> Vec<Bone> {
    let places: Vec<Vec3> = (0..4).map(|_| dice.place()).collect();
    let sides = [Side::Left, Side::Right, Side::Middle];
    places.windows(2).zip(sides).map(|(ends, side)| bone(ends[0], ends[1], side)).collect()
}

fn drawn(scene: &Scene) -> Canvas {
    let mut canvas = Canvas::new(SIZE.0, SIZE.1);
    draw(scene, &mut canvas);
    canvas
}

fn picture(style: Style, figures: Vec<Figure>) -> Canvas {
    drawn(&Scene { style, ..scene(figures) })
}

/// The purple pixels: how many, and their middle.
fn purple(canvas: &Canvas) -> (usize, f32, f32) {
    let pixels = canvas.pixels().iter().enumerate().filter(|(_, pixel)| **pixel == color_of(Tint::Joint).0);
    let (mut count, mut x, mut y) = (0, 0.0, 0.0);
    for (index, _) in pixels {
        (count, x, y) = (count + 1, x + (index % SIZE.0) as f32 + 0.5, y + (index / SIZE.0) as f32 + 0.5);
    }
    (count, x / count.max(1) as f32, y / count.max(1) as f32)
}

fn differ(a: u32, b: u32, by: u8) -> bool {
    Color(a).channels().iter().zip(Color(b).channels()).any(|(a, b)| a.abs_diff(b) > by)
}

/// Which pixels of two pictures differ.
fn changes(a: &Canvas, b: &Canvas, by: u8) -> Vec<(i32, i32)> {
    let pairs = a.pixels().iter().zip(b.pixels()).enumerate();
    let changed = pairs.filter(|(_, (a, b))| differ(**a, **b, by));
    changed.map(|(index, _)| ((index % SIZE.0) as i32, (index / SIZE.0) as i32)).collect()
}

/// The angle's sine between the line of sight to `place` and a bone.
fn sine(bone: &Bone, place: Vec3, view: &View) -> f32 {
    let (sight, along) = ((place - view.eye).normalize(), (bone.to - bone.from).normalize());
    sight.cross(along).length()
}

#[test]
fn the_square_of_a_joint_lies_at_its_projection_upon_its_own_bone() {
    let mut dice = Dice(1);
    let mut tried = 0;
    while tried < 100 {
        let bone = bone(dice.place(), dice.place(), Side::Left);
        let mut scene = scene(vec![Figure { bones: vec![bone], ..figure(vec![bone.to]) }]);
        (scene.camera.azimuth, scene.camera.elevation) = (dice.between(0.0, 6.0), dice.between(-1.4, 1.4));
        let view = scene.camera.view(SIZE);
        // Looked at along the bone, the joint is behind all of it.
        if sine(&bone, bone.to, &view) < 0.4 || bone.from.distance(bone.to) < 0.3 {
            continue;
        }
        tried += 1;
        for style in STYLES {
            scene.style = style;
            let ((count, x, y), spot) = (purple(&drawn(&scene)), view.project(bone.to).unwrap());
            assert!(count >= 4, "{style:?}: no square on {bone:?} from {:?}", scene.camera);
            assert!((x - spot.x).abs() <= 0.75 && (y - spot.y).abs() <= 0.75, "{style:?}: {x} {y} {spot:?}");
        }
    }
}

#[test]
fn in_any_pose_squares_that_are_not_hidden_lie_at_their_projections() {
    let mut dice = Dice(2);
    for style in STYLES {
        let mut seen = 0;
        for _ in 0..100 {
            let bones = chain(&mut dice);
            let joint = bones[1].from;
            let mut scene = Scene { style, ..scene(vec![Figure { bones, ..figure(vec![joint]) }]) };
            scene.camera.azimuth = dice.between(0.0, 6.0);
            let alone = Scene { figures: [figure(vec![joint])].into_iter().collect(), ..scene.clone() };
            let ((all, ..), (count, x, y)) = (purple(&drawn(&alone)), purple(&drawn(&scene)));
            // A square that is hidden in part has its middle elsewhere.
            if count == all {
                let spot = scene.camera.view(SIZE).project(joint).unwrap();
                assert!(
                    (x - spot.x).abs() <= 0.75 && (y - spot.y).abs() <= 0.75,
                    "{style:?}: {x} {y} {spot:?}"
                );
                seen += 1;
            }
        }
        assert!(seen > 60, "{style:?}: only {seen} of 100 squares were seen");
    }
}

#[test]
fn near_bones_hide_far_ones_and_their_joints() {
    let level = |z: f32, side| bone(Vec3::new(-1.0, 0.0, z), Vec3::new(1.0, 0.0, z), side);
    for style in STYLES {
        let front = |figures: Vec<Figure>| {
            let mut scene = Scene { style, ..scene(figures) };
            (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
            drawn(&scene)
        };
        let (near, far) = (level(1.0, Side::Left), level(-1.0, Side::Right));
        let behind = Figure { bones: vec![far], ..figure(vec![Vec3::new(0.0, 0.0, -1.0)]) };
        let alone = front(vec![bones(vec![near])]);
        for figures in [vec![bones(vec![near]), behind.clone()], vec![behind.clone(), bones(vec![near])]] {
            let both = front(figures);
            assert!(
                !differ(both.pixel(160, 120).unwrap().0, alone.pixel(160, 120).unwrap().0, 40),
                "{style:?}"
            );
        }
        if style == Style::Lit {
            assert_eq!(purple(&front(vec![bones(vec![near]), behind.clone()])).0, 0, "the square is hidden");
        }
        assert!(purple(&front(vec![behind])).0 > 0, "it is there when nothing hides it");
    }
}

#[test]
fn the_goal_lies_within_a_figure_in_the_same_pose() {
    let mut dice = Dice(3);
    for round in 0..20 {
        let mut pose = chain(&mut dice);
        if round % 2 == 1 {
            pose.iter_mut().for_each(|bone| bone.radius = 0.06);
        }
        let ghost = Figure { look: Look::Ghost, ..bones(pose.clone()) };
        let solid = bones(pose);
        let empty = picture(Style::Lines, Vec::new());
        let outline = changes(&picture(Style::Lines, vec![solid.clone()]), &empty, 8);
        for (x, y) in changes(&picture(Style::Lines, vec![ghost.clone()]), &empty, 8) {
            let near = |(a, b): &(i32, i32)| (a - x).abs() <= 2 && (b - y).abs() <= 2;
            assert!(outline.iter().any(near), "({x}, {y}) of the goal is beside the figure");
        }
        let alone = picture(Style::Lit, vec![solid.clone()]);
        let body = changes(&alone, &picture(Style::Lit, Vec::new()), 8).len();
        let shown = changes(&picture(Style::Lit, vec![ghost, solid]), &alone, 24).len();
        assert!(shown * 50 < body, "{shown} pixels of the goal are seen upon {body} of the figure");
    }
}

#[test]
fn the_goal_is_seen_where_nothing_hides_it() {
    let mut dice = Dice(4);
    for style in STYLES {
        let ghost = Figure { look: Look::Ghost, ..bones(chain(&mut dice)) };
        let seen = changes(&picture(style, vec![ghost]), &picture(style, Vec::new()), 40).len();
        assert!(seen > 300, "{style:?}: {seen}");
    }
}

#[test]
fn what_is_no_number_changes_nothing_else() {
    let mut dice = Dice(5);
    let good = Figure { bones: chain(&mut dice), ..figure(vec![Vec3::ZERO]) };
    for style in STYLES {
        for odd in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let mut bad = good.clone();
            let place = Vec3::new(0.3, odd, 0.1);
            bad.bones.push(bone(place, Vec3::ZERO, Side::Left));
            bad.bones.push(bone(Vec3::ONE, place, Side::Left));
            bad.joints.push(place.into());
            bad.axes.push(Axes { origin: place, rotation: Quat::IDENTITY, length: 0.5, lettered: true });
            let mut scene = Scene { style, ..scene(vec![bad]) };
            scene.trails.add().points.extend([place, place]);
            assert!(drawn(&scene).pixels() == picture(style, vec![good.clone()]).pixels(), "{style:?} {odd}");
            if style == Style::Lit {
                let mut bad = good.clone();
                bad.bones.push(Bone { radius: odd, ..bone(Vec3::ZERO, Vec3::X, Side::Left) });
                assert!(
                    picture(style, vec![bad]).pixels() == picture(style, vec![good.clone()]).pixels(),
                    "{odd}"
                );
            }
        }
    }
}

#[test]
fn what_is_not_up_to_date_is_paler() {
    let colorful = |canvas: &Canvas| {
        let spread = |pixel: &u32| {
            let channels = Color(*pixel).channels();
            u64::from(channels.iter().max().unwrap() - channels.iter().min().unwrap())
        };
        canvas.pixels().iter().map(spread).sum::<u64>()
    };
    let mut dice = Dice(6);
    for style in STYLES {
        let solid = Figure { bones: chain(&mut dice), ..figure(vec![Vec3::ZERO]) };
        let dimmed = Figure { look: Look::Dimmed, ..solid.clone() };
        let [empty, dimmed, solid] =
            [vec![], vec![dimmed], vec![solid]].map(|figures| colorful(&picture(style, figures)));
        let (dimmed, solid) = (dimmed.saturating_sub(empty), solid - empty);
        assert!(dimmed > 0 && dimmed * 2 < solid, "{style:?}: {dimmed} {solid}");
    }
}

#[test]
fn a_joint_that_is_off_is_larger_and_the_selected_one_has_a_frame() {
    let painted = |off, selected| {
        let mut figure = figure(vec![Vec3::ZERO]);
        (figure.joints[0].off, figure.joints[0].selected) = (off, selected);
        drawn(&Scene { text_scale: 2.0, ..scene(vec![figure]) })
    };
    let empty = picture(Style::Lit, Vec::new());
    let sizes = [Off::Right, Off::Little, Off::Some, Off::Much]
        .map(|off| changes(&painted(off, false), &empty, 8).len());
    assert!(sizes.is_sorted_by(|a, b| a < b), "{sizes:?}");
    let white = |canvas: Canvas| canvas.pixels().iter().filter(|pixel| **pixel == Color::WHITE.0).count();
    assert!(white(painted(Off::Right, true)) > 40 && white(painted(Off::Right, false)) == 0);
}

#[test]
fn a_figure_may_have_thousands_of_bones() {
    let mut dice = Dice(7);
    for style in STYLES {
        let places: Vec<Vec3> = (0..3001).map(|_| dice.place() - Vec3::Y).collect();
        let mut many = figure(places.clone());
        many.bones = (0..3000)
            .map(|i| Bone { radius: 0.01, joints: (i, i + 1), ..bone(places[i], places[i + 1], Side::Left) })
            .collect();
        // One that stands apart from all others.
        let (low, high) = (Vec3::new(0.0, 0.5, 0.0), Vec3::new(0.0, 1.2, 0.0));
        many.joints.push(high.into());
        many.bones.push(Bone { joints: (0, 3001), ..bone(low, high, Side::Right) });
        many.joints.iter_mut().take(3001).for_each(|joint| joint.off = Off::Some);
        let scene = Scene { style, ..scene(vec![many]) };
        let ((count, x, y), spot) = (purple(&drawn(&scene)), scene.camera.view(SIZE).project(high).unwrap());
        assert!(count >= 4 && (x - spot.x).abs() <= 0.75 && (y - spot.y).abs() <= 0.75, "{style:?} {count}");
    }
}

#[test]
fn a_body_may_reach_into_the_camera() {
    let mut scene = Scene { style: Style::Lit, ..scene(Vec::new()) };
    let eye = scene.camera.view(SIZE).eye;
    for to in [eye, eye * 2.0, eye + Vec3::Y * 0.05] {
        *scene.figures.add() = bones(vec![bone(Vec3::ZERO, to, Side::Left)]);
        let body = changes(&drawn(&scene), &picture(Style::Lit, Vec::new()), 8).len();
        assert!(body > 100, "{body} pixels of {to}");
        scene.figures.clear();
    }
}
