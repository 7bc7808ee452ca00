//! The two levels of arrays: blocks in a job, jobs on the table.

use kerf_geom::Vec2;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The corner block at which an array begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Corner {
    /// Bottom left.
    #[default]
    BottomLeft,
    /// Bottom right.
    BottomRight,
    /// Top right.
    TopRight,
    /// Top left.
    TopLeft,
}

impl Corner {
    /// Its two letters.
    pub fn name(self) -> &'static str {
        match self {
            Self::BottomLeft => "bl",
            Self::BottomRight => "br",
            Self::TopRight => "tr",
            Self::TopLeft => "tl",
        }
    }

    /// The corner of these two letters.
    pub fn named(word: &str) -> Option<Self> {
        let all = [Self::BottomLeft, Self::BottomRight, Self::TopRight, Self::TopLeft];
        all.into_iter().find(|corner| corner.name().eq_ignore_ascii_case(word))
    }

    fn at_right(self) -> bool {
        matches!(self, Self::BottomRight | Self::TopRight)
    }

    fn at_top(self) -> bool {
        matches!(self, Self::TopLeft | Self::TopRight)
    }
}

/// The order in which the blocks of an array are cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Order {
    /// Row after row, all in the same direction.
    #[default]
    RowMajor,
    /// Column after column, all in the same direction.
    ColumnMajor,
    /// Row after row, every other one backwards.
    RowSnake,
    /// Column after column, every other one backwards.
    ColumnSnake,
}

impl Order {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::RowMajor => "row",
            Self::ColumnMajor => "column",
            Self::RowSnake => "row-snake",
            Self::ColumnSnake => "column-snake",
        }
    }

    /// The order of that name.
    pub fn named(word: &str) -> Option<Self> {
        let all = [Self::RowMajor, Self::ColumnMajor, Self::RowSnake, Self::ColumnSnake];
        all.into_iter().find(|order| order.name().eq_ignore_ascii_case(word))
    }

    fn by_rows(self) -> bool {
        matches!(self, Self::RowMajor | Self::RowSnake)
    }

    fn snakes(self) -> bool {
        matches!(self, Self::RowSnake | Self::ColumnSnake)
    }
}

/// One level of arraying.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArrayLevel {
    /// Rows, counted upwards, at least 1.
    pub rows: u32,
    /// Columns, counted to the right, at least 1.
    pub columns: u32,
    /// Gap between neighbouring rows, millimetres.
    pub row_gap_mm: f64,
    /// Gap between neighbouring columns, millimetres.
    pub column_gap_mm: f64,
    /// Corner at which it begins.
    pub start: Corner,
    /// Order in which its blocks are cut.
    pub order: Order,
}

impl Default for ArrayLevel {
    fn default() -> Self {
        Self {
            rows: 1,
            columns: 1,
            row_gap_mm: 0.0,
            column_gap_mm: 0.0,
            start: Corner::default(),
            order: Order::default(),
        }
    }
}

impl ArrayLevel {
    /// Number of blocks.
    pub fn count(&self) -> u64 {
        u64::from(self.rows) * u64::from(self.columns)
    }

    /// Row and column of the n-th block to be cut, counted from 0 at the bottom left.
    pub fn cell(&self, n: u64) -> (u32, u32) {
        let inner_count = if self.order.by_rows() { self.columns } else { self.rows }.max(1);
        let (outer, inner) = (n / u64::from(inner_count), n % u64::from(inner_count));
        // Both are below a u32 count.
        let (outer, mut inner) = (outer as u32, inner as u32);
        if self.order.snakes() && outer % 2 == 1 {
            inner = inner_count - 1 - inner;
        }
        let (row, column) = if self.order.by_rows() { (outer, inner) } else { (inner, outer) };
        let row = if self.start.at_top() { self.rows.saturating_sub(1 + row) } else { row };
        let column =
            if self.start.at_right() { self.columns.saturating_sub(1 + column) } else { column };
        (row, column)
    }

    /// Distance from one block to the next, for a block of this size.
    pub fn pitch(&self, block: Vec2) -> Vec2 {
        Vec2::new(block.x + self.column_gap_mm, block.y + self.row_gap_mm)
    }

    /// Size of the whole level, for a block of this size.
    pub fn size(&self, block: Vec2) -> Vec2 {
        let pitch = self.pitch(block);
        Vec2::new(
            block.x + pitch.x * f64::from(self.columns.saturating_sub(1)),
            block.y + pitch.y * f64::from(self.rows.saturating_sub(1)),
        )
    }
}

/// Both levels of a drawing: the basic block repeated to a job, the job repeated on the table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Arrays {
    /// Blocks in a job.
    pub block: ArrayLevel,
    /// Jobs on the table.
    pub job: ArrayLevel,
}

/// A level of arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// The basic block is repeated to a job.
    Block,
    /// The job is repeated on the table.
    Job,
}

/// Copies that would lie on each other.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "the gap between the {lines} of the {level} array is {gap_mm} mm: it must be above {least_mm} mm, so that \
     they do not lie on each other"
)]
pub struct GapError {
    /// `block` or `job`.
    pub level: &'static str,
    /// `rows` or `columns`.
    pub lines: &'static str,
    /// The gap.
    pub gap_mm: f64,
    /// Bound above which it has to be: the size of what is repeated, negative.
    pub least_mm: f64,
}

impl Arrays {
    /// Checks that copies of a block of this size go on by more than nothing (readings, Array order).
    ///
    /// # Errors
    /// The first gap that is too small.
    pub fn check(&self, block: Vec2) -> Result<(), GapError> {
        let job = self.block.size(block);
        for (level, array, size) in [("block", self.block, block), ("job", self.job, job)] {
            let rows = ("rows", array.rows, array.row_gap_mm, size.y);
            let columns = ("columns", array.columns, array.column_gap_mm, size.x);
            for (lines, count, gap_mm, size) in [rows, columns] {
                if count > 1 && gap_mm + size <= 0.0 {
                    return Err(GapError { level, lines, gap_mm, least_mm: -size + 0.0 });
                }
            }
        }
        Ok(())
    }

    /// A level, to be changed.
    pub fn level_mut(&mut self, level: Level) -> &mut ArrayLevel {
        match level {
            Level::Block => &mut self.block,
            Level::Job => &mut self.job,
        }
    }

    /// Number of copies of the basic block.
    pub fn count(&self) -> u64 {
        self.block.count().saturating_mul(self.job.count())
    }

    /// Returns the displacement of each copy of a block of this size, in cutting order.
    pub fn placements(&self, block: Vec2) -> impl Iterator<Item = Vec2> {
        let (inner, outer) = (self.block, self.job);
        let (pitch, job_pitch) = (inner.pitch(block), outer.pitch(inner.size(block)));
        (0..outer.count()).flat_map(move |job| {
            let from = place(outer.cell(job), job_pitch);
            (0..inner.count()).map(move |n| from + place(inner.cell(n), pitch))
        })
    }

    /// Size of all together, for a block of this size.
    pub fn size(&self, block: Vec2) -> Vec2 {
        self.job.size(self.block.size(block))
    }
}

fn place((row, column): (u32, u32), pitch: Vec2) -> Vec2 {
    Vec2::new(f64::from(column) * pitch.x, f64::from(row) * pitch.y)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, non_snake_case)]
mod tests {
    use super::*;

    /// Rows and columns counted from 1, as the manual writes them.
    fn cells(start: Corner, order: Order) -> String {
        let level = ArrayLevel { rows: 2, columns: 3, start, order, ..Default::default() };
        let cell = |n| {
            let (row, column) = level.cell(n);
            format!("{}{}", row + 1, column + 1)
        };
        (0..level.count()).map(cell).collect::<Vec<_>>().join(" ")
    }

    fn check(order: Order, expected: [&str; 4]) {
        let corners = [Corner::BottomLeft, Corner::BottomRight, Corner::TopRight, Corner::TopLeft];
        for (corner, expected) in corners.into_iter().zip(expected) {
            assert_eq!(cells(corner, order), expected, "{corner:?} {order:?}");
        }
    }

    #[test]
    fn pro_array_rowmajor() {
        let [bl, br] = ["11 12 13 21 22 23", "13 12 11 23 22 21"];
        check(Order::RowMajor, [bl, br, "23 22 21 13 12 11", "21 22 23 11 12 13"]);
    }

    #[test]
    fn pro_array_colmajor() {
        let [bl, br] = ["11 21 12 22 13 23", "13 23 12 22 11 21"];
        check(Order::ColumnMajor, [bl, br, "23 13 22 12 21 11", "21 11 22 12 23 13"]);
    }

    #[test]
    fn pro_array_rowsnake() {
        let [bl, br] = ["11 12 13 23 22 21", "13 12 11 21 22 23"];
        check(Order::RowSnake, [bl, br, "23 22 21 11 12 13", "21 22 23 13 12 11"]);
    }

    #[test]
    fn pro_array_colsnake() {
        let [bl, br] = ["11 21 22 12 13 23", "13 23 22 12 11 21"];
        check(Order::ColumnSnake, [bl, br, "23 13 12 22 21 11", "21 11 12 22 23 13"]);
    }

    fn two_by_three() -> ArrayLevel {
        let gaps = ArrayLevel { row_gap_mm: 20.0, column_gap_mm: 10.0, ..Default::default() };
        ArrayLevel { rows: 2, columns: 3, ..gaps }
    }

    #[test]
    fn pro_array_spacing() {
        let block = Vec2::new(100.0, 50.0);
        assert_eq!(two_by_three().pitch(block), Vec2::new(110.0, 70.0));
        assert_eq!(two_by_three().size(block), Vec2::new(320.0, 120.0));
    }

    #[test]
    fn pro_array_spacing__negative_gaps_above_the_size() {
        let block = Vec2::new(100.0, 50.0);
        let gap = |column_gap_mm: f64, row_gap_mm: f64| {
            let block = ArrayLevel { column_gap_mm, row_gap_mm, ..two_by_three() };
            Arrays { block, ..Arrays::default() }
        };
        assert_eq!(gap(-99.0, -49.0).check(block), Ok(()));
        let told = |arrays: Arrays| arrays.check(block).unwrap_err().to_string();
        let why = "so that they do not lie on each other";
        let columns =
            "the gap between the columns of the block array is -100 mm: it must be above -100 mm";
        assert_eq!(told(gap(-100.0, 0.0)), format!("{columns}, {why}"));
        let rows = "the gap between the rows of the block array is -60 mm: it must be above -50 mm";
        assert_eq!(told(gap(0.0, -60.0)), format!("{rows}, {why}"));
        let job = ArrayLevel { columns: 2, column_gap_mm: -320.0, ..ArrayLevel::default() };
        let both = Arrays { job, ..gap(10.0, 20.0) };
        assert!(
            told(both).contains("columns of the job array is -320 mm: it must be above -320 mm")
        );
        // One column has no gap.
        let one = ArrayLevel { columns: 1, column_gap_mm: -500.0, ..two_by_three() };
        assert_eq!(Arrays { block: one, ..Arrays::default() }.check(block), Ok(()));
    }

    #[test]
    fn pro_array_start() {
        let firsts: Vec<_> =
            [Corner::BottomLeft, Corner::BottomRight, Corner::TopRight, Corner::TopLeft]
                .into_iter()
                .map(|start| ArrayLevel { start, ..two_by_three() }.cell(0))
                .collect();
        assert_eq!(firsts, [(0, 0), (0, 2), (1, 2), (1, 0)]);
        assert_eq!(ArrayLevel::default().start, Corner::BottomLeft);
    }

    #[test]
    fn pro_array_two_orders() {
        let inner = ArrayLevel { order: Order::RowSnake, ..two_by_three() };
        let job = ArrayLevel { rows: 2, row_gap_mm: 40.0, ..Default::default() };
        let outer = ArrayLevel { start: Corner::TopLeft, ..job };
        let block = Vec2::new(100.0, 50.0);
        let arrays = Arrays { block: inner, job: outer };
        assert_eq!(arrays.size(block), Vec2::new(320.0, 280.0));
        let places: Vec<_> = arrays.placements(block).collect();
        let xs = [0.0, 110.0, 220.0, 220.0, 110.0, 0.0];
        let ys = [0.0, 0.0, 0.0, 70.0, 70.0, 70.0];
        let rows = |from: f64| xs.into_iter().zip(ys.map(|y| y + from));
        let expected: Vec<_> = rows(160.0).chain(rows(0.0)).map(|(x, y)| Vec2::new(x, y)).collect();
        assert_eq!(places, expected);
    }
}
