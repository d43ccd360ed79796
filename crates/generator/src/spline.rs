//! A smooth curve through given points.

/// A cubic spline: through every point, with continuous speed and acceleration, and with a given speed at each end.
#[derive(Clone, Debug)]
pub struct Spline {
    times: Vec<f64>,
    values: Vec<f64>,
    speeds: Vec<f64>,
}

impl Spline {
    /// A curve through `points`, each (time, value), in the order of their times, at least two of them. `ends` are
    /// the speeds at the first and the last point, in the value's unit per unit of time.
    ///
    /// The speeds between follow from the demand that the acceleration be continuous, which is a system of
    /// equations with three entries a row (de Boor 1978, "A Practical Guide to Splines", chapter IV).
    pub fn clamped(points: &[(f64, f64)], ends: [f64; 2]) -> Spline {
        let (times, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        let last = points.len() - 1;
        let gap = |i: usize| times[i + 1] - times[i];
        let slope = |i: usize| (values[i + 1] - values[i]) / gap(i);
        // Row i: speed[i] + factor[i] · speed[i + 1] = right[i], once the entries left of the diagonal are gone.
        let mut factor = vec![0.0; last + 1];
        let mut right = vec![ends[0]; last + 1];
        for i in 1..last {
            let (before, after) = (gap(i - 1), gap(i));
            let diagonal = 2.0 * (before + after) - after * factor[i - 1];
            factor[i] = before / diagonal;
            right[i] = (3.0 * (after * slope(i - 1) + before * slope(i)) - after * right[i - 1]) / diagonal;
        }
        let mut speeds = right;
        speeds[last] = ends[1];
        for i in (1..last).rev() {
            speeds[i] -= factor[i] * speeds[i + 1];
        }
        Spline { times, values, speeds }
    }

    /// A curve that has these `values` at these `times`, at least two of them, and never leaves the range between
    /// two neighbours: it rests at both ends and wherever the values turn, and holds a value given twice. Its
    /// acceleration may leap.
    ///
    /// The speed at a point is the harmonic mean of the slopes on both sides, or zero if they differ in sign
    /// (Fritsch and Butland 1984, "A method for constructing local monotone piecewise cubic interpolants").
    pub fn held<const N: usize>(times: &[f64; N], values: &[f64; N]) -> Spline {
        let slope = |i: usize| (values[i + 1] - values[i]) / (times[i + 1] - times[i]);
        let mut speeds = vec![0.0; N];
        for (i, speed) in speeds.iter_mut().enumerate().take(N - 1).skip(1) {
            let (before, after) = (slope(i - 1), slope(i));
            if before * after > 0.0 {
                *speed = 2.0 * before * after / (before + after);
            }
        }
        Spline { times: times.to_vec(), values: values.to_vec(), speeds }
    }

    /// The value at `time`; before the first point that of the first, behind the last that of the last.
    pub fn at(&self, time: f64) -> f64 {
        let last = self.times.len() - 1;
        let time = time.clamp(self.times[0], self.times[last]);
        let i = self.times[1..last].partition_point(|&t| t <= time);
        let gap = self.times[i + 1] - self.times[i];
        let t = (time - self.times[i]) / gap;
        let (a, b) = (self.values[i], self.values[i + 1]);
        let (speed_a, speed_b) = (self.speeds[i] * gap, self.speeds[i + 1] * gap);
        // The cubic Hermite polynomial: values and speeds at both ends.
        let (c, d) = (3.0 * (b - a) - 2.0 * speed_a - speed_b, 2.0 * (a - b) + speed_a + speed_b);
        a + t * (speed_a + t * (c + t * d))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<(f64, f64)>> {
        prop::collection::vec((0.05..1.0, -100.0..100.0), 2..8).prop_map(|steps| {
            let mut time = 0.0;
            steps
                .into_iter()
                .map(|(gap, value)| {
                    time += gap;
                    (time, value)
                })
                .collect()
        })
    }

    proptest! {
        #[test]
        fn a_clamped_curve_meets_its_points_with_the_speeds_asked_for(
            points in points(), start in -50.0..50.0, end in -50.0..50.0,
        ) {
            let curve = Spline::clamped(&points, [start, end]);
            for (time, value) in &points {
                prop_assert!((curve.at(*time) - value).abs() < 1e-9);
            }
            let (first, last) = (points[0].0, points[points.len() - 1].0);
            let small = 1e-6;
            prop_assert!(((curve.at(first + small) - curve.at(first)) / small - start).abs() < 0.5);
            prop_assert!(((curve.at(last) - curve.at(last - small)) / small - end).abs() < 0.5);
        }

        #[test]
        fn a_clamped_curve_has_no_kink_and_no_leap_of_acceleration(points in points()) {
            let curve = Spline::clamped(&points, [0.0, 0.0]);
            // Extrapolates three values, as far apart as `step`, to the point itself: twice, from both sides.
            let step = 1e-3;
            for (time, _) in &points[1..points.len() - 1] {
                let second = |side: f64| {
                    let value = |n: f64| curve.at(time + side * n * step);
                    (2.0 * value(0.0) - 5.0 * value(1.0) + 4.0 * value(2.0) - value(3.0)) / (step * step)
                };
                let (before, after) = (second(-1.0), second(1.0));
                let size = 1.0 + before.abs().max(after.abs());
                prop_assert!((before - after).abs() < 1e-3 * size, "{before} {after}");
            }
        }

        #[test]
        fn a_held_curve_stays_between_its_neighbours(
            values in prop::array::uniform6(-100.0..100.0_f64), part in 0.0..1.0,
        ) {
            let times = [0.0, 0.4, 0.5, 1.1, 2.0, 2.2];
            let curve = Spline::held(&times, &values);
            for i in 0..5 {
                let value = curve.at(times[i] + part * (times[i + 1] - times[i]));
                let (low, high) = (values[i].min(values[i + 1]), values[i].max(values[i + 1]));
                prop_assert!((low - 1e-9..=high + 1e-9).contains(&value));
            }
        }
    }

    #[test]
    fn outside_its_times_a_curve_keeps_its_end_values() {
        let curve = Spline::held(&[1.0, 2.0], &[3.0, 5.0]);
        assert_eq!([curve.at(-7.0), curve.at(1.0), curve.at(2.0), curve.at(9.0)], [3.0, 3.0, 5.0, 5.0]);
    }
}
