//! The student's points, in the words of `cargo test`.

use grading::PartState;

use super::Facts;
use crate::scene::{Line, Panel};

/// `brief` leaves the hints out: they are in the terminal, too.
pub fn write(facts: &Facts, brief: bool, panel: &mut Panel) {
    let Some(points) = facts.points() else { return };
    let (board, outdated) = match (&points.board, &points.former) {
        (Some(board), _) => (board, false),
        (None, Some(former)) => (former, true),
        (None, None) if points.grading => return panel.add(Line::Quiet, "counting your points…"),
        (None, None) => return,
    };
    match outdated {
        true => panel.add(Line::Quiet, format_args!("{} (before this save)", board.title)),
        false => panel.add(Line::Heading, &board.title),
    }
    for row in &board.rows {
        let line = match row.state {
            _ if outdated => Line::Quiet,
            PartState::Right => Line::Right,
            PartState::NotStarted => Line::Quiet,
            _ => Line::Trouble,
        };
        let (id, title, state) = (row.id, row.title, row.state.name());
        panel.add(line, format_args!("{id}  {title}  {} of {}  {state}", row.points, row.of));
        for named in row.named.iter().filter(|_| !outdated) {
            panel.add(Line::Text, named.title);
            if !brief {
                panel.add(Line::Quiet, format_args!("Hint: {}", named.hint));
            }
        }
    }
}
