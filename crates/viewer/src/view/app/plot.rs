//! The plot of errors: how they grow with the number of interpolated frames. A warped motion has the curve of its warp instead.

use std::fmt::Write;

use skeleton::Representation;

use super::{App, Shown};
use crate::edit::{Edited, is_too_long};
use crate::live::student::Extra;
use crate::live::student::time_warp::places_step;
use crate::motion::time_map::{TimeMap, position_of};
use crate::scene::{Plot, Pool, Stroke, Tick};
use crate::view::answers::Answers;
use crate::view::texts::write_number;

/// The most points of a curve: more could not be told apart.
const MOST_POINTS: usize = 400;

/// The most steps from number to number on an axis.
const MOST_STEPS: f64 = 4.0;
const MOST_WHOLE_STEPS: f64 = 5.0;

/// The share of the height that stays free above the highest error.
const ABOVE: f64 = 0.06;

impl App {
    /// Makes `plot` that of the edited motion, or of the warped one, if it is wanted and there is anything to show.
    pub(super) fn fill_plot(&self, plot: &mut Option<Plot>, shown: Shown) {
        if let Some(map) = self.time_map() {
            match self.settings.curve && self.settings.words && map.frame_count() > 0 {
                true => self.fill_curve(plot.get_or_insert_with(Plot::default), &map, shown),
                false => *plot = None,
            }
            return;
        }
        let edited = self.editing().filter(|_| self.settings.edit.plot && self.settings.words);
        let Some(editing) = edited.filter(|editing| editing.failure.is_none()) else {
            *plot = None;
            return;
        };
        let plot = plot.get_or_insert_with(Plot::default);
        write(&mut plot.upwards, format_args!("accumulated error (units²)"));
        write(&mut plot.rightwards, format_args!("interpolated frames"));
        clear(plot);
        match &editing.edited {
            Some(edited) if edited.curves.is_some() => curves(plot, edited),
            _ if is_too_long(&self.stage, self.stage.moving_frames()) => {
                write(&mut plot.note, format_args!("the motion is too long for its curves"));
            }
            _ => match editing.progress {
                Some((done, of)) if of > 0 => {
                    write(&mut plot.note, format_args!("calculating… {} %", 100 * done.min(of) / of));
                }
                _ => write(&mut plot.note, format_args!("calculating…")),
            },
        }
    }

    /// The curve of the warp `map`, with the shown frame on it; and that of a student's part 1, where it has answered.
    fn fill_curve(&self, plot: &mut Plot, map: &TimeMap, shown: Shown) {
        write(&mut plot.upwards, format_args!("original frame"));
        write(&mut plot.rightwards, format_args!("new frame"));
        clear(plot);
        plot.small = true;
        let frame = self.frame();
        let (scale, now) = (Scale::of(map), (frame, map.position(frame)));
        places(plot, map, &scale, now);
        if let Shown::Student(answers) = shown {
            self.add_students(plot, map, &scale, answers);
        }
        let stretch = map.keyframes().into_iter().flatten();
        plot.posts.extend(stretch.map(|(_, new)| scale.right(new)));
    }
}

impl App {
    /// Adds the curve of a student's part 1, and moves the mark to it. The other one shows then how it should be.
    fn add_students(&self, plot: &mut Plot, map: &TimeMap, scale: &Scale, answers: &dyn Answers) {
        let at = |frame: usize| match answers.posed(frame)?.extra {
            Extra::Warp { place: Some(place), .. } => Some(scale.place((frame, position_of(place)))),
            _ => None,
        };
        let step = places_step(map);
        let points = (0..map.frame_count()).step_by(step).filter_map(at);
        // What is behind the original's end has no place in the plot.
        let mut points = points.take_while(|(_, old)| *old <= 1.0).peekable();
        if points.peek().is_none() {
            return;
        }
        if let Some(right) = plot.curves.items_mut().last_mut() {
            write(&mut right.name, format_args!("goal"));
            right.stroke = Stroke::Dashed;
        }
        add_curve(plot, "yours", Stroke::Solid, points);
        // Of a long motion not all places are asked for: the one before is less than a pixel away.
        if let Some(now) = at(self.frame() - self.frame() % step) {
            plot.mark = Some(now);
        }
    }
}

/// How much room new frames take to the right, and old ones upwards: as far as the longer of both motions goes, and the old one.
struct Scale {
    widest: f64,
    highest: f64,
}

impl Scale {
    fn of(map: &TimeMap) -> Scale {
        let (old, new) = (map.old_count(), map.frame_count());
        Scale { widest: last_of(old.max(new)), highest: last_of(old) }
    }

    fn right(&self, new: usize) -> f32 {
        (new as f64 / self.widest) as f32
    }

    /// The place of a new frame and of where it is in the old motion.
    fn place(&self, (new, old): (usize, f64)) -> (f32, f32) {
        (self.right(new), (old / self.highest) as f32)
    }
}

/// The curve of the warp `map` beside that of a motion that is as fast as before. `now` is the shown frame.
fn places(plot: &mut Plot, map: &TimeMap, scale: &Scale, now: (usize, f64)) {
    let (old, new) = (map.old_count(), map.frame_count());
    whole_ticks(&mut plot.columns, old.max(new), steps_beside(old.max(new)));
    whole_ticks(&mut plot.rows, old, MOST_WHOLE_STEPS);
    let straight = [(0, 0.0), (old.saturating_sub(1), old.saturating_sub(1) as f64)];
    let place = |point| scale.place(point);
    add_curve(plot, "original", Stroke::Faint, straight.into_iter().map(place));
    add_curve(plot, "warped", Stroke::Solid, map.corners().map(place));
    plot.mark = Some(place(now));
}

/// Adds a curve. Its memory is used again.
fn add_curve(plot: &mut Plot, name: &str, stroke: Stroke, points: impl Iterator<Item = (f32, f32)>) {
    let curve = plot.curves.add();
    write(&mut curve.name, format_args!("{name}"));
    curve.stroke = stroke;
    curve.points.clear();
    curve.points.extend(points);
}

/// The last of so many frames, as a number to divide by.
fn last_of(count: usize) -> f64 {
    positive(count.saturating_sub(1) as f64)
}

/// How many steps there may be between numbers that stand beside each other, up to `count`: fewer where they are long.
fn steps_beside(count: usize) -> f64 {
    let digits = count.max(1).ilog10() + 1;
    (24.0 / (f64::from(digits) + 1.4)).min(MOST_WHOLE_STEPS)
}

/// Round numbers of frames, at most so many `steps` apart, and the last one.
fn whole_ticks(ticks: &mut Pool<Tick>, count: usize, steps: f64) {
    let last = count.saturating_sub(1);
    let most = last_of(count);
    let step = round_step(most / steps).max(1.0) as usize;
    let mut add = |frame: usize| {
        let tick = ticks.add();
        tick.at = (frame as f64 / most) as f32;
        write(&mut tick.label, format_args!("{frame}"));
    };
    // Where the last one is near, there is no room for another number.
    let near = |frame: usize| (last - frame) as f64 * steps < 0.6 * most;
    (0..last).step_by(step).filter(|frame| !near(*frame)).for_each(&mut add);
    add(last);
}

/// Takes out what was in the plot.
fn clear(plot: &mut Plot) {
    plot.note.clear();
    plot.mark = None;
    plot.small = false;
    plot.columns.clear();
    plot.rows.clear();
    plot.posts.clear();
    plot.curves.clear();
}

fn stroke(representation: Representation) -> Stroke {
    match representation {
        Representation::Euler => Stroke::Solid,
        Representation::Quaternion => Stroke::Dashed,
    }
}

fn curves(plot: &mut Plot, edited: &Edited) {
    let Some(curves) = &edited.curves else { return };
    let errors = |representation: Representation| {
        let errors = curves.errors(representation);
        &errors[..errors.len().min(edited.interpolated + 1)]
    };
    let all = Representation::ALL.into_iter().flat_map(errors);
    let highest = all.copied().chain([edited.error]).filter(|error| error.is_finite()).fold(0.0, f64::max);
    let (widest, highest) = (edited.interpolated.max(1) as f64, positive(highest * (1.0 + ABOVE)));
    let place = |frames: usize, error: f64| ((frames as f64 / widest) as f32, (error / highest) as f32);
    ticks(&mut plot.columns, widest, 1.0);
    ticks(&mut plot.rows, highest, 0.0);
    for representation in Representation::ALL {
        let errors = errors(representation);
        let curve = plot.curves.add();
        write(&mut curve.name, format_args!("{}", representation.name()));
        curve.stroke = stroke(representation);
        curve.points.clear();
        let last = errors.len().saturating_sub(1);
        let step = errors.len().div_ceil(MOST_POINTS).max(1);
        let some = (0..last).step_by(step).chain([last]);
        curve.points.extend(some.filter_map(|frames| Some(place(frames, *errors.get(frames)?))));
    }
    plot.mark = Some(place(edited.interpolated, edited.error));
}

/// Round numbers from 0 up to `most`, at least `least` apart.
fn ticks(ticks: &mut Pool<Tick>, most: f64, least: f64) {
    let step = round_step(most / MOST_STEPS).max(least);
    let mut number = 0.0;
    // A few more than there should be, should a number be too large to grow by its step.
    for _ in 0..8 {
        let tick = ticks.add();
        tick.at = (number / most) as f32;
        tick.label.clear();
        write_number(&mut tick.label, number);
        number += step;
        if number > most {
            break;
        }
    }
}

/// The least of 1, 2 and 5 times a power of ten that is not below `number`.
fn round_step(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power);
    steps.into_iter().find(|step| *step >= number * 0.9999).unwrap_or(10.0 * power)
}

/// The same number, or 1 where it is none to divide by.
fn positive(number: f64) -> f64 {
    if number.is_normal() && number > 0.0 { number } else { 1.0 }
}

fn write(text: &mut String, words: std::fmt::Arguments) {
    text.clear();
    // A string takes whatever is written to it.
    let _ = text.write_fmt(words);
}
