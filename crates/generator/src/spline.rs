//! A smooth curve through given points.

/// A cubic spline: through every point, with continuous speed and acceleration, and with a given speed at each end.
#[derive(Clone, Debug)]
pub struct Spline {
    times: Vec<f64>,
    values: Vec<f64>,
    speeds: Vec<f64>,
}

impl Spline {
    /// A curve through `points`, each (time, value), in the order of their times, at least two of them. `ends` are the
    /// speeds at the first and the last point, in the value's unit per unit of time.
    ///
    /// The speeds between follow from the demand that the acceleration be continuous, which is a system of
    /// equations with three entries a row (de Boor 1978, "A Practical Guide to Splines", chapter IV).
    pub fn clamped(points: &[(f64, f64)], ends: [f64; 2]) -> Spline {
        let times: Vec<f64> = points.iter().map(|point| point.0).collect();
        let values: Vec<f64> = points.iter().map(|point| point.1).collect();
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

    /// A curve through `points` that starts and ends at rest.
    pub fn resting(points: &[(f64, f64)]) -> Spline {
        Spline::clamped(points, [0.0, 0.0])
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
