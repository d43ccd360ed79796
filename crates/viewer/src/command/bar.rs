//! Bars in the terminal, for work that takes its time.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of this length; nothing where there is no terminal. `template` is one of [`ProgressStyle`].
pub fn bar(length: usize, template: &str) -> ProgressBar {
    let bar = ProgressBar::new(length as u64);
    let style = ProgressStyle::with_template(template);
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
