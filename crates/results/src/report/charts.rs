//! Bars.

use maud::{Markup, html};

use super::statistics::Statistics;
use crate::Points;

/// How many have how many points: a bar for each whole point, or for each of at most twenty ranges.
pub(super) fn distribution(of: u32, statistics: &Statistics) -> Markup {
    let step = (of / 20).max(1);
    let bins = (of / step) as usize + 1;
    let mut counts = vec![0_usize; bins];
    for points in &statistics.points {
        let bin = (points.as_f64() / f64::from(step)) as usize;
        counts[bin.min(bins - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let (wide, high, base) = (600.0, 150.0, 176.0);
    let each = wide / bins as f64;
    let label = |bin: usize| bin as u32 * step;
    // Every label has room for its digits.
    let every = (bins as f64 * 26.0 / wide).ceil().max(1.0) as usize;
    html! {
        figure {
            svg.bars viewBox="0 0 600 200" role="img" aria-label=(described(&counts, step)) {
                @for (bin, count) in counts.iter().enumerate() {
                    @let height = *count as f64 / most as f64 * high;
                    @let middle = (bin as f64 + 0.5) * each;
                    rect x=(one(bin as f64 * each + each * 0.12)) y=(one(base - height)) width=(one(each * 0.76)) height=(one(height)) {}
                    @if *count > 0 { text.count x=(one(middle)) y=(one(base - height - 5.0)) { (count) } }
                    @if bin % every == 0 { text x=(one(middle)) y="194" { (label(bin)) } }
                }
                line x1="0" x2="600" y1="176" y2="176" {}
            }
        }
    }
}

fn described(counts: &[usize], step: u32) -> String {
    let bars = counts.iter().enumerate().filter(|(_, count)| **count > 0);
    let bars = bars.map(|(bin, count)| format!("{count} with {}", Points::whole(bin as u32 * step)));
    format!("Distribution of points: {}", bars.collect::<Vec<_>>().join(", "))
}

/// A bar as long as `count` is of `most`.
pub(super) fn bar(count: usize, most: usize) -> Markup {
    let wide = count as f64 / most.max(1) as f64 * 100.0;
    html! {
        svg.bar viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true" {
            rect.track width="100" height="10" {}
            rect.full width=(one(wide)) height="10" {}
        }
    }
}

/// One decimal.
fn one(value: f64) -> f64 {
    (value * 10.0).round() / 10.0 + 0.0
}
