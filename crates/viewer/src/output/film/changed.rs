//! Which part of a picture is other than the picture before.

/// A part of a picture, in pixels. Never empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub left: usize,
    pub top: usize,
    pub width: usize,
    pub height: usize,
}

impl Part {
    /// All of a picture.
    pub fn whole((width, height): (usize, usize)) -> Part {
        Part { left: 0, top: 0, width, height }
    }

    /// The smallest part that holds every pixel in which the pictures differ; one pixel when there is none, as a
    /// picture of a film has to have one. Both have `width` pixels in a row.
    pub fn changed(old: &[u32], new: &[u32], width: usize) -> Part {
        let rows = || old.chunks_exact(width).zip(new.chunks_exact(width));
        let Some(top) = rows().position(|(old, new)| old != new) else {
            return Part { left: 0, top: 0, width: 1, height: 1 };
        };
        let bottom = rows().rposition(|(old, new)| old != new).unwrap_or(top);
        let (mut left, mut right) = (width, 0);
        for (old, new) in rows().skip(top).take(bottom - top + 1) {
            // Only what would make the part wider is looked at.
            let first = old[..left].iter().zip(&new[..left]).position(|(old, new)| old != new);
            left = first.unwrap_or(left);
            let last = old[right..].iter().zip(&new[right..]).rposition(|(old, new)| old != new);
            right = last.map_or(right, |last| right + last + 1);
        }
        Part { left, top, width: right - left, height: bottom - top + 1 }
    }

    /// Its rows in a picture of `width` pixels in a row, with the number of each.
    pub fn rows<'a>(&self, pixels: &'a [u32], width: usize) -> impl Iterator<Item = (usize, &'a [u32])> {
        let Part { left, top, width: across, height } = *self;
        pixels
            .chunks_exact(width)
            .enumerate()
            .skip(top)
            .take(height)
            .map(move |(y, row)| (y, &row[left..left + across]))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn equal_pictures_differ_in_one_pixel_for_form() {
        assert_eq!(Part::changed(&[7; 6], &[7; 6], 3), Part { left: 0, top: 0, width: 1, height: 1 });
    }

    proptest! {
        #[test]
        fn the_part_is_the_smallest_that_holds_every_change(
            width in 1usize..9,
            height in 1usize..9,
            spots in proptest::collection::vec((0usize..9, 0usize..9), 1..6),
        ) {
            let old = vec![0; width * height];
            let mut new = old.clone();
            let spots: Vec<_> = spots.into_iter().map(|(x, y)| (x % width, y % height)).collect();
            for (x, y) in &spots {
                new[y * width + x] = 1;
            }
            let part = Part::changed(&old, &new, width);
            let (xs, ys) = (spots.iter().map(|s| s.0), spots.iter().map(|s| s.1));
            let (left, top) = (xs.clone().min().unwrap(), ys.clone().min().unwrap());
            prop_assert_eq!((part.left, part.top), (left, top));
            prop_assert_eq!(part.width, xs.max().unwrap() - left + 1);
            prop_assert_eq!(part.height, ys.max().unwrap() - top + 1);
            let inside: u32 = part.rows(&new, width).flat_map(|(_, row)| row).sum();
            prop_assert_eq!(inside, new.iter().sum::<u32>());
        }
    }
}
