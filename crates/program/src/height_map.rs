//! Heights of a surface that were probed on a grid: bent or skewed material is cut at an even depth.
//!
//! ```text
//!   y ┤ 0.12   0.05   0.01        a line a place in the file: X, Y, Z in millimetres of the working location,
//!     ┤ 0.10   0.04   0.00        between the places bilinear, beyond the grid as at its edge
//!     └──┴──────┴──────┴── x
//! ```

use serde::{Deserialize, Serialize};

/// Cuts may leave the grid by so much, mm: a cutter that goes round the work runs beside it.
pub const MARGIN_MM: f64 = 5.0;

/// First line of a file of heights.
pub const HEAD: &str = "kerf heights, mm";

/// Most places of a grid.
const MOST: usize = 1_000_000;

/// Places that differ by less are in one row or column, mm.
const SAME_MM: f64 = 1e-3;

/// A grid of heights, mm, working location.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeightMap {
    xs: Vec<f64>,
    ys: Vec<f64>,
    /// Row by row, along X.
    zs: Vec<f64>,
}

impl HeightMap {
    /// Reads a file of heights.
    ///
    /// # Errors
    /// The line, from 1, and what is wrong with it; 0 for the whole file.
    pub fn read(text: &str) -> Result<Self, (usize, String)> {
        let mut lines = text.lines().enumerate().map(|(n, line)| (n + 1, line.trim()));
        if lines.next().is_none_or(|(_, head)| head != HEAD) {
            return Err((1, format!("a file of heights begins with `{HEAD}`")));
        }
        let mut places = Vec::new();
        for (n, line) in lines.filter(|(_, line)| !line.is_empty()) {
            let numbers: Vec<f64> = line
                .split(',')
                .filter_map(|word| word.trim().parse().ok())
                .filter(|v: &f64| v.is_finite())
                .collect();
            let [x, y, z] = numbers[..] else {
                return Err((n, "three numbers expected: X, Y, Z".into()));
            };
            places.push([x, y, z]);
            if places.len() > MOST {
                return Err((n, format!("more than {MOST} places")));
            }
        }
        Self::of(&places).map_err(|why| (0, why))
    }

    /// The grid of these places, in any order.
    fn of(places: &[[f64; 3]]) -> Result<Self, String> {
        let (xs, ys) = (distinct(places, 0), distinct(places, 1));
        if xs.len() < 2 || ys.len() < 2 {
            return Err("a grid has two rows and two columns at least".into());
        }
        let mut zs = vec![None; xs.len() * ys.len()];
        for [x, y, z] in places {
            let place = nearest(&ys, *y) * xs.len() + nearest(&xs, *x);
            zs[place] = Some(*z);
        }
        let found = zs.iter().flatten().count();
        let all: Option<Vec<f64>> = zs.into_iter().collect();
        let missing = || {
            format!(
                "{} of {} places of the grid are missing",
                xs.len() * ys.len() - found,
                xs.len() * ys.len()
            )
        };
        let zs = all.ok_or_else(missing)?;
        Ok(Self { xs, ys, zs })
    }

    /// The height at a place, mm; beyond the grid that of its edge.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let (column, across) = cell(&self.xs, x);
        let (row, along) = cell(&self.ys, y);
        let z = |row: usize, column: usize| self.zs[row * self.xs.len() + column];
        let between = |row: usize| z(row, column) * (1.0 - across) + z(row, column + 1) * across;
        between(row) * (1.0 - along) + between(row + 1) * along
    }

    /// Distance of a place from the grid, mm: the larger of those along X and Y.
    pub fn outside_mm(&self, x: f64, y: f64) -> f64 {
        let beyond = |grid: &[f64], at: f64| (grid[0] - at).max(at - grid[grid.len() - 1]).max(0.0);
        beyond(&self.xs, x).max(beyond(&self.ys, y))
    }

    /// Lowest and highest X and Y, mm.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let ends = |grid: &[f64]| [grid[0], grid[grid.len() - 1]];
        let ([x0, x1], [y0, y1]) = (ends(&self.xs), ends(&self.ys));
        [[x0, y0], [x1, y1]]
    }

    /// Shares 0 … 1 of a straight way at which it goes from one cell into another.
    pub fn crossings(&self, from: [f64; 2], to: [f64; 2]) -> Vec<f64> {
        let along = |grid: &[f64], a: f64, b: f64| -> Vec<f64> {
            let share = |at: &f64| (at - a) / (b - a);
            grid.iter().map(share).filter(|share| *share > 0.0 && *share < 1.0).collect()
        };
        let mut shares = along(&self.xs, from[0], to[0]);
        shares.extend(along(&self.ys, from[1], to[1]));
        shares.sort_by(f64::total_cmp);
        shares
    }

    /// Columns, rows and heights row by row.
    pub fn grid(&self) -> (&[f64], &[f64], &[f64]) {
        (&self.xs, &self.ys, &self.zs)
    }
}

/// The values of an axis, each once, in order.
fn distinct(places: &[[f64; 3]], axis: usize) -> Vec<f64> {
    let mut all: Vec<f64> = places.iter().map(|place| place[axis]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|b, a| *b - *a < SAME_MM);
    all
}

/// Index of the nearest value.
fn nearest(grid: &[f64], at: f64) -> usize {
    let after = grid.partition_point(|v| *v < at);
    match after {
        0 => 0,
        n if n == grid.len() => n - 1,
        n if at - grid[n - 1] < grid[n] - at => n - 1,
        n => n,
    }
}

/// The cell of a value, and its share of that, 0 … 1.
fn cell(grid: &[f64], at: f64) -> (usize, f64) {
    let index = grid.partition_point(|v| *v <= at).clamp(1, grid.len() - 1) - 1;
    let share = (at - grid[index]) / (grid[index + 1] - grid[index]);
    (index, share.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "kerf heights, mm\n0,0,1\n10,0,2\n\n0,20,3\n10,20,8\n";

    #[test]
    fn heights_between_places_are_bilinear_and_beyond_them_those_of_the_edge() {
        let map = HeightMap::read(FILE).expect("a grid");
        for ([x, y], z) in [
            ([0.0, 0.0], 1.0),
            ([10.0, 20.0], 8.0),
            ([5.0, 0.0], 1.5),
            ([5.0, 10.0], 3.5),
            ([2.5, 5.0], 0.75 * (0.75 + 0.5) + 0.25 * (0.75 * 3.0 + 0.25 * 8.0)),
            ([-3.0, -3.0], 1.0),
            ([30.0, 10.0], 5.0),
        ] {
            assert!((map.at(x, y) - z).abs() < 1e-12, "{x},{y}: {} is not {z}", map.at(x, y));
        }
        assert_eq!([map.outside_mm(5.0, 5.0), map.outside_mm(12.0, -3.0)], [0.0, 3.0]);
        assert_eq!(map.crossings([-10.0, 10.0], [30.0, 10.0]), [0.25, 0.5]);
    }

    #[test]
    fn files_that_are_no_grid_are_refused() {
        for (text, line, why) in [
            ("0,0,1\n", 1, "begins with"),
            ("kerf heights, mm\n0,0\n", 2, "three numbers"),
            ("kerf heights, mm\n0,0,nan\n", 2, "three numbers"),
            ("kerf heights, mm\n0,0,1\n1,0,1\n", 0, "two rows"),
            ("kerf heights, mm\n0,0,1\n1,0,1\n0,1,1\n", 0, "1 of 4 places"),
        ] {
            let (at, told) = HeightMap::read(text).expect_err("no grid");
            assert!(at == line && told.contains(why), "{at} {told}");
        }
    }
}
