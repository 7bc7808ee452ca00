//! The table of tools.

use crate::tool::Tool;
use crate::{
    copy, drill_press, fluter, header, height_grid, indexer, probe, setup, surfacer, typesetter,
};

/// Every tool, in the order of its letters.
pub const TOOLS: [&Tool; 10] = [
    &copy::TOOL,
    &drill_press::TOOL,
    &fluter::TOOL,
    &header::TOOL,
    &indexer::TOOL,
    &height_grid::TOOL,
    &probe::TOOL,
    &setup::TOOL,
    &surfacer::TOOL,
    &typesetter::TOOL,
];

/// The tool of a letter.
pub fn tool(letter: char) -> Option<&'static Tool> {
    TOOLS.into_iter().find(|tool| tool.letter == letter.to_ascii_uppercase())
}
