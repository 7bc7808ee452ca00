//! The flow of the legend's blocks into columns. Heights are in em.

use super::facts::{Block, Row};
use super::legend::{BETWEEN, MAP, WIDER};
use crate::font::Font;

/// Lines of a note before it is shortened.
const NOTE_LINES: usize = 3;
/// Before the further lines of a note; no-break spaces, which XML keeps.
const INDENT: &str = "\u{a0}\u{a0}";

/// The blocks with their notes broken to the width of a column.
pub fn wrapped(blocks: Vec<Block>, width: f64) -> Vec<Block> {
    let font = Font::new(false);
    let lines = |row: Row| match row {
        Row::Note(text, colour) => {
            let lines = font.wrapped(&text, width / WIDER - 1.0, NOTE_LINES);
            let indented = |(i, line)| if i == 0 { line } else { format!("{INDENT}{line}") };
            lines.into_iter().enumerate().map(indented).map(|l| Row::Note(l, colour)).collect()
        }
        row => vec![row],
    };
    blocks.into_iter().map(|block| block.into_iter().flat_map(lines).collect()).collect()
}

/// Height of a row.
pub fn row_height(row: &Row) -> f64 {
    match row {
        Row::Head(_) => 1.8,
        Row::Pair(..) | Row::Cells(_) => 1.5,
        Row::Key(..) => 1.6,
        Row::Depth(_) => 3.9,
        Row::Map => MAP + 0.8,
        Row::Note(..) => 1.4,
    }
}

/// Height of a block.
pub fn height(block: &[Row]) -> f64 {
    block.iter().map(row_height).sum()
}

/// Height of the highest column.
pub fn tallest(columns: &[Vec<Block>]) -> f64 {
    let tall = |c: &Vec<Block>| c.iter().map(|b| height(b) + BETWEEN).sum::<f64>() - BETWEEN;
    columns.iter().map(tall).fold(0.0, f64::max)
}

/// Fills at most `count` columns in order, as low as the order allows.
pub fn flow(blocks: Vec<Block>, count: usize) -> Vec<Vec<Block>> {
    let heights: Vec<f64> = blocks.iter().map(|b| height(b) + BETWEEN).collect();
    let total: f64 = heights.iter().sum();
    let fits = |limit: f64| columns_needed(&heights, limit) <= count;
    let mut limit = heights.iter().copied().fold(total / count as f64, f64::max);
    while !fits(limit) {
        limit += 0.5;
    }
    let mut columns: Vec<Vec<Block>> = Vec::new();
    let mut used = f64::INFINITY;
    for (block, height) in blocks.into_iter().zip(heights) {
        if used + height > limit {
            columns.push(Vec::new());
            used = 0.0;
        }
        used += height;
        if let Some(column) = columns.last_mut() {
            column.push(block);
        }
    }
    columns
}

fn columns_needed(heights: &[f64], limit: f64) -> usize {
    let mut used = 0.0;
    1 + heights
        .iter()
        .filter(|h| {
            let full = used + **h > limit;
            used = if full { **h } else { used + **h };
            full
        })
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(rows: usize) -> Block {
        vec![Row::Pair("a".into(), "b".into()); rows]
    }

    #[test]
    fn blocks_flow_in_order_and_evenly() {
        let sizes = |columns: Vec<Vec<Block>>| -> Vec<Vec<usize>> {
            columns.iter().map(|c| c.iter().map(Vec::len).collect()).collect()
        };
        let blocks = || vec![block(6), block(5), block(8), block(3), block(4)];
        assert_eq!(sizes(flow(blocks(), 1)), [[6, 5, 8, 3, 4]]);
        assert_eq!(sizes(flow(blocks(), 2)), [vec![6, 5], vec![8, 3, 4]]);
        assert!(flow(blocks(), 9).len() <= 5);
    }
}
