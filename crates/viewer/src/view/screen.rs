//! The window's picture: that of one motion, or those of several side by side. Only what has changed is drawn anew.

use crate::draw::Painter;
use crate::draw::canvas::{Canvas, Color};
use crate::scene::Scene;
use crate::view::app::Shown;
use crate::view::gallery::{Gallery, Tile};

/// Between two motions.
const BORDER: Color = Color(0x1D_24_2E);

/// Draws a gallery, and keeps its picture.
pub struct Screen {
    painter: Painter,
    canvas: Canvas,
    parts: Vec<Part>,
}

/// The picture of one motion.
#[derive(Default)]
struct Part {
    tile: Option<Tile>,
    /// What is drawn, and what is to be.
    drawn: Scene,
    next: Scene,
    /// Where it is drawn when it shares the window.
    canvas: Option<Canvas>,
}

impl Screen {
    /// An empty picture of `size` pixels.
    pub fn new(size: (usize, usize)) -> Screen {
        Screen { painter: Painter::new(), canvas: Canvas::new(size.0, size.1), parts: Vec::new() }
    }

    /// The picture.
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
    }

    /// Makes the picture what is to be seen now in a window of `size` pixels. `shown` says whose functions move each
    /// motion. Gives whether anything has changed.
    pub fn update<'a>(
        &mut self,
        gallery: &mut Gallery,
        shown: impl Fn(usize) -> Shown<'a>,
        size: (usize, usize),
    ) -> bool {
        let size = Canvas::clamped(size);
        let count = gallery.tiles(size).count();
        // With other tiles than before, some of the picture may belong to none.
        let resized = self.canvas.size() != size || count != self.parts.len();
        if resized {
            self.canvas = Canvas::new(size.0, size.1);
            self.parts.resize_with(count, Part::default);
        }
        let mut changed = resized;
        for (index, tile) in gallery.tiles(size).enumerate() {
            let part = &mut self.parts[index];
            let Some(app) = gallery.apps_mut().get_mut(tile.motion) else { continue };
            app.fill(&mut part.next, shown(tile.motion), tile.size);
            if !resized && part.tile == Some(tile) && part.drawn == part.next {
                continue;
            }
            changed = true;
            part.tile = Some(tile);
            std::mem::swap(&mut part.drawn, &mut part.next);
            if tile.size == size {
                part.canvas = None;
                self.painter.draw(&part.drawn, &mut self.canvas);
            } else {
                self.draw_part(index, tile);
            }
        }
        changed
    }

    fn draw_part(&mut self, index: usize, tile: Tile) {
        let part = &mut self.parts[index];
        let fresh = || Canvas::new(tile.size.0, tile.size.1);
        let canvas = part.canvas.get_or_insert_with(fresh);
        if canvas.size() != Canvas::clamped(tile.size) {
            *canvas = fresh();
        }
        self.painter.draw(&part.drawn, canvas);
        let (right, bottom) = (tile.size.0 as i32 - 1, tile.size.1 as i32 - 1);
        canvas.rectangle((right, 0), (1, bottom + 1), BORDER, 0.5);
        canvas.rectangle((0, bottom), (right + 1, 1), BORDER, 0.5);
        self.canvas.paste(canvas, tile.corner.0, tile.corner.1);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use skeleton::PositionChannels;

    use super::*;
    use crate::motion::stage::Stage;
    use crate::samples;
    use crate::view::app::App;
    use crate::window::keys::Action;

    const SIZE: (usize, usize) = (200, 100);

    fn gallery(count: usize) -> Gallery {
        let stage = Arc::new(Stage::new(samples::chain(9, 1.0), PositionChannels::Replace));
        Gallery::new((0..count).map(|_| App::new(stage.clone(), "a".into(), Vec::new(), SIZE)).collect())
    }

    fn update(screen: &mut Screen, gallery: &mut Gallery) -> bool {
        screen.update(gallery, |_| Shown::Reference, SIZE)
    }

    #[test]
    fn it_is_drawn_only_when_something_has_changed() {
        for count in [1, 2] {
            let (mut screen, mut gallery) = (Screen::new(SIZE), gallery(count));
            assert!(update(&mut screen, &mut gallery));
            assert!(!update(&mut screen, &mut gallery));
            let before = screen.canvas().pixels().to_vec();
            gallery.act(Action::Step(5));
            assert!(update(&mut screen, &mut gallery));
            assert!(screen.canvas().pixels() != before);
            gallery.act(Action::Step(-5));
            update(&mut screen, &mut gallery);
            assert!(screen.canvas().pixels() == before);
        }
    }

    #[test]
    fn from_all_to_one_and_back_is_the_same_picture() {
        let (mut screen, mut both) = (Screen::new(SIZE), gallery(2));
        update(&mut screen, &mut both);
        let side_by_side = screen.canvas().pixels().to_vec();
        both.act(Action::NextMotion);
        assert!(update(&mut screen, &mut both));
        let mut alone = Screen::new(SIZE);
        update(&mut alone, &mut gallery(1));
        assert!(screen.canvas().pixels() == alone.canvas().pixels());
        both.act(Action::NextMotion);
        both.act(Action::NextMotion);
        update(&mut screen, &mut both);
        assert!(screen.canvas().pixels() == side_by_side);
    }

    #[test]
    fn what_belongs_to_no_tile_is_empty() {
        let (mut screen, mut three) = (Screen::new(SIZE), gallery(3));
        let size = (160, 120);
        let show = |screen: &mut Screen, gallery: &mut Gallery| {
            screen.update(gallery, |_| Shown::Reference, size);
            screen.canvas().pixels().to_vec()
        };
        let first = show(&mut screen, &mut three);
        three.act(Action::NextMotion);
        show(&mut screen, &mut three);
        (0..3).for_each(|_| three.act(Action::NextMotion));
        assert!(show(&mut screen, &mut three) == first);
    }

    #[test]
    fn any_size_of_the_window_will_do() {
        let (mut screen, mut gallery) = (Screen::new(SIZE), gallery(3));
        for size in [(1, 1), (0, 0), (3000, 2), (2, 700), (64, 64)] {
            screen.update(&mut gallery, |_| Shown::Reference, size);
            assert_eq!(screen.canvas().size(), Canvas::clamped(size));
        }
    }
}
