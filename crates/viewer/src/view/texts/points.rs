//! The student's points, in the words of `cargo test`.

use grading::PartState;

use super::Facts;
use crate::scene::{Line, Panel};

pub fn write(facts: &Facts, panel: &mut Panel) {
    let Some(standing) = facts.standing else { return };
    let Some(board) = &standing.board else {
        if standing.grading {
            panel.add(Line::Quiet, "counting your points…");
        }
        return;
    };
    panel.add(Line::Heading, &board.title);
    for row in &board.rows {
        let line = match row.state {
            PartState::Right => Line::Right,
            PartState::NotStarted => Line::Quiet,
            _ => Line::Trouble,
        };
        let (id, title, state) = (row.id, row.title, row.state.name());
        panel.add(line, format_args!("{id}  {title}  {} of {}  {state}", row.points, row.of));
        for named in &row.named {
            panel.add(Line::Text, named.title);
            panel.add(Line::Quiet, format_args!("Hint: {}", named.hint));
        }
    }
}
