//! Reliefs: how bright a picture is becomes how deep the tool goes.
//!
//! ```text
//!  rows from the bottom up, each the other way:     ◄──────────┐
//!                                                   └────────┐ │
//!                                                   ►────────┘
//! ```
//!
//! The tool follows every row at the heights of its dots; dots on one line need one move.

use kerf_geom::Vec2;
use kerf_program::{AXES, Axes, Command, Feed, Line, MoveKind, Printer, Sourced};

/// Three dots lie on one line when the middle one is off it by less, millimetres: less than any machine's
/// step.
const STRAIGHT_MM: f64 = 1e-4;

/// A relief to be cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief<'a> {
    /// Dots of a row.
    pub columns: usize,
    /// Brightness of each dot, 0 black … 1 white, row by row from the top.
    pub grey: &'a [f32],
    /// Distance of the first from the last dot in X and in Y, millimetres.
    pub size: Vec2,
    /// Depth of the deepest dot, millimetres below zero.
    pub depth_mm: f64,
    /// White is deepest, not black.
    pub white_deepest: bool,
    /// Height at which the tool travels, millimetres above zero.
    pub safe_mm: f64,
}

/// Writes the path of a relief. Its lower left dot is at X 0, Y 0.
pub fn print_relief(relief: &Relief, printer: &mut dyn Printer) {
    if relief.columns == 0 || relief.grey.len() < relief.columns {
        return;
    }
    let mut writing = Writing { printer };
    let safe = relief.safe_mm;
    let rows = relief.grey.len() / relief.columns;
    let mut last = [0.0, 0.0, safe];
    writing.go(MoveKind::Jog, last);
    for row in 0..rows {
        let dots = relief.row(row);
        if row == 0 {
            writing.go(MoveKind::Jog, [dots[0][0], dots[0][1], safe]);
        }
        corners(&dots).for_each(|dot| writing.go(MoveKind::Cut, dot));
        last = dots[dots.len() - 1];
    }
    writing.go(MoveKind::Jog, [last[0], last[1], safe]);
    writing.go(MoveKind::Jog, [0.0, 0.0, safe]);
}

impl Relief<'_> {
    /// The places of a row, counted from the bottom; every other runs to the left.
    fn row(&self, row: usize) -> Vec<[f64; 3]> {
        let rows = self.grey.len() / self.columns;
        let start = (rows - 1 - row) * self.columns;
        let step = |size: f64, count: usize| size / (count.max(2) - 1) as f64;
        let (across, up) = (step(self.size.x, self.columns), step(self.size.y, rows));
        let dots = self.grey[start..start + self.columns].iter().enumerate();
        let dot = |(n, grey): (usize, &f32)| [n as f64 * across, row as f64 * up, self.z(*grey)];
        if row.is_multiple_of(2) { dots.map(dot).collect() } else { dots.map(dot).rev().collect() }
    }

    fn z(&self, grey: f32) -> f64 {
        let share = f64::from(grey);
        -self.depth_mm * if self.white_deepest { share } else { 1.0 - share }
    }
}

/// The dots at which a row bends, with its ends.
fn corners(dots: &[[f64; 3]]) -> impl Iterator<Item = [f64; 3]> + '_ {
    let bends = |n: usize| {
        let [a, b, c] = [dots[n - 1], dots[n], dots[n + 1]];
        (a[2] - 2.0 * b[2] + c[2]).abs() > STRAIGHT_MM
    };
    (0..dots.len()).filter(move |n| *n == 0 || *n + 1 == dots.len() || bends(*n)).map(|n| dots[n])
}

struct Writing<'a> {
    printer: &'a mut dyn Printer,
}

impl Writing<'_> {
    fn go(&mut self, kind: MoveKind, to: [f64; 3]) {
        let mut axes = [0.0; AXES];
        axes[..3].copy_from_slice(&to);
        let command = Command::Line(Line { kind, to: Axes(axes), feed: Feed::Axis });
        self.printer.command(&Sourced { at: Default::default(), command });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_go_there_and_back_from_the_bottom() {
        let grey = [0.0, 0.5, 1.0, 1.0, 0.0, 1.0];
        let size = Vec2::new(2.0, 1.0);
        let relief = Relief {
            columns: 3,
            grey: &grey,
            size,
            depth_mm: 4.0,
            white_deepest: false,
            safe_mm: 5.0,
        };
        assert_eq!(relief.row(0), [[0.0, 0.0, 0.0], [1.0, 0.0, -4.0], [2.0, 0.0, 0.0]]);
        let top = relief.row(1);
        assert_eq!(top, [[2.0, 1.0, 0.0], [1.0, 1.0, -2.0], [0.0, 1.0, -4.0]]);
        assert_eq!(corners(&top).count(), 2);
        assert_eq!(corners(&relief.row(0)).count(), 3);
        let turned = Relief { white_deepest: true, ..relief };
        assert_eq!(turned.row(1)[2][2], 0.0);
    }
}
