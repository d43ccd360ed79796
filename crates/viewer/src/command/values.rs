//! Values on the command line that are more than a word or a number.

use std::str::FromStr;

use crate::draw::canvas::MAX_SIDE;

/// A side to look from, in degrees, and a zoom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    pub around: f32,
    pub above: f32,
    pub zoom: f32,
}

impl FromStr for Side {
    type Err = String;

    fn from_str(text: &str) -> Result<Side, String> {
        let numbers: Option<Vec<f32>> = text
            .split(',')
            .map(|number| number.trim().parse().ok().filter(|n: &f32| n.is_finite()))
            .collect();
        match numbers.as_deref() {
            Some(&[around, above]) => Ok(Side { around, above, zoom: 1.0 }),
            Some(&[around, above, zoom]) if (0.01..=100.0).contains(&zoom) => {
                Ok(Side { around, above, zoom })
            }
            Some([_, _, _]) => Err("the zoom, the third number, is from 0.01 to 100".into()),
            _ => {
                Err("write two or three numbers with commas between them, for example 90,20 or 90,20,1.5"
                    .into())
            }
        }
    }
}

pub fn parse_size(text: &str) -> Result<(usize, usize), String> {
    let side = |side: &str| side.parse::<usize>().ok().filter(|side| (16..=MAX_SIDE).contains(side));
    let (width, height) = text.split_once(['x', 'X']).unwrap_or((text, ""));
    side(width).zip(side(height)).ok_or_else(|| {
        format!("write two numbers from 16 to {MAX_SIDE} with an x between them, for example 1280x720")
    })
}

pub fn parse_scale(text: &str) -> Result<f32, String> {
    let scale = text.parse().ok().filter(|scale| (0.5..=4.0).contains(scale));
    scale.ok_or_else(|| {
        "write a number from 0.5 to 4: 1 is for ordinary displays, 2 for very fine ones".into()
    })
}

pub fn parse_speed(text: &str) -> Result<f64, String> {
    let speed = text.parse().ok().filter(|speed| (0.01..=100.0).contains(speed));
    speed.ok_or_else(|| "write a number from 0.01 to 100: 0.5 is half as fast as the motion".into())
}

pub fn parse_rate(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate| (1e-6..=1e6).contains(rate));
    rate.ok_or_else(|| "write a number of frames per second from 0.000001 to 1000000, for example 120".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_numbers_with_an_x() {
        assert_eq!(parse_size("640x480"), Ok((640, 480)));
        for wrong in ["640", "640x", "x480", "15x400", "640x99999999999999999999", "-640x480", "640×480", ""]
        {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_side_is_two_angles_and_perhaps_a_zoom() {
        assert_eq!("90, -20".parse(), Ok(Side { around: 90.0, above: -20.0, zoom: 1.0 }));
        assert_eq!("-5,0,1.5".parse(), Ok(Side { around: -5.0, above: 0.0, zoom: 1.5 }));
        for wrong in ["", "90", "90,", "a,b", "1,2,3,4", "1,2,0", "1,NaN", "inf,1"] {
            assert!(wrong.parse::<Side>().is_err(), "{wrong}");
        }
    }
}
