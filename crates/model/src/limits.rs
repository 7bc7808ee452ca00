//! Table limits (command reference, VL and SF), checked before a stack of moves starts.

use kerf_motion::Move;
use kerf_program::settings::Limits;
use kerf_program::{AXES, Axes, Axis};
use std::collections::BTreeSet;

/// Limits that the operator has overridden.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Overridden {
    /// The table and the lengths of the axes.
    pub table: bool,
    /// Limit switches, by their inputs.
    pub switches: BTreeSet<u8>,
}

/// A move would leave the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// Index of the first such move.
    pub move_index: usize,
    /// The axis.
    pub axis: Axis,
    /// Farthest value it would reach, table base coordinates; of a soft bound machine coordinates.
    pub reached: f64,
    /// The limit, in the same coordinates.
    pub limit: f64,
    /// It is the end of an axis, not of the table.
    pub soft: bool,
}

/// Slack for rounding, mm or degrees: a thousandth of a step of any machine.
const SLACK: f64 = 1e-6;

/// The first move whose path leaves the limits. `axes` is how many axes the machine has.
pub fn first_outside(
    moves: &[Move],
    base_zero: Axes,
    limits: &Limits,
    axes: usize,
) -> Option<Violation> {
    moves.iter().enumerate().find_map(|(move_index, made)| {
        let (low, high) = extent(made);
        Axis::ALL.into_iter().take(axes.min(AXES)).find_map(|axis| {
            let zero = base_zero[axis];
            // Where a move starts is not its fault: it may lead back to the table.
            let starts = |value: f64| (made.from[axis] - value).abs() <= SLACK;
            let outside = |reached: f64, limit| {
                let reached = reached - zero;
                Some(Violation { move_index, axis, reached, limit, soft: false })
            };
            let (bottom, top) = (limits.low[axis], limits.high[axis]);
            if low[axis] - zero < bottom - SLACK && !starts(low[axis]) {
                outside(low[axis], bottom)
            } else if high[axis] - zero > top + SLACK && !starts(high[axis]) {
                outside(high[axis], top)
            } else {
                None
            }
        })
    })
}

/// The first move whose path leaves the lengths of the axes, which are counted from home.
pub fn first_out_of_bounds(
    moves: &[Move],
    bounds: &[Option<(f64, f64)>; AXES],
) -> Option<Violation> {
    if bounds.iter().all(Option::is_none) {
        return None;
    }
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let ends = bounds.map(|bound| bound.unwrap_or(free));
    let (low, high) = (Axes(ends.map(|end| end.0)), Axes(ends.map(|end| end.1)));
    let found = first_outside(moves, Axes::default(), &Limits { low, high, check: true }, AXES);
    found.map(|violation| Violation { soft: true, ..violation })
}

/// Lowest and highest value of each axis on the way, the bulge of arcs included.
fn extent(made: &Move) -> (Axes, Axes) {
    let mut low = made.from.zip(made.to, f64::min);
    let mut high = made.from.zip(made.to, f64::max);
    if let Some(arc) = made.arc() {
        arc.extremes(|p| {
            for (i, v) in [p.x, p.y].into_iter().enumerate() {
                low.0[i] = low.0[i].min(v);
                high.0[i] = high.0[i].max(v);
            }
        });
    }
    (low, high)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_motion::Mover;
    use kerf_program::{Arc, At, Feed, Line, MoveKind, Settings};

    fn limits() -> Limits {
        Limits { low: Axes::xyz(0.0, 0.0, -10.0), high: Axes::xyz(100.0, 50.0, 10.0), check: true }
    }

    fn line(from: Axes, to: Axes) -> Move {
        let line = Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
        Mover::new(from, &Settings::default()).line(At::default(), &line).unwrap()
    }

    fn arc(from: Axes, centre: [f64; 2], sweep_rad: f64, to: Axes) -> Move {
        let kind = MoveKind::Cut;
        let arc = Arc { kind, centre, sweep_rad, to, feed: Feed::Axis, chords: 8, small: false };
        Mover::new(from, &Settings::default()).arc(At::default(), &arc).unwrap()
    }

    fn check(made: Move, base_zero: Axes, expected: Option<(Axis, f64)>) {
        let found = first_outside(&[made], base_zero, &limits(), 3);
        assert_eq!(found.map(|v| (v.axis, (v.reached * 1e6).round() / 1e6)), expected);
    }

    #[test]
    fn the_end_of_a_move_counts_in_base_coordinates() {
        let here = Axes::default();
        check(line(here, Axes::xyz(100.0, 0.0, 0.0)), here, None);
        check(line(here, Axes::xyz(101.0, 0.0, 0.0)), here, Some((Axis::X, 101.0)));
        let base = Axes::xyz(-5.0, 0.0, 0.0);
        check(line(here, Axes::xyz(96.0, 0.0, 0.0)), base, Some((Axis::X, 101.0)));
        check(line(here, Axes::xyz(0.0, 0.0, -11.0)), here, Some((Axis::Z, -11.0)));
    }

    #[test]
    fn the_bulge_of_an_arc_counts() {
        let (from, to) = (Axes::xyz(80.0, 10.0, 0.0), Axes::xyz(80.0, 40.0, 0.0));
        let half = std::f64::consts::PI;
        check(arc(from, [80.0, 25.0], half, to), Axes::default(), None);
        let (from, to) = (Axes::xyz(90.0, 10.0, 0.0), Axes::xyz(90.0, 40.0, 0.0));
        check(arc(from, [90.0, 25.0], half, to), Axes::default(), Some((Axis::X, 105.0)));
        check(arc(from, [90.0, 25.0], -half, to), Axes::default(), None);
    }

    #[test]
    fn a_move_back_to_the_table_is_allowed() {
        let outside = Axes::xyz(-20.0, 10.0, 0.0);
        check(line(outside, Axes::xyz(5.0, 10.0, 0.0)), Axes::default(), None);
        let farther = Axes::xyz(-21.0, 10.0, 0.0);
        check(line(outside, farther), Axes::default(), Some((Axis::X, -21.0)));
    }
}
