//! What the teaching assistant hands in beside the submissions: who is enrolled, who was late, what is to be changed.

mod late;
mod overrides;
mod roster;
mod table;

pub use late::LateList;
pub use overrides::Overrides;
pub(crate) use overrides::{Override, What};
pub use roster::Roster;
pub(crate) use table::Table;
