//! Pairs in a gallery: a motion, and behind it the same one warped. Both share one time.

use std::sync::Arc;

use crate::motion::stage::Stage;
use crate::view::app::App;
use crate::view::gallery::Gallery;
use crate::view::warp::Warp;
use crate::window::keys::Action;

impl Gallery {
    /// Whether the motion `motion` (from 0) is the original of the one behind it.
    fn is_original(&self, motion: usize) -> bool {
        self.warp(motion + 1).is_some()
    }

    /// How a motion is warped whose original is in front of it.
    fn warp(&self, motion: usize) -> Option<Warp> {
        self.apps().get(motion).filter(|_| motion > 0)?.warp()
    }

    /// Whether there are pairs and nothing else.
    pub(super) fn is_pairs(&self) -> bool {
        let is_pair = |pair: &[App]| pair.len() == 2 && pair[0].warp().is_none() && pair[1].warp().is_some();
        self.apps().chunks(2).all(is_pair)
    }

    /// Brings both motions of each pair to the same time: that of the longer one.
    pub(super) fn keep_in_step(&mut self) {
        for motion in 1..self.apps().len() {
            if self.warp(motion).is_none() {
                continue;
            }
            let (before, behind) = self.apps_mut().split_at_mut(motion);
            let (Some(original), Some(warped)) = (before.last_mut(), behind.first_mut()) else { continue };
            let stretch = warped.time_map().and_then(|map| map.keyframes());
            original.pair(stretch.map(|keyframes| keyframes.map(|(old, _)| old)));
            warped.pair(None);
            let longer_original = original.stage().frame_count() > warped.stage().frame_count();
            let (longer, other) = if longer_original { (original, warped) } else { (warped, original) };
            longer.lead();
            other.go_along(longer);
        }
    }

    /// Does what a key asks for in all motions. What is about warps is done in those that are warped.
    pub(super) fn act_in_all(&mut self, action: Action) {
        let hides = self.apps().iter().any(|app| app.warp().is_some() && app.settings.curve);
        for motion in 0..self.apps().len() {
            let (is_original, warp) = (self.is_original(motion), self.warp(motion));
            // Whoever lets keyframes be chosen counts them.
            let counts = |gallery: &Gallery, motion: usize| gallery.apps()[motion].settings.edit.automatic;
            match (action, warp) {
                (Action::RangeStart | Action::RangeEnd, None) if is_original => {}
                (Action::Keyframes(_), None) if is_original && !counts(self, motion) => {}
                (Action::Keyframes(_), Some(_)) if counts(self, motion - 1) => {}
                (Action::RangeStart | Action::RangeEnd | Action::Keyframes(_), Some(warp)) => {
                    self.change(motion, warp, action);
                }
                (Action::Plot, _) if is_original || warp.is_some() => {
                    let settings = &mut self.apps_mut()[motion].settings;
                    (settings.curve, settings.edit.plot) = (!hides, !hides);
                }
                _ => self.apps_mut()[motion].act(action),
            }
        }
    }

    /// Changes the warp of a motion as a key asks for: at the frame of its original that is shown.
    fn change(&mut self, motion: usize, mut warp: Warp, action: Action) {
        let original = &self.apps()[motion - 1];
        let (frame, old) = (original.frame(), original.stage().moving_frames());
        match action {
            Action::RangeStart => warp.begin_at(frame, old),
            Action::RangeEnd => warp.end_at(frame, old),
            // With Shift there are more keyframes at once, but fewer new frames: a tenth of a motion is much.
            Action::Keyframes(by) => warp.change(by > 0, by.unsigned_abs() > 1, old),
            _ => {}
        }
        self.apps_mut()[motion].set_warp(warp);
    }

    /// Shows another state of the motion `motion`, whose file has changed, and of the one behind it if that is the same one,
    /// warped: as it is warped now, or else by `warp`.
    pub fn replace(&mut self, motion: usize, stage: &Arc<Stage>, warnings: Vec<String>, warp: Option<Warp>) {
        let warp = self.warp(motion + 1).or(warp);
        self.apps_mut()[motion].replace(stage.clone(), warnings);
        if let Some((warp, app)) = warp.zip(self.apps_mut().get_mut(motion + 1)) {
            app.replace_original(stage, warp);
        }
        self.keep_in_step();
    }

    /// How many frames the first motion has, or the longer one of the first pair. May be 0.
    pub fn moving_frames(&self) -> usize {
        let pair = self
            .apps()
            .iter()
            .enumerate()
            .take_while(|(motion, _)| *motion == 0 || self.warp(*motion).is_some());
        pair.take(2).map(|(_, app)| app.stage().moving_frames()).max().unwrap_or(0)
    }

    /// The warp of the only pair, where there are no other motions: what the window's title is about.
    pub(super) fn only_pair(&self) -> Option<&App> {
        let [_, warped] = self.apps() else { return None };
        warped.warp().map(|_| warped)
    }
}

#[cfg(test)]
mod tests;
