//! TEMPORARY
#![allow(missing_docs)]
#[derive(Clone, Debug, PartialEq)]
pub struct Board {
    pub title: String,
    pub rows: Vec<BoardRow>,
    pub points: u32,
    pub of: u32,
}
#[derive(Clone, Debug, PartialEq)]
pub struct BoardRow {
    pub id: &'static str,
    pub title: &'static str,
    pub points: u32,
    pub of: u32,
    pub state: grading::PartState,
    pub named: Vec<grading::Named>,
}
