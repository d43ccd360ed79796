//! Points and percentages with two decimals, in exact arithmetic.

use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};

/// Points with two decimals. Shown as `12` when whole and as `7.50` otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Points {
    hundredths: u64,
}

/// A percentage with two decimals, from 0 to 100.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Percent {
    hundredths: u64,
}

/// What a submission loses for being late.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LatePolicy {
    /// Taken off for every day.
    pub percent_per_day: Percent,
    /// No more than this is taken off in all.
    pub cap: Percent,
}

/// A text that is no number with at most two decimals, or not in its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected a number with at most two decimals, such as 7 or 7.5{0}")]
pub struct NotDecimal(&'static str);

const PERCENT_OF_ALL: u64 = 100 * 100;

impl Points {
    /// No points.
    pub const ZERO: Points = Points { hundredths: 0 };

    /// So many whole points.
    pub fn whole(points: u32) -> Points {
        Points { hundredths: u64::from(points) * 100 }
    }

    /// The points with so much taken off, rounded to the nearest hundredth; a half counts for the student.
    pub fn less(self, percent: Percent) -> Points {
        let kept = u128::from(PERCENT_OF_ALL.saturating_sub(percent.hundredths));
        let exact = u128::from(self.hundredths) * kept;
        let rounded = (exact + u128::from(PERCENT_OF_ALL) / 2) / u128::from(PERCENT_OF_ALL);
        Points { hundredths: u64::try_from(rounded).unwrap_or(self.hundredths) }
    }

    /// The sum, or the largest number of points that there is.
    pub fn plus(self, other: Points) -> Points {
        Points { hundredths: self.hundredths.saturating_add(other.hundredths) }
    }

    /// The difference; no points when it would be less.
    pub fn minus(self, other: Points) -> Points {
        Points { hundredths: self.hundredths.saturating_sub(other.hundredths) }
    }

    /// As a floating-point number, for formats that have no other.
    pub fn as_f64(self) -> f64 {
        self.hundredths as f64 / 100.0
    }
}

impl LatePolicy {
    /// What is taken off after so many days.
    pub fn deduction(&self, days: u32) -> Percent {
        let hundredths = self.percent_per_day.hundredths.saturating_mul(u64::from(days));
        Percent { hundredths }.min(self.cap)
    }
}

impl fmt::Display for Points {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_hundredths(f, self.hundredths)
    }
}

impl fmt::Display for Percent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_hundredths(f, self.hundredths)
    }
}

fn write_hundredths(f: &mut fmt::Formatter<'_>, hundredths: u64) -> fmt::Result {
    match (hundredths / 100, hundredths % 100) {
        (whole, 0) => f.pad(&whole.to_string()),
        (whole, part) => f.pad(&format!("{whole}.{part:02}")),
    }
}

impl FromStr for Points {
    type Err = NotDecimal;

    fn from_str(text: &str) -> Result<Points, NotDecimal> {
        Ok(Points { hundredths: hundredths(text).ok_or(NotDecimal(""))? })
    }
}

impl FromStr for Percent {
    type Err = NotDecimal;

    fn from_str(text: &str) -> Result<Percent, NotDecimal> {
        let text = text.trim().trim_end_matches('%').trim_end();
        let hundredths = hundredths(text).filter(|hundredths| *hundredths <= PERCENT_OF_ALL);
        Ok(Percent { hundredths: hundredths.ok_or(NotDecimal(", from 0 to 100"))? })
    }
}

/// Reads `12`, `12.5`, `12,50`. More than ten digits are no points of anybody's.
fn hundredths(text: &str) -> Option<u64> {
    let text = text.trim();
    let (whole, part) = text.split_once(['.', ',']).unwrap_or((text, "0"));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(part) || whole.len() > 10 || part.len() > 2 {
        return None;
    }
    let part = format!("{part:0<2}");
    Some(whole.parse::<u64>().ok()? * 100 + part.parse::<u64>().ok()?)
}

impl Serialize for Points {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.hundredths.is_multiple_of(100) {
            serializer.serialize_u64(self.hundredths / 100)
        } else {
            serializer.serialize_f64(self.as_f64())
        }
    }
}

impl Serialize for Percent {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Points { hundredths: self.hundredths }.serialize(serializer)
    }
}
