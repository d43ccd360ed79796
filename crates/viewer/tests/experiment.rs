//! The curves and the tables of the book's experiment are those that the viewer makes now: `cargo pictures` makes them again.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use reduction::Errors;
use skeleton::Representation;
use viewer::output::edit::experiment::{CHAPTER, Experiment, place_of};

/// Numbers may differ by this part of them, or by one in their last digit: sines differ a little between systems.
const PART: f64 = 0.005;

/// What greedy does on a long motion depends on last bits, as the chapter says: the part by which its results may differ.
const CHANCE: f64 = 0.12;

/// Points of curves may be this far from the other curve, in the picture's own unit: it is 1600 wide.
const DISTANCE: f64 = 4.0;

/// The same where it depends on last bits.
const DISTANCE_BY_CHANCE: f64 = 80.0;

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn experiment() -> Experiment {
    Experiment::new(&workspace().join("data")).unwrap()
}

#[test]
fn the_tables_are_up_to_date() {
    let chapter = fs::read_to_string(workspace().join("docs").join(CHAPTER)).unwrap();
    for (place, table) in experiment().tables(false) {
        let then = &chapter[place_of(&chapter, place).unwrap_or_else(|| panic!("no place for {place}"))];
        // What takes long is not made again.
        let (slow, then): (Vec<&str>, Vec<&str>) =
            then.lines().partition(|line| line.starts_with("| optimum |") && !table.contains("| optimum |"));
        if place == "falls" {
            assert_falls(&then);
            continue;
        }
        let problem = difference(&table, &(then.join("\n") + "\n"), place.starts_with("running"));
        assert!(
            problem.is_none(),
            "{place}: {}: run `cargo pictures`. Now it is:\n{table}",
            problem.unwrap()
        );
        for optimum in slow {
            let moved = then.iter().find(|line| line.starts_with("| greedy, then moved")).unwrap();
            let better = cells(optimum).into_iter().zip(cells(moved)).skip(1);
            assert!(better.into_iter().all(|(a, b)| value(&a) <= value(&b)), "{optimum}\n{moved}");
        }
    }
}

/// Which removals lower the error on a long motion depends on last bits. Those in the book do.
fn assert_falls(rows: &[&str]) {
    let motion = parser::bvh::read_file(workspace().join("data").join("running.bvh")).unwrap().motion;
    let frames: Vec<_> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    let errors =
        Representation::ALL.map(|representation| Errors::new(motion.skeleton(), &frames, representation));
    assert!(rows.len() > 2);
    for row in &rows[2..] {
        let cells = cells(&row.replace(" and ", " | "));
        let errors =
            errors.iter().find(|errors| errors.clip().representation().to_string() == cells[1]).unwrap();
        let [removed, before, after] = [2, 3, 4].map(|at| cells[at].parse::<usize>().unwrap());
        let gaps = [(before, removed), (removed, after), (before, after)];
        let found = gaps.map(|(start, end)| errors.of_gap(start, end));
        for (found, cell) in found.iter().zip(&cells[5..]) {
            assert!(is_same(&format!("{found:.0}"), cell, PART), "{row}: {found}");
        }
        assert!(found[2] < found[0] + found[1], "{row}");
    }
}

/// What differs between two tables. Rows of greedy choices may be a matter `of_chance`.
fn difference(now: &str, then: &str, of_chance: bool) -> Option<String> {
    let (now, then): (Vec<&str>, Vec<&str>) = (now.lines().collect(), then.lines().collect());
    if now.len() != then.len() {
        return Some(format!("{} lines, there were {}", now.len(), then.len()));
    }
    let differs = |(now, then): &(&str, &str)| {
        let by_chance = of_chance && now.starts_with("| greedy") || now.starts_with("| `running.bvh` |");
        let part = if by_chance { CHANCE } else { PART };
        let (now, then) = (cells(now), cells(then));
        now.len() != then.len() || now.iter().zip(&then).any(|(now, then)| !is_same(now, then, part))
    };
    now.into_iter().zip(then).find(differs).map(|(now, then)| format!("{now:?} was {then:?}"))
}

fn cells(line: &str) -> Vec<String> {
    // A cell with two numbers counts as two.
    line.replace(" + ", " | ").split('|').map(|cell| cell.trim().to_owned()).collect()
}

fn is_same(now: &str, then: &str, part: f64) -> bool {
    let decimals =
        now.split_once('.').map_or(0, |(_, digits)| digits.trim_end_matches([' ', '%', '°']).len());
    let last_digit = 1.01 * 0.1_f64.powi(decimals as i32);
    match (value(now), value(then)) {
        (Some(a), Some(b)) => (a - b).abs() <= last_digit.max(part * a.abs()),
        _ => now == then,
    }
}

/// The number in a cell, if it is one.
fn value(cell: &str) -> Option<f64> {
    cell.trim_end_matches([' ', '%', '°']).replace(',', "").replace('−', "-").parse().ok()
}

#[test]
fn the_pictures_are_up_to_date_and_there_are_no_others() {
    let folder = workspace().join("docs").join("pictures");
    let pictures = experiment().pictures().unwrap();
    for (name, now) in &pictures {
        let then = fs::read_to_string(folder.join(name)).unwrap().replace("\r\n", "\n");
        assert!(texts(now) == texts(&then), "{name}: its texts have changed: run `cargo pictures`");
        let off = distance(&lines(now), &lines(&then));
        let most = if name.starts_with("running") { DISTANCE_BY_CHANCE } else { DISTANCE };
        assert!(off <= most, "{name}: a line is off by {off}: run `cargo pictures`");
    }
    let files = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut files: Vec<String> = files.filter(|name| name.ends_with(".svg")).collect();
    files.sort();
    assert_eq!(files, pictures.into_iter().map(|(name, _)| name).collect::<Vec<_>>());
}

/// What stands in a picture.
fn texts(svg: &str) -> Vec<&str> {
    let parts = svg.split("<text ").skip(1);
    parts.map(|part| part.split_once('>').unwrap().1.split_once("</text>").unwrap().0.trim()).collect()
}

/// The points of all lines of a colour, one after the other.
fn lines(svg: &str) -> BTreeMap<&str, Vec<(f64, f64)>> {
    let attribute = |tag: &'static str, part: &str| {
        let at = part.find(tag).unwrap() + tag.len();
        at..at + part[at..].find('"').unwrap()
    };
    let mut lines: BTreeMap<&str, Vec<(f64, f64)>> = BTreeMap::new();
    for part in svg.split("<polyline ").skip(1) {
        let color = &part[attribute(" stroke=\"", part)];
        let points = part[attribute("points=\"", part)].split_whitespace().map(|point| {
            let (x, y) = point.split_once(',').unwrap();
            (x.parse().unwrap(), y.parse().unwrap())
        });
        lines.entry(color).or_default().extend(points);
    }
    lines
}

/// How far a point is from the other picture's line of its colour, at most.
fn distance(now: &BTreeMap<&str, Vec<(f64, f64)>>, then: &BTreeMap<&str, Vec<(f64, f64)>>) -> f64 {
    assert_eq!(now.keys().collect::<Vec<_>>(), then.keys().collect::<Vec<_>>());
    let from = |points: &[(f64, f64)], line: &[(f64, f64)]| {
        let nearest = |point: &(f64, f64)| {
            line.windows(2).map(|ends| to_segment(*point, ends[0], ends[1])).fold(f64::INFINITY, f64::min)
        };
        points.iter().map(nearest).fold(0.0, f64::max)
    };
    let colors = now.iter().map(|(color, points)| from(points, &then[color]).max(from(&then[color], points)));
    colors.fold(0.0, f64::max)
}

fn to_segment(point: (f64, f64), start: (f64, f64), end: (f64, f64)) -> f64 {
    let (along, to) = ((end.0 - start.0, end.1 - start.1), (point.0 - start.0, point.1 - start.1));
    let length = along.0.powi(2) + along.1.powi(2);
    let share = if length > 0.0 { ((to.0 * along.0 + to.1 * along.1) / length).clamp(0.0, 1.0) } else { 0.0 };
    f64::hypot(to.0 - share * along.0, to.1 - share * along.1)
}

#[test]
fn the_comparison_sees_changes_and_no_last_bits() {
    let same = |now, then| is_same(now, then, PART);
    assert!(
        same("14,995", "14,990") && same("−6.5 %", "−6.4 %") && same("3.90", "3.91") && same("31°", "30°")
    );
    assert!(!same("14,995", "14,808") && !same("−6.5 %", "+6.5 %") && !same("3.90", "3.87"));
    assert!(!same("0.0 %", "0.2 %") && !same("greedy", "evenly spaced") && !same("12", "many"));
    let table = "| greedy | 100 + 200 |\n";
    assert_eq!(difference(table, table, false), None);
    assert!(difference(table, "", true).is_some());
    let other = "| greedy | 100 + 210 |\n";
    assert!(difference(table, other, false).is_some() && difference(table, other, true).is_none());

    let (name, svg) = experiment().pictures().unwrap().remove(0);
    assert_eq!(distance(&lines(&svg), &lines(&svg)), 0.0, "{name}");
    let solid = "stroke=\"#D55E00\" stroke-width=\"4\" points=\"";
    let at = svg.find(solid).unwrap() + solid.len();
    let changed = format!("{}0,0 {}", &svg[..at], &svg[at..]);
    assert!(distance(&lines(&svg), &lines(&changed)) > DISTANCE);
}
