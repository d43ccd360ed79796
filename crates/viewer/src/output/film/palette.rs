//! The few colours that stand for many.
//!
//! All colours of some pictures are counted, in boxes of 4 × 4 × 4 colours. The set of boxes is cut in two where that
//! leaves the least variance, then the worst of the parts, and so on (Wu, "Efficient statistical computations for
//! optimal color quantization", Graphics Gems II, 1991). At last each part is moved to the middle of what is nearest to it
//! (Lloyd, "Least squares quantization in PCM", 1982).

use crate::draw::canvas::Color;

/// The most colours of a palette: one index is needed for pixels that stay as they were.
pub(super) const MOST: usize = 255;

/// How often the colours are moved to the middle of what is nearest to them.
const ROUNDS: usize = 4;

/// How much a difference in red, green or blue counts.
pub(super) const WEIGHTS: [i32; 3] = [2, 4, 3];

/// How often colours occur.
pub(super) struct Census {
    boxes: Vec<Count>,
}

#[derive(Clone, Copy, Default)]
struct Count {
    pixels: u64,
    /// Of red, green and blue.
    sums: [u64; 3],
}

impl Census {
    pub fn new() -> Census {
        Census { boxes: vec![Count::default(); 1 << 18] }
    }

    /// Adds the colours of one picture.
    pub fn count(&mut self, pixels: &[u32]) {
        for run in pixels.chunk_by(|a, b| a == b) {
            let channels = Color(run[0]).channels();
            let at = channels.iter().fold(0, |at, channel| at << 6 | usize::from(channel >> 2));
            let count = &mut self.boxes[at];
            count.pixels += run.len() as u64;
            for (sum, channel) in count.sums.iter_mut().zip(channels) {
                *sum += u64::from(channel) * run.len() as u64;
            }
        }
    }
}

/// The mean colour of a box.
#[derive(Clone, Copy)]
struct Point {
    /// Red, green and blue, stretched by how much each counts.
    at: [f32; 3],
    weight: f32,
}

/// At most [`MOST`] colours for what was counted, and at least one.
pub(super) fn choose(census: Census) -> Vec<[u8; 3]> {
    let stretch = WEIGHTS.map(|weight| (weight as f32).sqrt());
    let filled = census.boxes.iter().filter(|count| count.pixels > 0);
    let mut points: Vec<Point> = filled
        .map(|count| {
            let mean = |c: usize| stretch[c] * (count.sums[c] as f64 / count.pixels as f64) as f32;
            // The root: joints and axes are small, but what one looks at.
            Point { at: [mean(0), mean(1), mean(2)], weight: (count.pixels as f32).sqrt() }
        })
        .collect();
    let mut centres = split(&mut points);
    for _ in 0..ROUNDS {
        settle(&points, &mut centres);
    }
    let channel = |centre: &[f32; 3], c: usize| (centre[c] / stretch[c]).round() as u8;
    let mut colors: Vec<[u8; 3]> = centres.iter().map(|at| [0, 1, 2].map(|c| channel(at, c))).collect();
    colors.sort_unstable();
    colors.dedup();
    if colors.is_empty() { vec![[0; 3]] } else { colors }
}

/// The means of the parts into which the points are cut.
fn split(points: &mut [Point]) -> Vec<[f32; 3]> {
    let mut parts: Vec<(Spread, &mut [Point])> = vec![(Spread::of(points), points)];
    while parts.len() < MOST {
        let worst = (0..parts.len()).max_by(|a, b| parts[*a].0.total().total_cmp(&parts[*b].0.total()));
        let Some(worst) = worst.filter(|worst| parts[*worst].1.len() > 1) else { break };
        let (spread, points) = parts.swap_remove(worst);
        let axis = spread.widest();
        points.sort_unstable_by(|a, b| a.at[axis].total_cmp(&b.at[axis]));
        let (low, high) = points.split_at_mut(best_cut(points, axis));
        parts.push((Spread::of(low), low));
        parts.push((Spread::of(high), high));
    }
    parts.iter().filter(|(spread, _)| spread.weight > 0.0).map(|(spread, _)| spread.mean()).collect()
}

/// Where a sorted list of at least two points falls into two with the least variance along `axis`.
fn best_cut(points: &[Point], axis: usize) -> usize {
    let sum = |points: &[Point]| {
        points.iter().fold((0.0, 0.0), |(weight, sum), point| {
            let own = f64::from(point.weight);
            (weight + own, sum + own * f64::from(point.at[axis]))
        })
    };
    let (all, total) = sum(points);
    let (mut weight, mut part) = (0.0, 0.0);
    let mut best = (f64::NEG_INFINITY, 1);
    for (index, point) in points[..points.len() - 1].iter().enumerate() {
        weight += f64::from(point.weight);
        part += f64::from(point.weight) * f64::from(point.at[axis]);
        // What the variance within both parts is less by.
        let gain = part * part / weight + (total - part) * (total - part) / (all - weight);
        if gain > best.0 {
            best = (gain, index + 1);
        }
    }
    best.1
}

/// How much and how far apart some points are.
#[derive(Clone, Default)]
struct Spread {
    weight: f64,
    sums: [f64; 3],
    squares: [f64; 3],
}

impl Spread {
    fn of(points: &[Point]) -> Spread {
        let mut spread = Spread::default();
        points.iter().for_each(|point| spread.add(point));
        spread
    }

    fn add(&mut self, point: &Point) {
        let weight = f64::from(point.weight);
        self.weight += weight;
        for (c, at) in point.at.into_iter().map(f64::from).enumerate() {
            self.sums[c] += weight * at;
            self.squares[c] += weight * at * at;
        }
    }

    fn mean(&self) -> [f32; 3] {
        self.sums.map(|sum| (sum / self.weight) as f32)
    }

    /// The squared distance to the mean along one axis, of all points together.
    fn variance(&self, axis: usize) -> f64 {
        self.squares[axis] - self.sums[axis] * self.sums[axis] / self.weight.max(f64::MIN_POSITIVE)
    }

    fn total(&self) -> f64 {
        (0..3).map(|axis| self.variance(axis)).sum()
    }

    fn widest(&self) -> usize {
        (0..3).max_by(|a, b| self.variance(*a).total_cmp(&self.variance(*b))).unwrap_or(0)
    }
}

/// Moves each centre to the mean of the points to which it is nearest.
fn settle(points: &[Point], centres: &mut [[f32; 3]]) {
    let mut means = vec![Spread::default(); centres.len()];
    for point in points {
        let distance = |centre: &[f32; 3]| -> f32 { (0..3).map(|c| (centre[c] - point.at[c]).powi(2)).sum() };
        let mut nearest = (f32::INFINITY, 0);
        for (index, centre) in centres.iter().enumerate() {
            let distance = distance(centre);
            if distance < nearest.0 {
                nearest = (distance, index);
            }
        }
        means[nearest.1].add(point);
    }
    for (centre, mean) in centres.iter_mut().zip(means).filter(|(_, mean)| mean.weight > 0.0) {
        *centre = mean.mean();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(pixels: &[u32]) -> Vec<[u8; 3]> {
        let mut census = Census::new();
        census.count(pixels);
        choose(census)
    }

    #[test]
    fn few_colours_are_kept_as_they_are() {
        let colors = [0x00_00_00, 0x11_F0_08, 0x8A_2B_D8, 0xF4_F6_F7, 0xFF_FF_FF];
        let expected: Vec<[u8; 3]> = colors.iter().map(|color| Color(*color).channels()).collect();
        assert_eq!(chosen(&colors), expected);
        assert_eq!(chosen(&[]), [[0; 3]]);
    }

    #[test]
    fn many_colours_become_255_and_a_rare_one_is_not_lost() {
        // Three hundred thousand pixels of soft greys and blues, and one small square of purple.
        let mut pixels: Vec<u32> =
            (0..300_000u32).map(|i| (100 + i % 97) << 16 | (100 + i % 89) << 8 | 200).collect();
        pixels.extend([0x8A_2B_D8; 49]);
        let colors = chosen(&pixels);
        assert_eq!(colors.len(), MOST);
        let far = |color: &[u8; 3]| (0..3).map(|c| color[c].abs_diff([0x8A, 0x2B, 0xD8][c])).max();
        assert!(colors.iter().filter_map(far).min().unwrap() <= 2);
    }
}
