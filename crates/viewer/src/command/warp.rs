//! The options about time warps.

use std::str::FromStr;

use clap::Args;

use crate::motion::source::{Source, Warping};
use crate::view::warp::MOST_FRAMES;

/// A motion with another number of frames.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Time warp")]
pub struct WarpArguments {
    /// Shows the motion beside itself with so many frames, slower or faster [default with --between: twice as many]
    #[arg(long, value_name = "FRAMES", value_parser = parse_count, allow_negative_numbers = true)]
    warp: Option<usize>,

    /// Warps only the stretch between these two frames: --warp says how many frames it is from the one to the other, and all
    /// else keeps its length
    #[arg(long, value_name = "FRAME,FRAME")]
    between: Option<Stretch>,
}

/// Two keyframes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stretch(usize, usize);

impl FromStr for Stretch {
    type Err = String;

    fn from_str(text: &str) -> Result<Stretch, String> {
        let frame = |text: &str| text.trim().parse::<usize>().ok();
        let ends = text.split_once(',').and_then(|(first, last)| Some((frame(first)?, frame(last)?)));
        let (first, last) =
            ends.ok_or("write two frames with a comma between them, counted from 0, for example 100,160")?;
        match first == last {
            true => {
                Err("write two different frames: between a frame and itself there is nothing to warp".into())
            }
            false => Ok(Stretch(first, last)),
        }
    }
}

fn parse_count(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| (1..=MOST_FRAMES).contains(count));
    count.ok_or_else(|| format!("write how many frames there are to be, from 1 to {MOST_FRAMES}"))
}

impl WarpArguments {
    /// How motions are warped, if they are.
    pub fn warping(&self) -> Option<Warping> {
        let keyframes = self.between.map(|Stretch(first, last)| (first, last));
        let is_given = self.warp.is_some() || keyframes.is_some();
        is_given.then_some(Warping { frames: self.warp, keyframes })
    }

    /// Each motion, and behind it the same one warped, where any is: as it is said here, or else as `usual`.
    pub fn beside(&self, sources: Vec<Source>, usual: Option<Warping>) -> Vec<Source> {
        let Some(warping) = self.warping().or(usual) else { return sources };
        let both = |source: Source| [source.clone(), Source { warp: Some(warping), ..source }];
        sources.into_iter().flat_map(both).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_is_two_different_frames() {
        assert_eq!("100, 160".parse(), Ok(Stretch(100, 160)));
        assert_eq!("160,100".parse(), Ok(Stretch(160, 100)));
        for wrong in ["", "100", "100,", "a,b", "-1,5", "1,2,3", "5,5"] {
            assert!(wrong.parse::<Stretch>().is_err(), "{wrong}");
        }
    }
}
