//! Reading one frame's angles from front to back.

/// Walks over the angles of one frame: three per joint that rotates, in the order of the joints, in degrees.
///
/// There is one cursor for a whole frame. Each joint takes its own angles, so that the next joint finds its own
/// in front. What one joint leaves, the next one gets.
#[derive(Clone, Debug)]
pub struct FrameCursor<'a> {
    angles: &'a [f32],
    next: usize,
}

impl<'a> FrameCursor<'a> {
    /// A cursor in front of the first of `angles` (degrees).
    pub fn new(angles: &'a [f32]) -> Self {
        FrameCursor { angles, next: 0 }
    }

    /// Gives the next three angles, in degrees, and moves past them. Behind the last angle it gives zeros.
    pub fn take3(&mut self) -> [f32; 3] {
        [self.take(), self.take(), self.take()]
    }

    /// Gives the next angle, in degrees, and moves past it. Behind the last angle it gives zero.
    pub fn take(&mut self) -> f32 {
        let angle = self.angles.get(self.next).copied().unwrap_or(0.0);
        self.next = self.next.saturating_add(1);
        angle
    }

    /// Gives the next three angles, in degrees, without moving. Behind the last angle it gives zeros.
    pub fn peek3(&self) -> [f32; 3] {
        self.clone().take3()
    }

    /// How many angles have been taken so far, those behind the last angle included.
    pub fn taken(&self) -> usize {
        self.next
    }

    /// Whether an angle was taken where there was none left.
    pub fn overrun(&self) -> bool {
        self.next > self.angles.len()
    }
}
